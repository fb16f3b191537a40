// SPDX-License-Identifier: MIT
// Remembers the descriptions of plugins that passed the probe, by path, modification time and size.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "plugins/host/plugin_host.hpp"

namespace steradian::plugins {

/// $XDG_CACHE_HOME/steradian/plugins.json. A missing, damaged or unwritable cache only costs time.
class ProbeCache {
 public:
  ProbeCache();
  ~ProbeCache();
  ProbeCache(const ProbeCache&) = delete;
  ProbeCache& operator=(const ProbeCache&) = delete;

  std::optional<std::vector<Contribution>> find(const std::filesystem::path& file) const;
  void remember(const std::filesystem::path& file, const std::vector<Contribution>& contributions);
  void save() const;  // when something was remembered

 private:
  struct Entries;
  std::unique_ptr<Entries> entries_;
};

}  // namespace steradian::plugins
