// SPDX-License-Identifier: MIT
// What the files that implement the edits share.
#pragma once
#include <string>
#include <string_view>
#include <unordered_set>

#include "renderer/scene/scene.hpp"

namespace steradian::edits {

Object* findMutable(Scene& scene, Id id);  // nullptr when absent
Id takeId(Scene& scene);                   // a fresh id
std::string freeName(std::string_view wanted, const std::unordered_set<std::string_view>& taken);

}  // namespace steradian::edits
