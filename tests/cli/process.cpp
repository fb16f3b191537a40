// SPDX-License-Identifier: MIT
// Processes and their output.
#include "process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace process {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> environmentWith(const Environment& changes) {
  std::vector<std::string> variables;
  const auto changed = [&](const std::string& variable) {
    return std::any_of(changes.begin(), changes.end(),
                       [&](const auto& change) { return variable.rfind(change.first + "=", 0) == 0; });
  };
  for (char** variable = environ; *variable; ++variable)
    if (!changed(*variable)) variables.emplace_back(*variable);
  for (const auto& [name, value] : changes)
    if (!value.empty()) variables.push_back(name + "=" + value);
  return variables;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> out;
  for (std::string& string : strings) out.push_back(string.data());
  out.push_back(nullptr);
  return out;
}

}  // namespace

Sandbox::Sandbox() {
  std::string name = (fs::temp_directory_path() / "steradian-cli-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("mkdtemp failed");
  folder_ = name;
  binary_ = STERADIAN_BINARY;
}

Sandbox::~Sandbox() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Sandbox::moveBinary(const fs::path& path) {
  fs::copy_file(binary_, path);
  binary_ = path;
}

pid_t Sandbox::start(const Arguments& arguments, const Environment& environment) const {
  std::vector<std::string> command{binary_.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = environmentWith(environment);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::string out = path("stdout").string(), err = path("stderr").string();
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const int failure = posix_spawn(&child, command[0].c_str(), &actions, nullptr, pointers(command).data(),
                                  pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failure) throw std::runtime_error("cannot start " + command[0]);
  return child;
}

Outcome Sandbox::wait(pid_t child) const {
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contents(path("stdout")),
          contents(path("stderr"))};
}

Outcome Sandbox::run(const Arguments& arguments, const Environment& environment) const {
  return wait(start(arguments, environment));
}

std::string contents(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string project(const std::string& name) {
  return std::string(STERADIAN_PROJECTS) + "/" + name;
}

int lines(const std::string& text) {
  return int(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace process
