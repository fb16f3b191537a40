// SPDX-License-Identifier: MIT
// The hierarchy over a scene: its boxes hold what they stand for, and it is used where it pays.
#include "renderer/top_level.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

constexpr double large = 100.0;

class TopLevelTest : public testing::Test {
 protected:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  dvec3 anywhere(double reach) {
    return {uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)};
  }
  /// A point on the surface of the unit shape of a kind.
  dvec3 onUnit(ShapeKind kind) {
    const double phi = uniform(0, 2 * pi);
    const dvec3 turned(std::cos(phi), uniform(-1, 1), std::sin(phi));
    switch (kind) {
      case boxes:
        return glm::sign(anywhere(1));  // a corner
      case rects:
        return glm::sign(anywhere(1)) * dvec3(1, 0, 1);
      case disks:
        return turned * dvec3(1, 0, 1);
      case cylinders:
        return glm::sign(turned.y) * dvec3(0, 1, 0) + turned * dvec3(1, 0, 1);
      default:
        return glm::normalize(anywhere(1));
    }
  }
  static bool holds(const Bounds& box, const dvec3& p) {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
      inside = inside && p[axis] >= box.low[axis] && p[axis] <= box.high[axis];
    return inside;
  }
  static ShapeLists listOf(int count, const Shape& shape) {
    ShapeLists lists;
    for (int i = 0; i < count; ++i)
      lists.add(shape, matrixOf(at({double(i), 0, 0})), dvec3(0.0), {Id::none, Id::none}, large);
    return lists;
  }

  std::mt19937_64 random_{17};
};

TEST_F(TopLevelTest, boxes_hold_their_shapes_near_and_far_turned_stretched_and_sheared) {
  const Shape kinds[] = {Sphere{0.7}, Box{{1, 2, 0.5}}, Rect{{2, 1}}, Disk{0.8}, Cylinder{0.4, 1.5}};
  for (const double distance : {0.0, 10.0, 1e6})
    for (int i = 0; i < 500; ++i) {
      const dvec3 scale = i % 3 == 0 ? dvec3(1.0) : dvec3(uniform(0.01, 3), uniform(0.1, 2), uniform(0.1, 2));
      glm::dmat4 world = matrixOf(at(distance * anywhere(1), anywhere(1), uniform(0, 6), scale));
      if (i % 5 == 0) world = matrixOf(at({0, 0, 0}, anywhere(1), 1.0, {1, 3, 0.5})) * world;
      ShapeLists lists;
      lists.add(kinds[i % 5], world, anywhere(1), {Id::none, Id::none}, large);
      const auto entries = topLevelEntries(lists, {}, true);
      ASSERT_EQ(entries.size(), 1u);
      for (int kind = 0; kind < shapeKinds; ++kind)
        for (const Placement& place : lists.kinds[kind].places)
          for (int k = 0; k < 20; ++k)
            ASSERT_TRUE(holds(entries[0].box, place.centre + place.worldFromUnit * onUnit(ShapeKind(kind))))
                << "kind " << kind;
    }
}

TEST_F(TopLevelTest, planes_and_planets_have_no_place_in_the_hierarchy) {
  ShapeLists lists = listOf(3, Plane{});
  lists.add(Sphere{6e6}, glm::dmat4(1.0), dvec3(0.0), {Id::none, Id::none}, large);
  EXPECT_EQ(listCost(lists), 0u);
  EXPECT_TRUE(topLevelEntries(lists, {}, true).empty());
  EXPECT_TRUE(buildTopLevel({}).rows.empty());
  lists.add(Disk{1.0}, glm::dmat4(1.0), dvec3(0.0), {Id::none, Id::none}, large);
  const auto entries = topLevelEntries(lists, {}, true);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].primitive, 4u) << "after three planes and a planet";
  EXPECT_EQ(buildTopLevel(entries).rows.size(), gpu::TOP_LEVEL_ROWS);
}

TEST_F(TopLevelTest, small_scenes_keep_their_flat_lists) {
  const auto inHierarchy = [](int spheres, int boxes) {
    Scene scene = plainScene(1);
    const Id matt = add(scene, lambert(glm::vec3(0.5f)));
    for (int i = 0; i < spheres; ++i) add(scene, at({2.0 * i, 0, 0}), Sphere{1.0}, matt);
    for (int i = 0; i < boxes; ++i) add(scene, at({2.0 * i, 5, 0}), Box{}, matt);
    for (int i = 0; i < 50; ++i) add(scene, at({0, -double(i), 0}), Plane{}, matt);
    return packScene(scene, CameraView{}, {8, 8}).shapeHierarchy();
  };
  EXPECT_FALSE(inHierarchy(0, 0));
  EXPECT_FALSE(inHierarchy(8, 8));
  EXPECT_FALSE(inHierarchy(int(spheresWorthAHierarchy) - 1, 0));
  EXPECT_TRUE(inHierarchy(int(spheresWorthAHierarchy), 0));
  EXPECT_TRUE(inHierarchy(8, 32));
}

TEST_F(TopLevelTest, the_steps_of_a_ray_grow_with_the_logarithm_of_the_scene) {
  const auto stepsOf = [&](int count) {
    std::vector<TopLevelEntry> entries;
    for (int i = 0; i < count; ++i)
      entries.push_back(
          {boxOf(spheres, {glm::dmat3(10.0 / std::cbrt(count)), anywhere(50)}), std::uint32_t(i), 0.0});
    return buildTopLevel(entries).worstSteps;
  };
  const double few = stepsOf(100), many = stepsOf(10000);
  EXPECT_GT(few, 8.0);
  EXPECT_LT(many, 12.0 * few) << "a hundred times the shapes";
}

}  // namespace
}  // namespace steradian
