// SPDX-License-Identifier: MIT
// The device's float against the same functions in double, along the same path.
#pragma once
#include <memory>
#include <optional>

#include "renderer/reference/comparison.hpp"
#include "renderer/reference/device_paths.hpp"

namespace steradian::reference {

/// Where a path that runs in double from the camera on leaves the device's path.
struct FreeRun {
  std::optional<int> partedAt;  // first vertex on another primitive, or where one path ended
  int vertices = 0;             // that both have in common
  double distance = 0.0;        // largest relative difference of the distances over these
  double radiance = 0.0;        // relative difference of the sample's radiance
};

/// Not thread-safe; one thread at a time.
class Judge {
 public:
  explicit Judge(const TracedScene& traced);  // which must stay alive
  ~Judge();

  /// Every stage repeated in double from the inputs that the device recorded, so that errors do not add up.
  std::vector<Finding> compare(const PathRecord& record);
  FreeRun run(const PathRecord& record);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Vertices of a path, and the primitive met at one of them; nothing where the path left the scene.
int vertexCount(const PathRecord& record);
std::optional<std::uint32_t> primitiveAt(const PathRecord& record, int vertex);

}  // namespace steradian::reference
