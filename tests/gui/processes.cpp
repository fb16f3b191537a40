// SPDX-License-Identifier: MIT
#include "tests/gui/processes.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace steradian::test {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

[[noreturn]] void become(const std::vector<std::string>& command, const Process::Environment& more,
                         const fs::path& folder, const fs::path& output) {
  for (const auto& [name, value] : more) setenv(name.c_str(), value.c_str(), 1);
  const int file = open(output.empty() ? "/dev/null" : output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  if (folder.empty() || chdir(folder.c_str()) == 0) execvp(arguments[0], arguments.data());
  _exit(127);
}

/// The display number that Xvfb writes into `file` once it accepts clients.
std::string awaitDisplay(const fs::path& file, Process& server) {
  for (int i = 0; i < 200; ++i) {
    std::ifstream in(file);
    std::string number;
    if (std::getline(in, number) && !in.eof()) return ":" + number;
    if (!server.running()) break;
    std::this_thread::sleep_for(50ms);
  }
  throw std::runtime_error("Xvfb did not start; is the package xvfb installed?");
}

/// A window mapped while the manager starts may never be shown, and GLFW 3.3.8 then waits for ever.
void awaitWindowManager(const fs::path& ready, Process& manager) {
  for (int i = 0; i < 400; ++i) {
    if (fs::exists(ready)) return;
    if (!manager.running()) break;
    std::this_thread::sleep_for(50ms);
  }
  throw std::runtime_error("the window manager did not start; is the package openbox installed?");
}

std::uint32_t bigEndian(const unsigned char* p) {
  return std::uint32_t(p[0]) << 24 | std::uint32_t(p[1]) << 16 | std::uint32_t(p[2]) << 8 | p[3];
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const Environment& more, const fs::path& folder,
                 const fs::path& output) {
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("fork failed");
  if (pid_ == 0) become(command, more, folder, output);
}

bool Process::running() {
  return !wait(0s);
}

std::optional<int> Process::wait(std::chrono::seconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!status_) {
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_)
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    else if (std::chrono::steady_clock::now() >= end)
      return std::nullopt;
    else
      std::this_thread::sleep_for(20ms);
  }
  return status_;
}

Process::~Process() {
  if (status_) return;
  kill(pid_, SIGTERM);
  if (wait(5s)) return;
  kill(pid_, SIGKILL);
  wait(5s);
}

Screen::Screen(const fs::path& folder, int width, int height) : folder_(folder) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
  const fs::path number = folder / "display";
  // Xvfb writes its number to a descriptor; a shell turns that into a file.
  const std::string start = "exec Xvfb -displayfd 3 -screen 0 " + size + " -fbdir '" + folder.string() +
                            "' -nolisten tcp 3>'" + number.string() + "'";
  server_.emplace(std::vector<std::string>{"sh", "-c", start}, Process::Environment{}, folder,
                  folder / "xvfb.log");
  display_ = awaitDisplay(number, *server_);
  const fs::path ready = folder / "openbox-is-ready";
  windowManager_.emplace(std::vector<std::string>{"openbox", "--startup", "touch '" + ready.string() + "'"},
                         Process::Environment{{"DISPLAY", display_}}, folder, folder / "openbox.log");
  awaitWindowManager(ready, *windowManager_);
}

Image Screen::read() const {
  // The frame buffer file is in XWD format (XWDFile.h): a header of big-endian words, a colour map, pixels.
  std::ifstream in(folder_ / "Xvfb_screen0", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto word = [&](int i) { return bigEndian(data + 4 * i); };
  if (bytes.size() < 100 || word(11) != 32) throw std::runtime_error("the screen cannot be read");
  const std::size_t start = word(0) + std::size_t(12) * word(19), stride = word(12);
  const bool littleEndian = word(7) == 0;
  Image image{int(word(4)), int(word(5)), 3, {}};
  image.pixels.resize(std::size_t(image.width) * image.height * 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const unsigned char* pixel = data + start + y * stride + std::size_t(4) * x;
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = float(pixel[littleEndian ? 2 - c : 1 + c]) / 255.0f;
    }
  return image;
}

}  // namespace steradian::test
