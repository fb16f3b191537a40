// SPDX-License-Identifier: MIT
// Reads a plugin's version from its ELF note without running any of its code.
#pragma once
#include <filesystem>
#include <string>

namespace steradian::plugins {

/// Why this host must not open the file as a plugin; empty = it may. Any thread; never throws on file
/// contents.
std::string reasonNotLoadable(const std::filesystem::path& file);

/// Why these numbers of a note or an entry do not fit this host; empty = they fit.
std::string interfaceMismatch(std::uint32_t magic, std::uint32_t major, std::uint32_t minor,
                              std::uint32_t size);

}  // namespace steradian::plugins
