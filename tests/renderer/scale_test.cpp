// SPDX-License-Identifier: MIT
// Far from the origin, and small beside large: what float alone cannot hold.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

class ScaleTest : public RendererTest {};

/// Every shape kind and light kind in front of the camera.
Scene gallery() {
  Scene scene = room(4);
  const Id m = add(scene, plastic(0.3f, {0.4f, 0.7f, 0.5f}));
  add(scene, at({-2.2, 0.4, 0.5}, {0, 1, 0}, 0.4), Box{{0.8, 0.8, 0.8}}, m);
  add(scene, at({2.2, 0.5, 0.8}, {1, 0, 1}, 0.5), Cylinder{0.3, 0.7}, m);
  add(scene, at({0.6, 0.3, 1.4}, {1, 2, 0}, 0.7, {0.4, 0.2, 0.3}), Sphere{1.0}, m);
  add(scene, at({-0.9, 1.2, 0.9}, {1, 0, 0}, 1.2), Rect{{0.6, 0.4}}, m);
  add(scene, at({0.9, 2.2, 0.5}, {1, 0, 0.3}, 1.0), Disk{0.3}, m);
  addLight(scene, {{-2, 3, 3}, facing({1, -1.5, -2}), dvec3(1.0)}, SpotLight{0.2f, 0.5f}, 10.0f);
  addLight(scene, {{0, 0, 0}, facing({0.2, -1, -0.3}), dvec3(1.0)}, DirectionalLight{}, 1.0f);
  return scene;
}

TEST_F(ScaleTest, row14_scene_and_camera_moved_far_away_give_the_same_image) {
  const Image here = render(gallery(), roomView(), {48, 48}, 16);
  EXPECT_GT(meanOf(here).value, 0.05);
  for (const dvec3& offset : {dvec3(1e5, 0, -1e5), dvec3(-1e6, 1e6, 1e6)}) {
    Scene scene = gallery();
    CameraView view = roomView();
    translate(scene, view, offset);
    const double difference = mrse(render(scene, view, {48, 48}, 16), here);
    EXPECT_LT(difference, 1e-4) << offset.x;
    measured("MRSE against the scene at the origin", difference, 1e-4);
  }
}

/// Sky share that a sphere of radius r, resting on the ground, leaves to the point x radii from its contact.
double openSky(double x) {
  return 1.0 - std::pow(1.0 + x * x, -1.5);
}

TEST_F(ScaleTest, row15_millimetre_sphere_shades_a_planet_sized_ground) {
  const double r = 1e-3, planet = 1e6;
  Scene scene = plainScene(1);
  add(scene, at({0, -planet, 0}), Sphere{planet}, lambert(glm::vec3(1.0f)));
  add(scene, at({0, r, 0}), Sphere{r}, lambert(glm::vec3(0.0f)));
  add(scene, at({0, -planet, 0}), Sphere{4.0 * planet}, emitter(1.0f));
  for (const double x : {0.5, 1.0, 2.0, 4.0}) {
    SCOPED_TRACE(x);
    const dvec3 point(0, 0, x * r);
    const CameraView view = lookAt(point + dvec3(0, 10 * r, 17 * r), point, 0.002);
    const Mean seen = meanOf(render(scene, view, {16, 16}, 512));
    EXPECT_NEAR(seen.value, openSky(x), 0.02 * openSky(x) + 3.0 * seen.sigma);
    measured("relative error of the open sky", std::abs(seen.value / openSky(x) - 1.0),
             0.02 + 3.0 * seen.sigma / openSky(x));
  }
}

TEST_F(ScaleTest, CameraAMillionMetresOutSeesTheSmallThingBeforeIt) {
  const dvec3 far(1e6, 0, 1e6);
  Scene scene = plainScene(0);
  const Id ball = add(scene, at(far + dvec3(0, 0, -0.05)), Sphere{0.01}, emitter(2.0f));
  const CameraView view = lookAt(far, far + dvec3(0, 0, -1), 2.0 * std::atan(0.02 / 0.05));
  const Image image = render(scene, view, {32, 32}, 64);
  // The silhouette's half angle is asin(1/5); its disc on the film plane at distance 0.05 has radius 0.05
  // tan.
  const double radius = 0.05 * std::tan(std::asin(0.2)), share = pi * radius * radius / (0.04 * 0.04);
  EXPECT_NEAR(meanOf(image).value, 2.0 * share, 2e-3);
  const auto picked = renderer().pick(16, 16);
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->object, ball);
  EXPECT_NEAR(picked->position.z, 1e6 - 0.04, 1e-4);
}

