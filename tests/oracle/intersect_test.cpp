// SPDX-License-Identifier: MIT
// The oracle's geometry: hits lie on the shapes, and solids are met where marching along the ray says so.
#include "tests/oracle/intersect.hpp"

#include <gtest/gtest.h>

#include "tests/oracle/random.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian::oracle {
namespace {

/// Negative within.
double distanceFrom(const Shape& shape, const dvec3& p) {
  if (const auto* s = std::get_if<Sphere>(&shape)) return glm::length(p) - s->radius;
  if (const auto* b = std::get_if<Box>(&shape)) {
    const dvec3 d = glm::abs(p) - 0.5 * b->size;
    return std::max({d.x, d.y, d.z});
  }
  const auto& c = std::get<Cylinder>(shape);
  return std::max(glm::length(dvec2(p.x, p.z)) - c.radius, std::abs(p.y) - 0.5 * c.height);
}

const Shape kSolids[] = {Sphere{0.7}, Box{{1.0, 0.6, 1.4}}, Cylinder{0.6, 1.1}};

TEST(OracleIntersect, SolidsAreMetWhereMarchingMeetsThem) {
  std::seed_seq seed{7};
  Random random(seed);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const Shape& shape = kSolids[i % 3];
    const Ray ray{random.onSphere() * 2.0 * random.uniform(), random.onSphere()};
    const auto hit = intersect(shape, ray, 0.0);
    const bool startsInside = distanceFrom(shape, ray.origin) < 0.0;
    double marched = -1.0;
    for (double t = 0.0; t < 4.0 && marched < 0.0; t += 1e-3)
      if ((distanceFrom(shape, ray.at(t)) < 0.0) != startsInside) marched = t;
    if (!hit) {
      EXPECT_LT(marched, 0.0);
      continue;
    }
    ++hits;
    EXPECT_NEAR(distanceFrom(shape, ray.at(hit->t)), 0.0, 1e-12);
    if (marched >= 0.0) {
      EXPECT_NEAR(hit->t, marched, 1e-3);
    }
    EXPECT_GT(distanceFrom(shape, ray.at(hit->t) + 1e-6 * glm::normalize(hit->normal)), 0.0);
    EXPECT_EQ(glm::dot(hit->normal, ray.direction) > 0.0, startsInside);
  }
  EXPECT_GT(hits, 80);
}

TEST(OracleIntersect, FlatShapesEndAtTheirEdges) {
  const Ray down{{0.4, 2.0, -0.8}, {0.0, -2.0, 0.0}};
  EXPECT_DOUBLE_EQ(intersect(Rect{{1.0, 2.0}}, down, 0.0)->t, 1.0);
  EXPECT_FALSE(intersect(Rect{{0.7, 2.0}}, down, 0.0));
  EXPECT_FALSE(intersect(Rect{{1.0, 1.5}}, down, 0.0));
  EXPECT_TRUE(intersect(Disk{0.9}, down, 0.0));
  EXPECT_FALSE(intersect(Disk{0.89}, down, 0.0));
  EXPECT_FALSE(intersect(Plane{}, {{0, 1, 0}, {1, 0, 0}}, 0.0));
  EXPECT_FALSE(intersect(Plane{}, {{0, 1, 0}, {1, 1, 0}}, 0.0));
}

TEST(OracleIntersect, PlacedShapesKeepTheRaysParameterAndTurnTheirNormals) {
  World world{scenes::plainScene(0)};
  const dmat4 placed = matrixOf(scenes::at({1, 2, 3}, {0, 0, 1}, 0.5, {2.0, 1.0, 0.5}));
  world.bodies.push_back({Sphere{1.0}, glm::inverse(placed)});
  const Ray ray{{6, 2.5, 3.1}, glm::normalize(dvec3(-1, -0.1, 0))};
  const auto hit = nearest(world, ray, 0.0);
  ASSERT_TRUE(hit);
  const auto local = [&](const dvec3& p) { return dvec3(glm::inverse(placed) * glm::dvec4(p, 1.0)); };
  EXPECT_NEAR(glm::length(local(ray.at(hit->t))), 1.0, 1e-12);
  // The normal is square to the ellipsoid: distances along tangents are of second order.
  const dvec3 tangent = glm::normalize(glm::cross(hit->normal, dvec3(0.3, 0.5, 0.7)));
  EXPECT_NEAR(glm::length(local(ray.at(hit->t) + 1e-5 * tangent)), 1.0, 1e-9);
  EXPECT_NEAR(glm::length(hit->normal), 1.0, 1e-12);
}

}  // namespace
}  // namespace steradian::oracle
