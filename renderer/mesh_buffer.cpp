// SPDX-License-Identifier: MIT
#include "renderer/mesh_buffer.hpp"

#include <algorithm>

namespace steradian {
namespace {

// Where the host cannot reach device memory a copy goes through memory of this size.
constexpr std::size_t rowsAtOnce = 1 << 22;

}  // namespace

gpu::Buffer meshBuffer(const gpu::Device& device, const GpuScene& scene) {
  std::size_t rows = 0;
  for (const auto& mesh : scene.meshes) rows += mesh->nodes.size() + mesh->triangles.size();
  for (const auto& vertices : scene.vertices) rows += vertices->rows.size();
  if (rows == 0) return {};
  gpu::Buffer buffer(device, gpu::BufferKind::texelRows, rows * sizeof(glm::vec4), "mesh data");
  std::size_t at = 0;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    for (const auto* part : {&scene.meshes[i]->nodes, &scene.meshes[i]->triangles, &scene.vertices[i]->rows})
      for (std::size_t first = 0; first < part->size(); first += rowsAtOnce) {
        const std::size_t count = std::min(rowsAtOnce, part->size() - first);
        buffer.writeRows(at * sizeof(glm::vec4), std::span(*part).subspan(first, count));
        at += count;
      }
  return buffer;
}

}  // namespace steradian
