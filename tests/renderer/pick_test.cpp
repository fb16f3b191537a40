// SPDX-License-Identifier: MIT
// What lies under a pixel: object, position and normal of every kind of shape, checked in the shape's own
// space.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

/// Distance-like value of an object-space point to the surface (0 on it), in units of the shape's size.
struct Implicit {
  dvec3 p;
  double operator()(const Sphere& s) const { return glm::length(p) / s.radius - 1.0; }
  double operator()(const Plane&) const { return p.y; }
  double operator()(const Box& b) const {
    const dvec3 q = glm::abs(p) / (0.5 * b.size);
    return std::max({q.x, q.y, q.z}) - 1.0;
  }
  double operator()(const Rect& r) const {
    return std::abs(p.y) + std::max({0.0, std::abs(p.x) - r.size.x / 2, std::abs(p.z) - r.size.y / 2});
  }
  double operator()(const Disk& d) const {
    return std::abs(p.y) + std::max(0.0, std::hypot(p.x, p.z) - d.radius);
  }
  double operator()(const Cylinder& c) const {
    return std::max(std::hypot(p.x, p.z) / c.radius, std::abs(p.y) / (0.5 * c.height)) - 1.0;
  }
  double operator()(const MeshShape&) const { return 0.0; }  // picked in mesh_test.cpp
};

dvec3 gradientAt(const Shape& shape, const dvec3& p) {
  if (shape.index() == 1 || shape.index() == 3 || shape.index() == 4) return {0.0, 1.0, 0.0};
  dvec3 gradient(0.0);
  for (int i = 0; i < 3; ++i) {
    dvec3 step(0.0);
    step[i] = 1e-5;
    gradient[i] = std::visit(Implicit{p + step}, shape) - std::visit(Implicit{p - step}, shape);
  }
  return gradient;
}

class PickTest : public RendererTest {
 protected:
  /// Looks at the object's centre and picks the pixels around the middle.
  void expectPicked(const Scene& scene, Id id, const dvec3& eye) {
    const Object& object = *find(scene, id);
    const Shape& shape = std::get<Geometry>(object.content).shape;
    const glm::dmat4 world = worldFromObject(scene, id);
    const dvec3 target(world[3]);
    renderer().setScene(scene, lookAt(eye, target, 0.02), {9, 9});
    for (const int x : {1, 4, 8}) {
      SCOPED_TRACE(testing::Message() << "shape " << shape.index() << ", pixel " << x);
      const auto picked = renderer().pick(x, 3);
      ASSERT_TRUE(picked);
      EXPECT_EQ(picked->object, id);
      const dvec3 local(glm::inverse(world) * glm::dvec4(picked->position, 1.0));
      // Float holds 10 m to half a micrometre; the flattest shape is 0.1 m thick.
      EXPECT_NEAR(std::visit(Implicit{local}, shape), 0.0, 1e-5);
      const dvec3 seen = picked->position - eye;
      EXPECT_NEAR(picked->distance, glm::length(seen), 1e-5 * picked->distance);
      EXPECT_GT(glm::dot(glm::normalize(seen), glm::normalize(target - eye)), 0.99);
      const dvec3 gradient =
          glm::normalize(glm::transpose(glm::inverse(glm::dmat3(world))) * gradientAt(shape, local));
      EXPECT_NEAR(std::abs(glm::dot(gradient, picked->normal)), 1.0, 1e-5);
      EXPECT_LT(glm::dot(picked->normal, seen), 0.0);
    }
  }
};

/// One of each kind on a circle of radius 10 around `centre`, turned and stretched.
Scene oneOfEach(const dvec3& centre, std::vector<Id>& ids) {
  Scene scene = plainScene(0);
  const Id m = add(scene, lambert(glm::vec3(0.5f)));
  const Shape shapes[] = {Sphere{0.7}, Sphere{0.5},        Box{{1, 2, 0.6}},  Rect{{1, 2}},
                          Disk{0.8},   Cylinder{0.4, 1.5}, Cylinder{1.0, 0.2}};
  const dvec3 scales[] = {dvec3(2),    {1.5, 0.4, 1}, {1, 1, 1},  {-1, 1, 2},
                          {1, 3, 0.5}, {1, 1, 1},     {2, 0.5, 1}};
  for (int i = 0; i < 7; ++i) {
    const double turn = 2.0 * pi * i / 7.0;
    const Transform place = at(centre + dvec3(10 * std::cos(turn), 0, 10 * std::sin(turn)), {1, 0.5 * i, 2},
                               1.2 + 0.4 * i, scales[i]);
    ids.push_back(add(scene, place, shapes[i], m));
  }
  return scene;
}

