// SPDX-License-Identifier: MIT
// The light tree's rows: complete, shallow, and its trails lead to the lights that they are of.
#include "renderer/light_tree.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

#include "shaders/gpu_types.h"

namespace steradian {
namespace {

using Rows = std::vector<glm::vec4>;

void addPoint(Rows& lights, const glm::vec3& at, float candela) {
  lights.insert(lights.end(), {glm::vec4(at, float(gpu::LIGHT_POINT)), glm::vec4(glm::vec3(candela), 0.0f),
                               glm::vec4(0.0f), glm::vec4(0.0f)});
}

std::uint32_t bitsOf(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

/// Follows every light's trail from the root.
void expectComplete(const Rows& lights) {
  const std::uint32_t count = std::uint32_t(lights.size() / gpu::LIGHT_ROWS);
  const Rows rows = lightTreeRows(lights);
  const std::uint32_t nodes = 2 * count - 1;
  ASSERT_EQ(rows.size(), nodes * gpu::LIGHT_NODE_ROWS + count);
  std::set<std::uint32_t> visited;
  for (std::uint32_t light = 0; light < count; ++light) {
    const std::uint32_t trail = bitsOf(rows[nodes * gpu::LIGHT_NODE_ROWS + light].x);
    std::uint32_t node = 0, level = 0;
    for (;; ++level) {
      ASSERT_LE(level, lightTreeDepth(count));
      ASSERT_LT(node, nodes);
      visited.insert(node);
      const std::uint32_t link = bitsOf(rows[node * gpu::LIGHT_NODE_ROWS + 1].y);
      if (link >= gpu::LIGHT_NODE_LEAF) {
        ASSERT_EQ(link & ~gpu::LIGHT_NODE_LEAF, light);
        break;
      }
      node = link + (trail >> level & 1u);
    }
  }
  EXPECT_EQ(visited.size(), nodes);
}

TEST(LightTree, EveryLightIsALeafWhereItsTrailEnds) {
  for (const int count : {1, 2, 3, 5, 64, 1000}) {
    Rows lights;
    for (int i = 0; i < count; ++i)
      addPoint(lights, {std::sin(i * 1.7f), std::cos(i * 2.9f), std::sin(i * 0.3f)}, float(i % 7));
    expectComplete(lights);
  }
}

TEST(LightTree, LightsInOnePlaceAndGeometricSeriesStayShallow) {
  Rows same, series;
  for (int i = 0; i < 300; ++i) {
    addPoint(same, {1, 2, 3}, 1.0f);
    addPoint(series, {std::ldexp(1.0f, i % 100 - 50), 0, 0}, std::ldexp(1.0f, i % 60));
  }
  expectComplete(same);
  expectComplete(series);
}

TEST(LightTree, DirectionalLightsHaveABranchOfTheirOwn) {
  Rows lights;
  for (int i = 0; i < 4; ++i) {
    addPoint(lights, {float(i), 0, 0}, 1.0f);
    addPoint(lights, {0, 1, 0}, 1.0f);
    lights[lights.size() - gpu::LIGHT_ROWS].w = float(gpu::LIGHT_DIRECTIONAL);
  }
  expectComplete(lights);
  const Rows rows = lightTreeRows(lights);
  const std::uint32_t child = bitsOf(rows[1].y);
  EXPECT_GE(rows[child * gpu::LIGHT_NODE_ROWS + 1].x, 0.0f);
  EXPECT_EQ(rows[(child + 1) * gpu::LIGHT_NODE_ROWS + 1].x, -1.0f);
  EXPECT_FLOAT_EQ(rows[child * gpu::LIGHT_NODE_ROWS].w, 0.5f) << "their shares of the power";
}

TEST(LightTree, TwoClustersAreSplitFromEachOther) {
  Rows lights;
  for (int i = 0; i < 30; ++i) addPoint(lights, {i % 3 == 0 ? 100.0f + i : float(i), 0, 0}, 1.0f);
  const Rows rows = lightTreeRows(lights);
  const std::uint32_t child = bitsOf(rows[1].y);
  EXPECT_LT(rows[child * gpu::LIGHT_NODE_ROWS].x, 20.0f);
  EXPECT_GT(rows[(child + 1) * gpu::LIGHT_NODE_ROWS].x, 100.0f);
  EXPECT_NEAR(rows[(child + 1) * gpu::LIGHT_NODE_ROWS].w, 1.0f / 3.0f, 1e-6f);
}

TEST(LightTree, NoLightsNeedNoRowsAndAMillionStayWithinTheShadersDepth) {
  EXPECT_TRUE(lightTreeRows({}).empty());
  EXPECT_EQ(lightTreeDepth(1), 0u);
  EXPECT_LE(lightTreeDepth(1'000'000), gpu::MAX_LIGHT_TREE_DEPTH);
}

}  // namespace
}  // namespace steradian
