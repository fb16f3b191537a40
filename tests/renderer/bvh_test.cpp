// SPDX-License-Identifier: MIT
// The hierarchy as the host builds it: every triangle is in it once, every box holds what is below it, and
// threads change nothing.
#include "renderer/mesh/bvh.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <set>

#include "renderer/mesh/grid.hpp"
#include "tests/measured.hpp"
#include "tests/renderer/meshes.hpp"

namespace steradian {
namespace {

using namespace gpu;

std::uint32_t bitsOf(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

bool holds(const Bounds& outer, const Bounds& inner) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(outer.low[axis] <= inner.low[axis] && inner.high[axis] <= outer.high[axis])) return false;
  return true;
}

/// Walks everything; returns the bounds of the triangles below `node`, and checks each box on the way.
struct Walk {
  const MeshBvh& bvh;
  std::multiset<std::uint32_t> triangles = {};
  int depth = 0;

  Bounds below(std::uint32_t node, int level) {
    depth = std::max(depth, level);
    Bounds all;
    for (std::uint32_t i = 0; i < BVH_NODE_ROWS; ++i) {
      const glm::vec4& row = bvh.nodes.at(node + i);
      for (int k = 0; k < 3; ++k)
        EXPECT_FALSE(std::isnan(row[k])) << "bits that look like a NaN may get lost";
      if (isNothing(row)) continue;
      const std::uint32_t link = bitsOf(row.w);
      const Bounds child = (link & BVH_LEAF) != 0 ? leaf(link) : below(link, level + 1);
      EXPECT_TRUE(holds(boundsOf(row), child)) << "row " << node + i;
      all.add(child);
    }
    return all;
  }
  Bounds leaf(std::uint32_t link) {
    Bounds bounds;
    const std::size_t first = link & BVH_FIRST_MASK, count = (link & ~BVH_LEAF) >> BVH_COUNT_SHIFT;
    EXPECT_GE(count, 1u);
    for (std::size_t t = first; t < first + count; ++t) {
      triangles.insert(bitsOf(bvh.triangles.at(3 * t).w));
      for (int corner = 0; corner < 3; ++corner) {
        const glm::vec4& v = bvh.triangles.at(3 * t + std::size_t(corner));
        bounds.add(Float4{v.x, v.y, v.z, 0.0f});
      }
    }
    return bounds;
  }
};

float hills(float x, float z) {
  return 0.2f * std::sin(7.0f * x) * std::cos(5.0f * z);
}

std::vector<Mesh> someMeshes() {
  std::vector<Mesh> all{meshes::quad(1.0f),
                        meshes::icosphere(0),
                        meshes::icosphere(4),
                        meshes::terrain(60, hills),
                        meshes::terrain(40, [](float, float) { return 0.0f; }),
                        meshes::soup(20000, 0.3f, 1)};
  Mesh stadium = meshes::icosphere(3);  // something tiny beside something huge
  for (glm::vec3& p : stadium.positions) p *= 1e-4f;
  const unsigned first = unsigned(stadium.positions.size());
  stadium.positions.insert(stadium.positions.end(), {{-1e3, 0, -1e3}, {1e3, 0, -1e3}, {0, 0, 1e3}});
  stadium.triangles.emplace_back(first, first + 1, first + 2);
  all.push_back(stadium);
  Mesh same;  // nothing that a plane could separate
  same.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  same.triangles.assign(1000, {0, 1, 2});
  all.push_back(same);
  return all;
}

TEST(Bvh, every_triangle_is_in_exactly_one_leaf_and_every_box_holds_its_triangles) {
  for (const Mesh& mesh : someMeshes()) {
    const MeshBvh bvh = buildBvh(mesh.positions, mesh.triangles);
    Walk walk{bvh};
    walk.below(0, 1);
    EXPECT_EQ(walk.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(std::set(walk.triangles.begin(), walk.triangles.end()).size(), mesh.triangles.size());
    EXPECT_EQ(walk.depth, bvh.depth);
    EXPECT_LE(bvh.depth, int(BVH_DEPTH));
  }
}

TEST(Bvh, vertices_keep_their_place_to_seven_digits_of_the_mesh_size) {
  for (const Mesh& mesh : someMeshes()) {
    const MeshBvh bvh = buildBvh(mesh.positions, mesh.triangles);
    for (std::size_t row = 0; row < bvh.triangles.size(); row += 3)
      for (int corner = 0; corner < 3; ++corner) {
        const glm::uvec3& t = mesh.triangles[bitsOf(bvh.triangles[row].w)];
        const glm::dvec3 back =
            bvh.centre + bvh.cell * glm::dvec3(glm::vec3(bvh.triangles[row + std::size_t(corner)]));
        ASSERT_LE(glm::length(back - glm::dvec3(mesh.positions[t[corner]])), 32768.0 * bvh.cell * 1.2e-7);
      }
  }
}

TEST(Bvh, the_number_of_threads_does_not_matter) {
  const Mesh mesh = meshes::soup(300000, 0.02f, 3);
  const MeshBvh one = buildBvh(mesh.positions, mesh.triangles, 1);
  for (const unsigned threads : {2u, 3u, 8u}) {
    const MeshBvh many = buildBvh(mesh.positions, mesh.triangles, threads);
    ASSERT_EQ(many.nodes.size(), one.nodes.size());
    EXPECT_EQ(std::memcmp(many.nodes.data(), one.nodes.data(), one.nodes.size() * sizeof(glm::vec4)), 0);
    EXPECT_EQ(
        std::memcmp(many.triangles.data(), one.triangles.data(), one.triangles.size() * sizeof(glm::vec4)),
        0);
  }
}

TEST(Bvh, row10_triangles_without_area_or_with_a_vertex_that_is_no_number_are_left_out) {
  Mesh mesh = meshes::icosphere(1);
  const std::size_t sound = mesh.triangles.size();
  const unsigned first = unsigned(mesh.positions.size());
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                  infinite = std::numeric_limits<float>::infinity();
  mesh.positions.insert(mesh.positions.end(),
                        {{nan, 0, 0}, {infinite, 0, 0}, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}});
  mesh.triangles.insert(mesh.triangles.end(), {{0, 1, first}, {0, 1, first + 1}, {0, 0, 1}, {2, 2, 2}});
  const std::size_t kept = buildBvh(mesh.positions, mesh.triangles).triangleCount();
  EXPECT_EQ(kept, sound);
  measured("unsound triangles kept", double(kept) - double(sound), 0);
  EXPECT_TRUE(buildBvh(mesh.positions, std::vector<glm::uvec3>{{0, 0, 1}}).empty());
  EXPECT_TRUE(buildBvh({}, {}).empty());
}

TEST(Bvh, a_refit_holds_the_moved_triangles) {
  Mesh mesh = meshes::terrain(50, hills);
  MeshBvh bvh = buildBvh(mesh.positions, mesh.triangles);
  for (glm::vec3& p : mesh.positions) p = glm::vec3(p.x * 3.0f, p.y + std::sin(9.0f * p.x), p.z + 5.0f);
  refit(bvh, mesh.positions, mesh.triangles);
  Walk walk{bvh};
  walk.below(0, 1);
  EXPECT_EQ(walk.triangles.size(), mesh.triangles.size());
  const glm::uvec3& t = mesh.triangles[bitsOf(bvh.triangles[0].w)];
  const glm::dvec3 back = bvh.centre + bvh.cell * glm::dvec3(glm::vec3(bvh.triangles[0]));
  EXPECT_LE(glm::length(back - glm::dvec3(mesh.positions[t.x])), 1e-6);
}

TEST(Bvh, a_ray_meets_few_nodes_and_the_worst_grows_slowly) {
  double before = 0.0;
  for (const int side : {20, 80, 320}) {
    const Mesh mesh = meshes::terrain(side, hills);
    const double steps = buildBvh(mesh.positions, mesh.triangles).steps;
    EXPECT_GT(steps, before);
    // A line that grazes a height field meets as many nodes as one row of it has, at worst.
    EXPECT_LT(steps, 40.0 + 6.0 * side);
    before = steps;
  }
}

TEST(Bvh, the_tests_of_a_ray_grow_with_the_logarithm_of_the_triangles) {
  std::vector<double> means;
  for (const int side : {10, 40, 160, 640}) {  // 16 times the triangles each
    const Mesh mesh = meshes::terrain(side, hills);
    const MeshBvh bvh = buildBvh(mesh.positions, mesh.triangles);
    std::mt19937 random(3);
    double sum = 0.0;
    constexpr int rays = 2000;
    for (int i = 0; i < rays; ++i) {
      const auto coordinate = [&] { return double(random()) * 0x1p-31 - 1.0; };
      const glm::dvec3 above(coordinate(), 3.0, coordinate());
      sum += visitsBefore(bvh, above, glm::normalize(glm::dvec3(0.1, -1.0, 0.05)), 100.0);
    }
    means.push_back(sum / rays);
    EXPECT_LT(visitsBefore(bvh, {0.0, 3.0, 0.0}, {0.0, -1.0, 0.0}, 0.1), 2.0) << "ends above everything";
  }
  for (std::size_t i = 2; i < means.size(); ++i)
    EXPECT_LT(means[i] - means[i - 1], 1.3 * (means[i - 1] - means[i - 2])) << means[i];
  EXPECT_GT(means[0], 3.0);
}

}  // namespace
}  // namespace steradian
