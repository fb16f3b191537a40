// SPDX-License-Identifier: MIT
// Rays per second through triangle meshes of growing size, beside Embree on the same rays where its caster is
// installed.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "renderer/renderer.hpp"

namespace steradian::bench {

struct MeshBenchOptions {
  std::string device;
  std::vector<std::size_t> triangles{1'000, 10'000, 100'000, 1'000'000};
  int runs = 5;                    // of which the fastest counts
  int side = 0;                    // rays per side of the square picture; 0 = by device
  unsigned threads = 2;            // Embree's, and of both builds
  double warmUpMs = 700.0;         // a GPU that has been idle needs as long to reach its clock
  std::optional<bool> whileWhile;  // form of the loop over a mesh; absent = as the tracer on this device
};

/// One kind of rays: primary, shadow or diffuse.
struct MeshRays {
  std::string kind;
  std::size_t rays = 0;
  double mraysPerSecond = 0.0;
  std::optional<double> visits;       // nodes and triangles that a ray must test, mean; of closest hits
  std::optional<double> embree;       // Mrays/s
  std::optional<double> disagreeing;  // share of rays whose hit or distance differs by more than rounding
};

struct MeshBenchResult {
  std::size_t triangles = 0;
  double buildSeconds = 0.0;
  std::optional<double> embreeBuildSeconds;
  std::size_t megabytes = 0;  // of the hierarchy and the triangles on the device
  int depth = 0;
  double steps = 0.0;
  std::vector<MeshRays> rays;
};

struct MeshBench {
  DeviceDescription device;
  std::vector<MeshBenchResult> results;
  std::string peer;  // why Embree is missing, or empty
};

MeshBench measureMeshes(const MeshBenchOptions& options);
std::string textOf(const MeshBench& bench);
std::string jsonOf(const MeshBench& bench);
/// Time per ray against triangles, both logarithmic, as SVG.
std::string plotOf(const MeshBench& bench);

}  // namespace steradian::bench
