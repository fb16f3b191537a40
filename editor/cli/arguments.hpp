// SPDX-License-Identifier: MIT
// Values of options, read strictly. Everything throws Error(usage) with what was expected.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "renderer/renderer.hpp"
#include "renderer/still.hpp"

namespace steradian::cli {

Extent parseSize(const std::string& text);  // "1280x720", each 1..16384

/// "12:48": first sample index and the one after the last.
std::pair<std::uint64_t, std::uint64_t> parseSampleRange(const std::string& text);

/// Adds "rel=1%", "rel=0.01", "time=30s", "time=2m" or "time=1h" to `request`; of two of a kind, the one met
/// first counts.
void parseUntil(const std::string& text, StillRequest& request);

/// For CLI11's check(): nothing when `text` is a number above 0, else what is wrong with it.
std::string aboveZero(const std::string& text);

std::pair<std::string, double> parseParameter(const std::string& text);  // "white=4"

}  // namespace steradian::cli
