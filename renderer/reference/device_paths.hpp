// SPDX-License-Identifier: MIT
// Paths as the device traced them, with everything that happened at each vertex.
#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "renderer/gpu_scene.hpp"
#include "renderer/presenter.hpp"

namespace steradian::reference {

/// One sample of one pixel; rows as shaders/path_record.glsl lays them out.
struct PathRecord {
  int x = 0, y = 0;          // film pixels from the top left
  std::uint64_t sample = 0;  // of the pixel, over both half-buffers
  std::vector<glm::vec4> rows;
};

/// A scene with all that the shaders read.
struct TracedScene {
  GpuScene scene;
  std::vector<glm::vec4> tables, meshes;
  std::vector<std::uint32_t> texels;
};

/// The scene as this device traces it: fewer lights per vertex where its loop budget asks for that. Throws
/// what planLoops() throws.
TracedScene tracedScene(GpuScene scene, const gpu::Device& device);

/// Push constants of one sample: which half-buffer, and the index in its sequence.
gpu::TraceParams paramsOfSample(const TracedScene& traced, std::uint64_t sample);

/// Samples [begin, end) of all pixels of a rectangle inside the film, pixel by pixel. Blocks. Throws
/// Error(usage) when the record would not fit into 256 MiB, Error(noDevice).
std::vector<PathRecord> recordPaths(const gpu::Device& device, const TracedScene& traced, PixelRect pixels,
                                    std::uint64_t begin, std::uint64_t end);

}  // namespace steradian::reference
