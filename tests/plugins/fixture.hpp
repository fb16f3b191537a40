// SPDX-License-Identifier: MIT
// A folder of its own for each test, with its own cache, removed afterwards.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "plugins/host/plugin_host.hpp"
#include "tests/temporary_folder.hpp"

namespace steradian::plugins {

namespace fs = std::filesystem;

inline void writeText(const fs::path& path, std::string_view text) {
  std::ofstream(path, std::ios::binary).write(text.data(), std::streamsize(text.size()));
}

inline std::string readText(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

class FolderTest : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
    fs::create_directory(folder / "plugins");
  }

  /// Copies a sample plugin into this test's plugin folder.
  fs::path add(const std::string& sample, const std::string& as = {}) {
    const fs::path to = folder / "plugins" / (as.empty() ? sample + ".so" : as);
    fs::copy_file(fs::path(SAMPLE_PLUGINS) / (sample + ".so"), to);
    return to;
  }
  PluginHost host() const { return PluginHost({folder / "plugins"}); }
};

/// The stock plugins, found once per test program.
inline const PluginHost& stockPlugins() {
  static const PluginHost host({STOCK_PLUGINS});
  return host;
}

/// The message and code of the Error that `work` throws; empty when it throws none.
template <class Work>
std::pair<std::string, ExitCode> faultOf(Work&& work) {
  try {
    work();
  } catch (const Error& error) {
    return {error.what(), error.code()};
  }
  return {{}, ExitCode::ok};
}

#define EXPECT_CONTAINS(text, part) \
  EXPECT_NE(std::string(text).find(part), std::string::npos) << "in: " << (text) << "\nlooked for: " << (part)

}  // namespace steradian::plugins
