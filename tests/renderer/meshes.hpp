// SPDX-License-Identifier: MIT
// Meshes that tests are made of: spheres from subdivided icosahedra, grids of heights, random triangles.
#pragma once
#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "renderer/scene/mesh.hpp"

namespace steradian::meshes {

/// The unit sphere's points, 20 * 4^levels triangles, counter-clockwise from outside.
inline Mesh icosphere(int levels) {
  const float t = 0.5f * (1.0f + std::sqrt(5.0f));
  Mesh mesh;
  mesh.positions = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                    {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<unsigned, unsigned>, unsigned> middles;
    const auto middle = [&](unsigned a, unsigned b) {
      const auto [at, isNew] = middles.emplace(std::minmax(a, b), unsigned(mesh.positions.size()));
      if (isNew) mesh.positions.push_back(mesh.positions[a] + mesh.positions[b]);
      return at->second;
    };
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3& v : mesh.triangles) {
      const unsigned ab = middle(v.x, v.y), bc = middle(v.y, v.z), ca = middle(v.z, v.x);
      finer.insert(finer.end(), {{v.x, ab, ca}, {v.y, bc, ab}, {v.z, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
    for (glm::vec3& p : mesh.positions) p = glm::normalize(p);
  }
  for (glm::vec3& p : mesh.positions) p = glm::normalize(p);
  return mesh;
}

/// Two triangles in y = 0, |x|, |z| <= half, facing +Y.
inline Mesh quad(float half) {
  Mesh mesh;
  mesh.positions = {{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
  return mesh;
}

/// `side` by `side` squares over |x|, |z| <= 1 at the given heights, facing +Y.
inline Mesh terrain(int side, const std::function<float(float, float)>& height) {
  Mesh mesh;
  const auto at = [side](int i) { return 2.0f * float(i) / float(side) - 1.0f; };
  for (int z = 0; z <= side; ++z)
    for (int x = 0; x <= side; ++x) mesh.positions.emplace_back(at(x), height(at(x), at(z)), at(z));
  const unsigned row = unsigned(side) + 1;
  for (unsigned z = 0; z < unsigned(side); ++z)
    for (unsigned x = 0; x < unsigned(side); ++x) {
      const unsigned a = z * row + x;
      mesh.triangles.insert(mesh.triangles.end(), {{a, a + row, a + 1}, {a + 1, a + row, a + row + 1}});
    }
  return mesh;
}

/// Unconnected triangles of size up to `size` in the cube |x|, |y|, |z| <= 1.
inline Mesh soup(int count, float size, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&](float most) { return most * (float(random()) * 0x1p-31f - 1.0f); };
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 centre(next(1.0f), next(1.0f), next(1.0f));
    const unsigned first = unsigned(mesh.positions.size());
    for (int corner = 0; corner < 3; ++corner)
      mesh.positions.push_back(centre + glm::vec3(next(size), next(size), next(size)));
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

}  // namespace steradian::meshes
