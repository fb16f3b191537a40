// SPDX-License-Identifier: MIT
// What drivers and we keep of compiled shaders, moved out of the way for a cold start.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace steradian::bench {

/// An empty folder for every cache (ours, Mesa's, NVIDIA's); removed with everything in it.
class CacheFolder {
 public:
  /// Throws Error(io).
  CacheFolder();
  ~CacheFolder();
  CacheFolder(const CacheFolder&) = delete;
  CacheFolder& operator=(const CacheFolder&) = delete;

  /// This process's environment with all caches moved into the folder.
  std::vector<std::string> environment() const;
  /// For this process itself, before it opens a device.
  void use() const;

 private:
  std::filesystem::path path_;
};

}  // namespace steradian::bench