/// Something seen and lit along the same slanting direction, so that nothing seen lies in shadow.
struct Headlit {
  const char* name;
  Shape shape;
  double tilt;      // of its +Y from the viewer
  double expected;  // mean radiance over a film of 0.4 x 0.4 m, for an albedo of 1 and an irradiance of pi
};

Scene headlit(const Headlit& c, const glm::dmat3& view) {
  Scene scene = plainScene(0);
  const dvec3 up = view[2] * std::cos(c.tilt) + view[1] * std::sin(c.tilt);
  const glm::dquat rotation =
      glm::normalize(glm::quat_cast(glm::dmat3(view[0], up, glm::cross(view[0], up))));
  add(scene, {dvec3(0.0), rotation, dvec3(1.0)}, c.shape, lambert(glm::vec3(1.0f)));
  addLight(scene, {dvec3(0.0), glm::quat_cast(view), dvec3(1.0)}, DirectionalLight{}, float(pi));
  return scene;
}

TEST_F(ScaleTest, NoSurfaceShadowsItselfFromAnyDistance) {
  const double film = 0.4;
  const Headlit cases[] = {{"plane", Plane{}, 0.9, std::cos(0.9)},
                           {"rect", Rect{{4, 4}}, 0.8, std::cos(0.8)},
                           {"disk", Disk{3}, 0.7, std::cos(0.7)},
                           {"box", Box{{4, 2, 4}}, 0.4, std::cos(0.4)},
                           {"cap", Cylinder{3, 2}, 0.4, std::cos(0.4)},
                           {"cylinder", Cylinder{0.1, 9}, pi / 2, 0.2 / film * pi / 4},
                           {"sphere", Sphere{0.15}, 0.0, pi * 0.0225 / (film * film) * 2 / 3}};
  const glm::dmat3 view = glm::mat3_cast(facing({1, -2, -3}));
  for (const Headlit& c : cases)
    for (const double distance : {100.0, 1e3, 1e4}) {
      SCOPED_TRACE(testing::Message() << c.name << " from " << distance << " m");
      const CameraView camera =
          lookAt(view[2] * distance, dvec3(0.0), 2.0 * std::atan(0.5 * film / distance));
      EXPECT_NEAR(meanOf(render(headlit(c, view), camera, {16, 16}, 64)).value, c.expected,
                  0.003 * c.expected);
    }
}

TEST_F(ScaleTest, MirrorShowsTheVirtualImage) {
  const dvec3 ball(0.4, 0.9, -1.0), onMirror(0, 0, -3), normal = glm::normalize(dvec3(-0.3, 0.4, 1.0));
  const dvec3 image = ball - 2.0 * glm::dot(ball - onMirror, normal) * normal;
  const CameraView view = lookAt({0, 0, 0}, image, 0.4);
  Scene real = plainScene(1);
  add(real, at(image), Sphere{0.3}, emitter(2.0f));
  const Image expected = render(real, view, {32, 32}, 64);
  Scene reflected = plainScene(1);
  add(reflected, at(ball), Sphere{0.3}, emitter(2.0f));
  add(reflected, {onMirror, facing(normal) * glm::angleAxis(-pi / 2, dvec3(1, 0, 0)), dvec3(1.0)}, Plane{},
      metal(0.0f));
  const Image seen = render(reflected, view, {32, 32}, 64);
  EXPECT_GT(meanOf(expected).value, 0.1);
  EXPECT_NEAR(meanOf(seen).value, meanOf(expected).value, 1e-3);
  EXPECT_LT(mrse(seen, expected), 1e-3);
}

}  // namespace
}  // namespace steradian
