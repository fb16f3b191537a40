// SPDX-License-Identifier: MIT
// What a scene must satisfy before anyone renders or saves it.
#pragma once
#include <string>
#include <vector>

#include "renderer/scene/scene.hpp"

namespace steradian {

struct Problem {
  std::string where;  // "object 'Lamp'.transform.scale"
  std::string what;   // "is 0 along y; expected a finite factor that is not 0"
};

/// Every violated rule: finite values in range, unique ids, parents that exist and form no cycle,
/// materials and animation targets that exist, key times that increase. Empty = sound.
std::vector<Problem> problemsOf(const Scene& scene);

}  // namespace steradian
