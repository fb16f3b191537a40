// SPDX-License-Identifier: MIT
// Signals end a render early; what was finished is a file, and the exit code says which signal it was.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "process.hpp"

using namespace process;

namespace {

/// Waits until the render runs: it prints plain progress lines to a stderr that is no terminal.
bool waitForProgress(const Sandbox& sandbox) {
  for (int i = 0; i < 600; ++i) {
    if (contents(sandbox.path("stderr")).find("samples") != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

}  // namespace

TEST(Interruption, leaves_a_partial_file_and_the_exit_code_of_the_signal) {
  for (const auto& [signal, exitCode] :
       {std::pair(SIGINT, 130), std::pair(SIGTERM, 143), std::pair(SIGHUP, 129)}) {
    const Sandbox sandbox;
    const pid_t child = sandbox.start(
        {"render", project("hello"), "-o", sandbox.path("a.exr"), "--size", "64x48", "--until", "time=300s"});
    const bool running = waitForProgress(sandbox);
    kill(child, signal);
    const Outcome outcome = sandbox.wait(child);
    ASSERT_TRUE(running) << outcome.err;
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
    const Outcome info = sandbox.run({"info", sandbox.path("a.exr")});
    EXPECT_NE(info.out.find("steradian:partial: yes"), std::string::npos) << info.out << info.err;
  }
}
