// SPDX-License-Identifier: MIT
// Signals end a render early; what was finished is a file, and the exit code says which signal it was.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
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

/// Glass: the samples are far apart in size.
TEST(Interruption, a_part_that_was_interrupted_and_resumed_gives_the_same_bytes) {
  const Sandbox sandbox;
  const auto part = [&](const std::string& samples, const std::string& name) {
    return Arguments{"render",    project("glass"), "--size", "32x24",
                     "--samples", samples,          "-o",     sandbox.path(name)};
  };
  const pid_t child = sandbox.start(part("0:1000000", "begun.exr"));
  const bool running = waitForProgress(sandbox);
  kill(child, SIGINT);
  ASSERT_EQ(sandbox.wait(child).exitCode, 130);
  ASSERT_TRUE(running);
  const auto info = nlohmann::json::parse(sandbox.run({"info", sandbox.path("begun.exr"), "--json"}).out);
  const int done = std::stoi(info["metadata"]["steradian:samples"].get<std::string>());
  const std::string end = std::to_string(done + 8);
  const std::pair<std::string, std::string> others[] = {
      {std::to_string(done) + ":" + end, "resumed.exr"}, {"0:3", "a.exr"}, {"3:" + end, "b.exr"}};
  for (const auto& [samples, name] : others) ASSERT_EQ(sandbox.run(part(samples, name)).exitCode, 0);
  const auto merged = [&](const std::string& first, const std::string& second) {
    const Outcome outcome =
        sandbox.run({"merge", sandbox.path(first), sandbox.path(second), "-o", sandbox.path("merged.exr")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return contents(sandbox.path("merged.exr"));
  };
  EXPECT_TRUE(merged("begun.exr", "resumed.exr") == merged("a.exr", "b.exr")) << done << " samples were done";
}
