// SPDX-License-Identifier: MIT
// Directional albedo of white GGX facets and of rough glass, each tabulated once per process when first asked
// for (layout in shaders/gpu_types.h).
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include <glm/glm.hpp>

namespace steradian {

/// ENERGY_ROWS rows. Any thread.
const std::vector<glm::vec4>& energyTable();

/// Any thread.
class GlassTables {
 public:
  /// GLASS_ROWS rows for glass of this index; takes about a tenth of a second the first time.
  std::shared_ptr<const std::vector<glm::vec4>> of(float ior);

 private:
  std::mutex mutex_;
  std::map<float, std::shared_ptr<const std::vector<glm::vec4>>> tables_;
};

}  // namespace steradian
