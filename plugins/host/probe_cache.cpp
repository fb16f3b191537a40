// SPDX-License-Identifier: MIT
// Remembers the descriptions of plugins that passed the probe, by path, modification time and size.
#include "plugins/host/probe_cache.hpp"

#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "plugins/host/atomic_file.hpp"
#include "plugins/host/description.hpp"

namespace steradian::plugins {

namespace fs = std::filesystem;
using nlohmann::json;

struct ProbeCache::Entries {
  json files = json::object();
  bool changed = false;
};

namespace {

fs::path cacheFile() {
  if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && xdg[0] == '/')
    return fs::path(xdg) / "steradian/plugins.json";
  const char* home = std::getenv("HOME");
  return home && home[0] == '/' ? fs::path(home) / ".cache/steradian/plugins.json" : fs::path();
}

/// What must be the same for an entry to count; it changes with the interface too.
json stampOf(const fs::path& file) {
  struct stat s {};
  if (stat(file.c_str(), &s) != 0) return nullptr;
  return {std::uint64_t(s.st_mtim.tv_sec),
          std::uint64_t(s.st_mtim.tv_nsec),
          std::uint64_t(s.st_size),
          std::uint64_t(s.st_ino),
          sdk::kMajor,
          sdk::kMinor};
}

}  // namespace

ProbeCache::ProbeCache() : entries_(std::make_unique<Entries>()) {
  std::ifstream stream(cacheFile(), std::ios::binary);
  json read = json::parse(stream, nullptr, false);
  if (read.is_object()) entries_->files = std::move(read);
}

ProbeCache::~ProbeCache() = default;

std::optional<std::vector<Contribution>> ProbeCache::find(const fs::path& file) const try {
  const auto entry = entries_->files.find(file.string());
  if (entry == entries_->files.end() || entry->at("stamp") != stampOf(file)) return std::nullopt;
  return contributionsFromJson(entry->at("contributions"));
} catch (const json::exception&) {
  return std::nullopt;
}

void ProbeCache::remember(const fs::path& file, const std::vector<Contribution>& contributions) {
  entries_->files[file.string()] = {{"stamp", stampOf(file)}, {"contributions", toJson(contributions)}};
  entries_->changed = true;
}

void ProbeCache::save() const try {
  const fs::path file = cacheFile();
  if (!entries_->changed || file.empty()) return;
  std::error_code none;
  fs::create_directories(file.parent_path(), none);
  for (auto it = entries_->files.begin(); it != entries_->files.end();)
    it = fs::exists(it.key(), none) ? std::next(it) : entries_->files.erase(it);
  const std::string text = entries_->files.dump(1, ' ', false, json::error_handler_t::replace);
  writeFileAtomically(file, text);
} catch (const Error&) {
  // A full or read-only cache folder only means that the next start probes again.
}

}  // namespace steradian::plugins