TEST_F(PickTest, EveryShapeAnswersWithItsObjectPositionAndNormal) {
  for (const dvec3& centre : {dvec3(0.0), dvec3(1e6, -2e5, 3e6)}) {
    SCOPED_TRACE(centre.x);
    std::vector<Id> ids;
    const Scene scene = oneOfEach(centre, ids);
    for (const Id id : ids) expectPicked(scene, id, centre + dvec3(0.3, 0.4, -0.2));
  }
}

TEST_F(PickTest, ShapesAnswerFromInsideToo) {
  const Shape solids[] = {Sphere{2.0}, Box{{3, 4, 5}}, Cylinder{2.0, 3.0}};
  for (const Shape& solid : solids) {
    Scene scene = plainScene(0);
    const Id id = add(scene, at({1, 2, 3}, {1, 1, 0}, 0.6, {1.0, 1.4, 0.8}), solid, lambert(glm::vec3(0.5f)));
    expectPicked(scene, id, dvec3(1.2, 2.3, 3.1));
  }
}

TEST_F(PickTest, PlanesAndPlanetsAnswerExactly) {
  Scene scene = plainScene(0);
  const Id plane = add(scene, at({0, -1, 0}, {0, 0, 1}, 0.3), Plane{}, lambert(glm::vec3(0.5f)));
  const Id planet = add(scene, at({0, 1e6 + 5.0, 0}), Sphere{1e6}, lambert(glm::vec3(0.5f)));
  renderer().setScene(scene, lookAt({0, 0, 0}, {0, -1, 0.1}, 0.5), {9, 9});
  const auto below = renderer().pick(4, 4);
  ASSERT_TRUE(below);
  EXPECT_EQ(below->object, plane);
  const dvec3 normal(-std::sin(0.3), std::cos(0.3), 0.0);
  EXPECT_NEAR(glm::dot(normal, below->position - dvec3(0, -1, 0)), 0.0, 1e-6);
  EXPECT_NEAR(glm::dot(below->normal, normal), 1.0, 1e-6);
  renderer().setScene(scene, lookAt({0, 0, 0}, {0, 1, 0.1}, 0.5), {9, 9});
  const auto above = renderer().pick(4, 4);
  ASSERT_TRUE(above);
  EXPECT_EQ(above->object, planet);
  EXPECT_NEAR(above->position.y, 5.0 + 0.5 * 0.25 / 1e6, 1e-5);
  EXPECT_NEAR(above->normal.y, -1.0, 1e-6);
}

TEST_F(PickTest, NothingAndTheNearestOfTwoAreToldApart) {
  Scene scene = plainScene(0);
  add(scene, at({0, 0, -9}), Sphere{1.0}, Material{});
  const Id nearest = add(scene, at({0, 0, -5}), Sphere{1.0}, Material{});
  renderer().setScene(scene, lookAt({0, 0, 0}, {0, 0, -1}, 1.5), {33, 33});
  const auto middle = renderer().pick(16, 16);
  ASSERT_TRUE(middle);
  EXPECT_EQ(middle->object, nearest);
  EXPECT_NEAR(middle->distance, 4.0, 1e-6);
  EXPECT_FALSE(renderer().pick(0, 0));
  EXPECT_FALSE(renderer().pick(-1, 5));
  EXPECT_FALSE(renderer().pick(33, 5));
  scene.objects.back().visible = false;
  renderer().setScene(scene, lookAt({0, 0, 0}, {0, 0, -1}, 1.5), {33, 33});
  EXPECT_NEAR(renderer().pick(16, 16)->distance, 8.0, 1e-6);
}

}  // namespace
}  // namespace steradian
