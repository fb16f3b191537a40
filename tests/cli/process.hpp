// SPDX-License-Identifier: MIT
// Starts the built binary and looks at what it did, as a shell would.
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace process {

using Arguments = std::vector<std::string>;
/// Name and value; an empty value unsets.
using Environment = std::vector<std::pair<std::string, std::string>>;

struct Outcome {
  int exitCode = -1;  // 128 + signal when a signal ended it
  std::string out, err;
};

/// A folder of its own for a test, removed at the end; the output of runs is caught in it.
class Sandbox {
 public:
  Sandbox();
  ~Sandbox();
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  /// Runs a copy at `path` from now on: without the modules that lie beside the built one.
  void moveBinary(const std::filesystem::path& path);
  Outcome run(const Arguments& arguments, const Environment& environment = {}) const;
  pid_t start(const Arguments& arguments, const Environment& environment = {}) const;
  Outcome wait(pid_t child) const;

 private:
  std::filesystem::path folder_, binary_;
};

std::string contents(const std::filesystem::path& path);
std::string project(const std::string& name);  // path of one of the shipped projects
/// Number of lines in `text`.
int lines(const std::string& text);

}  // namespace process
