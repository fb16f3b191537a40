// SPDX-License-Identifier: MIT
// A mesh as the bytes of a .mesh file beside the project; README.md describes them.
#pragma once
#include <steradian/plugin.hpp>
#include <string>
#include <string_view>

namespace project {

std::string meshBytes(const steradian::sdk::MeshRecord& mesh);

/// The record's arrays point into `bytes`; id and name are left as they are. Throws BadInput with the cause
/// when the bytes are no mesh, or more or fewer than the counts say; the indices are not looked at.
steradian::sdk::MeshRecord meshFrom(std::string_view bytes);

/// The 64-bit FNV-1a hash (Fowler, Noll, Vo 1991) as 16 hexadecimal digits: how files are named by their
/// content.
std::string contentHash(std::string_view bytes);

}  // namespace project
