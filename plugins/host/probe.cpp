// SPDX-License-Identifier: MIT
// Opens an unknown plugin in a child process first. The child dlopens it, lets it register, and sends its
// description through a pipe; a crash, an exit() or a hang shows as a missing description.
#include "plugins/host/probe.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "plugins/host/description.hpp"
#include "plugins/host/library.hpp"

namespace steradian::plugins {

namespace {

constexpr std::size_t kLongestAnswer = 1 << 20;

nlohmann::json answerFor(const std::filesystem::path& file) try {
  return {{"contributions", toJson(describe(openLibrary(file)))}};
} catch (const std::exception& error) {
  return {{"reason", error.what()}};
}

/// What the plugin prints while it is probed is not the user's business; a crash leaves no core file.
void isolateChild(std::chrono::seconds ownTime) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit none{0, 0}, busy{rlim_t(ownTime.count()), rlim_t(ownTime.count()) + 1};
  setrlimit(RLIMIT_CORE, &none);
  setrlimit(RLIMIT_CPU, &busy);  // the kernel ends a loop: SIGXCPU, a second later SIGKILL
  for (int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGXCPU})
    ::signal(signal, SIG_DFL);
  const int sink = open("/dev/null", O_RDWR);
  for (int fd = 0; fd <= 2 && sink >= 0; ++fd) dup2(sink, fd);
}

[[noreturn]] void runChild(const std::filesystem::path& file, const ProbeLimits& limits, int pipe) {
  isolateChild(limits.ownTime);
  const std::string answer = answerFor(file).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  for (std::size_t sent = 0; sent < answer.size();) {
    const ssize_t n = write(pipe, answer.data() + sent, answer.size() - sent);
    if (n <= 0) break;
    sent += std::size_t(n);
  }
  _exit(0);  // no static destructors: the parent's are not ours to run
}

/// All that arrives before end of file; false when the deadline passes first.
bool readAll(int fd, std::chrono::milliseconds patience, std::string& out) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + patience;
  char buffer[4096];
  while (out.size() < kLongestAnswer) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd ready{fd, POLLIN, 0};
    const int polled = left > 0 ? poll(&ready, 1, int(left)) : 0;
    if (polled < 0 && errno == EINTR) continue;
    if (polled <= 0) return false;
    const ssize_t n = read(fd, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return true;
    out.append(buffer, std::size_t(n));
  }
  return false;
}

std::string reasonFrom(int status, const ProbeLimits& limits) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return "did not finish loading within " + std::to_string(limits.ownTime.count()) + " s of processor time";
  if (WIFSIGNALED(status)) return std::string("crashed while it was probed: ") + strsignal(WTERMSIG(status));
  return "ended the process while it was probed (exit code " + std::to_string(WEXITSTATUS(status)) + ")";
}

}  // namespace

Probe::Probe(const std::filesystem::path& file, ProbeLimits limits) : limits_(limits) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    startFault_ = std::string("cannot be probed: ") + std::strerror(errno);
    return;
  }
  child_ = fork();
  if (child_ == 0) runChild(file, limits, ends[1]);
  if (child_ < 0) startFault_ = std::string("cannot be probed: ") + std::strerror(errno);
  close(ends[1]);
  pipe_ = ends[0];
}

Probe::Probe(Probe&& other) noexcept
    : limits_(other.limits_),
      child_(std::exchange(other.child_, -1)),
      pipe_(std::exchange(other.pipe_, -1)),
      startFault_(std::move(other.startFault_)) {}

Probe::~Probe() {
  if (pipe_ >= 0) close(pipe_);
  if (child_ <= 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

ProbeResult Probe::collect() {
  if (!startFault_.empty()) return {startFault_, {}};
  std::string answer;
  const bool finished = readAll(pipe_, limits_.patience, answer);
  if (!finished) kill(child_, SIGKILL);
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  if (!finished)
    return {"did not finish loading within " + std::to_string(limits_.patience.count() / 1000) + " s", {}};
  const auto json = nlohmann::json::parse(answer, nullptr, false);
  if (!json.is_object() || !WIFEXITED(status)) return {reasonFrom(status, limits_), {}};
  if (json.contains("reason")) return {json["reason"].get<std::string>(), {}};
  return {{}, contributionsFromJson(json.at("contributions"))};
}

}  // namespace steradian::plugins
