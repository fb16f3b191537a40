// SPDX-License-Identifier: MIT
// Reads a whole regular file, and nothing that could block or never end.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace steradian::plugins {

/// Throws Error(badInput) when it is absent, not a regular file or longer than `maxBytes` (checked before a
/// byte is read), Error(io) when reading fails.
std::string readFile(const std::filesystem::path& path, std::uint64_t maxBytes);

}  // namespace steradian::plugins
