// SPDX-License-Identifier: MIT
// Replaces a file so that at every instant, also after SIGKILL or a power cut, it is whole: the old or the
// new.
#pragma once
#include <filesystem>
#include <string_view>

#include "renderer/scene/error.hpp"

namespace steradian::plugins {

/// Temporary sibling (O_EXCL) -> write -> fsync -> rename -> fsync of the folder. A symbolic link is written
/// through; mode and owner are kept. Sweeps what a killed writer left in the folder. Any thread.
/// Throws Error(io) naming file, cause and remedy; the old file stays and the temporary one is removed.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace steradian::plugins
