// SPDX-License-Identifier: MIT
// What `steradian render` was asked for.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace steradian::cli {

struct RenderOptions {
  std::filesystem::path input;
  std::vector<std::filesystem::path> outputs;
  std::string size, camera, tonemapper, device, samples, aov;
  std::optional<int> bounces;
  std::optional<std::uint32_t> seed;
  std::optional<float> exposure;               // stops
  std::vector<std::string> parameters, until;  // as typed
  std::optional<std::int64_t> frame;
  std::optional<double> time;  // seconds
  std::optional<std::uint64_t> spp;
  bool noMeter = false, generic = false;
  std::vector<std::filesystem::path> pluginPath;
  std::filesystem::path report;
};

}  // namespace steradian::cli
