// SPDX-License-Identifier: MIT
// One plugin file opened in this process.
#pragma once
#include <filesystem>
#include <vector>

#include "steradian/plugin.hpp"

namespace steradian::plugins {

/// Stays mapped until the process ends: static objects of the plugin may be in use anywhere.
struct Library {
  std::vector<sdk::ImporterInterface*> importers;
  std::vector<sdk::ExporterInterface*> exporters;
};

/// Runs the file's static initialisers. Throws std::runtime_error with dlerror's text or the version
/// mismatch.
Library openLibrary(const std::filesystem::path& file);

}  // namespace steradian::plugins
