// SPDX-License-Identifier: MIT
#include "editor/cli/bench_mesh_scene.hpp"

#include <bit>
#include <cmath>
#include <functional>
#include <random>

namespace steradian::bench {

namespace {

const glm::vec3 eye(0.0f, 1.4f, 3.6f), target(0.0f, 0.35f, 0.0f), lamp(1.5f, 4.0f, 1.0f);
constexpr float twoPi = 6.2831853f;

float waves(float x, float y, float z) {
  float sum = 0.0f, amplitude = 0.5f, frequency = 2.7f;
  for (int octave = 0; octave < 6; ++octave) {
    sum += amplitude * std::sin(frequency * x + 1.3f) * std::sin(frequency * y + 0.7f) *
           std::sin(frequency * z + 2.1f);
    amplitude *= 0.5f;
    frequency *= 1.97f;
  }
  return sum;
}

/// Columns x rows squares of the unit square mapped to space.
void addGrid(Mesh& mesh, unsigned columns, unsigned rows,
             const std::function<glm::vec3(float, float)>& place) {
  const unsigned first = unsigned(mesh.positions.size());
  for (unsigned y = 0; y <= rows; ++y)
    for (unsigned x = 0; x <= columns; ++x)
      mesh.positions.push_back(place(float(x) / float(columns), float(y) / float(rows)));
  for (unsigned y = 0; y < rows; ++y)
    for (unsigned x = 0; x < columns; ++x) {
      const unsigned a = first + y * (columns + 1) + x, b = a + columns + 1;
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, a + 1}, {a + 1, b, b + 1}});
    }
}

}  // namespace

Mesh benchMesh(std::size_t triangles) {
  Mesh mesh;
  const auto side = unsigned(std::sqrt(double(triangles) / 4.0));
  addGrid(mesh, side, side, [](float u, float v) {
    const float phi = twoPi * u, theta = 0.5f * twoPi * v;
    const glm::vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
    return glm::vec3(0.0f, 0.8f, 0.0f) + n * (0.8f + 0.25f * waves(n.x * 2.0f, n.y * 2.0f, n.z * 2.0f));
  });
  addGrid(mesh, side, side, [](float u, float v) {
    const float x = 8.0f * u - 4.0f, z = 8.0f * v - 4.0f;
    return glm::vec3(x, 0.6f * waves(x, 1.0f, z) - 0.2f, z);
  });
  return mesh;
}

Scene benchMeshScene(const std::shared_ptr<const Mesh>& mesh) {
  Scene scene;
  Object object;
  object.id = Id{1};
  object.content = Geometry{MeshShape{mesh}, Id::none};
  scene.objects.push_back(object);
  return scene;
}

std::vector<CastRay> benchPrimaryRays(int side) {
  const glm::vec3 forward = glm::normalize(target - eye),
                  right = glm::normalize(glm::cross(forward, {0, 1, 0})), up = glm::cross(right, forward);
  std::vector<CastRay> rays;
  const int blocks = side / 8;
  for (int block = 0; block < blocks * blocks; ++block)
    for (int pixel = 0; pixel < 64; ++pixel) {
      const float x = (float(block % blocks * 8 + pixel % 8) + 0.5f) / float(side) - 0.5f;
      const float y = (float(block / blocks * 8 + pixel / 8) + 0.5f) / float(side) - 0.5f;
      rays.push_back({eye, 1e30f, glm::normalize(forward + right * x - up * y)});
    }
  return rays;
}

SecondaryRays benchSecondaryRays(const std::vector<CastRay>& primary, const std::vector<CastHit>& hits,
                                 const Mesh& mesh, const MeshBvh& bvh) {
  SecondaryRays out;
  std::mt19937 random(7);
  const auto next = [&] { return float(random() >> 8) * 0x1p-24f; };
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].primitive == gpu::NO_PRIMITIVE) continue;
    const glm::vec4 row = bvh.triangles[hits[i].triangleRow - bvh.nodes.size()];
    const glm::uvec3 corners = mesh.triangles[std::bit_cast<std::uint32_t>(row.w)];
    const glm::vec3 a = mesh.positions[corners.x];
    glm::vec3 n = glm::normalize(glm::cross(mesh.positions[corners.y] - a, mesh.positions[corners.z] - a));
    if (glm::dot(n, primary[i].d) > 0.0f) n = -n;
    const glm::vec3 p = primary[i].o + primary[i].d * hits[i].t + n * 1e-4f;
    const glm::vec3 toLamp = lamp - p;
    out.shadow.push_back({p, glm::length(toLamp), glm::normalize(toLamp)});
    const float z = 1.0f - 2.0f * next(), phi = twoPi * next(), r = std::sqrt(std::max(0.0f, 1.0f - z * z));
    out.diffuse.push_back(
        {p, 1e30f, glm::normalize(n * 1.0001f + glm::vec3(r * std::cos(phi), r * std::sin(phi), z))});
  }
  return out;
}

}  // namespace steradian::bench
