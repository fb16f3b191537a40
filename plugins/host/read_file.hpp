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

/// `name` as a path inside `folder`, symbolic links followed; the file need not exist. Throws Error(badInput)
/// for an absolute name and for one that leads out.
std::filesystem::path insideFolder(const std::filesystem::path& folder, const std::string& name);

}  // namespace steradian::plugins
