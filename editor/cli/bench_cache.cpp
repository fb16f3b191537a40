// SPDX-License-Identifier: MIT
// One variable for each cache.
#include "editor/cli/bench_cache.hpp"

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "renderer/scene/error.hpp"

namespace steradian::bench {

namespace fs = std::filesystem;

namespace {

constexpr const char* kCaches[] = {"XDG_CACHE_HOME", "MESA_SHADER_CACHE_DIR", "__GL_SHADER_DISK_CACHE_PATH"};

bool names(const char* variable, const char* cache) {
  const std::size_t length = std::strlen(cache);
  return std::strncmp(variable, cache, length) == 0 && variable[length] == '=';
}

}  // namespace

CacheFolder::CacheFolder() {
  std::string name = (fs::temp_directory_path() / "steradian-bench-XXXXXX").string();
  if (!mkdtemp(name.data())) throw Error(ExitCode::io, name + ": cannot be created: " + std::strerror(errno));
  path_ = name;
}

CacheFolder::~CacheFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> CacheFolder::environment() const {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable; ++variable) {
    bool cache = false;
    for (const char* name : kCaches) cache = cache || names(*variable, name);
    if (!cache) variables.emplace_back(*variable);
  }
  for (const char* name : kCaches) variables.push_back(std::string(name) + "=" + path_.string());
  return variables;
}

void CacheFolder::use() const {
  for (const char* name : kCaches) setenv(name, path_.c_str(), 1);
}

}  // namespace steradian::bench
