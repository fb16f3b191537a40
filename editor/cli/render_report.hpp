// SPDX-License-Identifier: MIT
// The JSON that `steradian render --report` writes.
#pragma once
#include <filesystem>
#include <string>

#include "renderer/renderer.hpp"

namespace steradian::cli {

struct RenderReport {
  DeviceDescription device;
  Extent film;
  std::uint64_t sampleBegin = 0;
  // Wall time. load, firstPixel and total count from the start of the process.
  double loadSeconds = 0.0, firstPixelSeconds = 0.0, traceSeconds = 0.0, totalSeconds = 0.0;
  int validationMessages = 0;
  RenderStats stats;
};

std::string reportText(const RenderReport& report);
/// Throws Error(io) when the file cannot be written whole.
void writeReport(const RenderReport& report, const std::filesystem::path& path);

}  // namespace steradian::cli
