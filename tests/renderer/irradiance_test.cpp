// SPDX-License-Identifier: MIT
// Light that arrives straight from a source at a point of a matt ground: closed forms, no hand-tuned numbers.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

/// Sees `half` metres to each side of a ground point, from 5 m away.
CameraView spotOfGround(const dvec3& point, double half = 2e-4) {
  return lookAt(point + dvec3(3.0, 0.6, 4.0), point, 2.0 * half / 5.0);
}

Scene ground(int bounces) {
  Scene scene = plainScene(bounces);
  add(scene, at({0, 0, 0}), Plane{}, lambert(glm::vec3(1.0f)));
  return scene;
}

class IrradianceTest : public RendererTest {
 protected:
  /// Irradiance of the ground at a point, whose albedo is 1.
  Mean irradiance(const Scene& scene, const dvec3& point, int samples) {
    const Mean radiance = meanOf(render(scene, spotOfGround(point), {16, 16}, samples));
    return {radiance.value * pi, radiance.sigma * pi};
  }
};

TEST_F(IrradianceTest, PointLightFollowsCosineOverSquaredDistance) {
  Scene scene = ground(0);
  addLight(scene, at({0, 1, 0}), PointLight{}, 1.0f);
  EXPECT_NEAR(irradiance(scene, {1, 0, 0}, 4).value, 0.3535534, 1e-5);
  EXPECT_NEAR(irradiance(scene, {0, 0, 0}, 4).value, 1.0, 1e-5);
  EXPECT_NEAR(irradiance(scene, {-3, 0, 4}, 4).value, std::pow(26.0, -1.5), 1e-5);
}

TEST_F(IrradianceTest, LightsAddUpColoursIncluded) {
  Scene scene = ground(0);
  addLight(scene, at({0, 1, 0}), PointLight{}, 2.0f, {1.0f, 0.0f, 0.0f});
  addLight(scene, at({0, 2, 0}), PointLight{}, 8.0f, {0.0f, 1.0f, 0.5f});
  const Image image = render(scene, spotOfGround({0, 0, 0}), {8, 8}, 4);
  EXPECT_NEAR(meanOf(image, 0).value * pi, 2.0, 1e-5);
  EXPECT_NEAR(meanOf(image, 1).value * pi, 2.0, 1e-5);
  EXPECT_NEAR(meanOf(image, 2).value * pi, 1.0, 1e-5);
}

TEST_F(IrradianceTest, SpotLightFadesBetweenItsConesAsTheExtensionDefines) {
  Scene scene = ground(0);
  const float inner = 0.3f, outer = 0.6f;
  const Transform down{{0, 2, 0}, facing({0, -1, 0}), dvec3(1.0)};
  addLight(scene, down, SpotLight{inner, outer}, 5.0f);
  for (const double angle : {0.0, 0.25, 0.35, 0.45, 0.55, 0.7}) {
    SCOPED_TRACE(angle);
    const double edge =
        (std::cos(angle) - std::cos(double(outer))) / (std::cos(double(inner)) - std::cos(double(outer)));
    const double fade = std::clamp(edge, 0.0, 1.0);
    const double expected = 5.0 * fade * fade * std::pow(std::cos(angle), 3) / 4.0;
    EXPECT_NEAR(irradiance(scene, {2.0 * std::tan(angle), 0, 0}, 4).value, expected, 1e-3 * expected);
  }
}

TEST_F(IrradianceTest, DirectionalLightFollowsTheCosineAlone) {
  Scene scene = ground(0);
  addLight(scene, {{0, 50, 0}, facing({3, -4, 0}), dvec3(1.0)}, DirectionalLight{}, 10.0f);
  EXPECT_NEAR(irradiance(scene, {0, 0, 0}, 4).value, 8.0, 1e-4);
  EXPECT_NEAR(irradiance(scene, {1e4, 0, -1e4}, 4).value, 8.0, 1e-4);
}

TEST_F(IrradianceTest, NothingArrivesThroughABlockerOrFromBelow) {
  const Shape blockers[] = {Sphere{0.2}, Box{{0.3, 0.3, 0.3}}, Rect{{0.3, 0.3}}, Disk{0.2},
                            Cylinder{0.2, 0.1}};
  for (const Shape& shape : blockers) {
    Scene scene = ground(0);
    addLight(scene, at({0, 1, 0}), PointLight{}, 1.0f);
    add(scene, at({0, 0.5, 0}), shape, lambert(glm::vec3(0.5f)));
    EXPECT_EQ(irradiance(scene, {0, 0, 0}, 4).value, 0.0) << shape.index();
    EXPECT_NEAR(irradiance(scene, {1, 0, 0}, 4).value, 0.3535534, 1e-5) << shape.index();
  }
  Scene scene = ground(0);
  addLight(scene, at({0, -1, 0}), PointLight{}, 1.0f);
  addLight(scene, {{0, 0, 0}, facing({0, 1, 0}), dvec3(1.0)}, DirectionalLight{}, 1.0f);
  EXPECT_EQ(irradiance(scene, {0, 0, 0}, 4).value, 0.0);
}

TEST_F(IrradianceTest, DirectionalLightIsBlockedAtAnyDistance) {
  for (const double height : {0.5, 50.0, 1e5}) {
    Scene scene = ground(0);
    addLight(scene, {{0, 0, 0}, facing({0, -1, 0}), dvec3(1.0)}, DirectionalLight{}, 1.0f);
    add(scene, at({0, height, 0}), Disk{0.1}, lambert(glm::vec3(0.5f)));
    EXPECT_EQ(irradiance(scene, {0, 0, 0}, 4).value, 0.0) << height;
    EXPECT_NEAR(irradiance(scene, {0.5, 0, 0}, 4).value, 1.0, 1e-5) << height;
  }
}

TEST_F(IrradianceTest, MattSphereUnderFrontalLightReflectsTwoThirds) {
  Scene scene = plainScene(0);
  add(scene, at({0, 0, 0}), Sphere{1.0}, lambert(glm::vec3(0.6f)));
  addLight(scene, {{0, 0, 0}, facing({0, 0, -1}), dvec3(1.0)}, DirectionalLight{}, 2.0f);
  const double distance = 2000.0;
  const Image image =
      render(scene, lookAt({0, 0, distance}, {0, 0, 0}, 2.0 * std::atan(1.1 / distance)), {64, 64}, 64);
  const double discShare = pi / (2.2 * 2.2);  // of the film
  EXPECT_NEAR(meanOf(image).value, discShare * 0.6 / pi * 2.0 * 2.0 / 3.0, 1e-4);
}

TEST_F(IrradianceTest, ManyLightsPickedByStrataStayUnbiased) {
  Scene scene = ground(0);
  double expected = 0.0;
  for (int i = 0; i < 37; ++i) {
    const dvec3 p(3.0 * std::cos(i * 1.7), 0.5 + 0.1 * i, 3.0 * std::sin(i * 2.3));
    addLight(scene, at(p), PointLight{}, float(1 + i % 5));
    expected += (1 + i % 5) * p.y / std::pow(glm::dot(p, p), 1.5);
  }
  for (const int lightSamples : {1, 5, 16}) {
    scene.render.lightSamples = lightSamples;
    const Mean sampled = irradiance(scene, {0, 0, 0}, 512);
    EXPECT_NEAR(sampled.value, expected, 3.0 * sampled.sigma) << lightSamples;
    EXPECT_LT(sampled.sigma, 0.01 * expected);
  }
}

TEST_F(IrradianceTest, row34_rect_disk_and_sphere_lights_give_their_form_factors) {
  Scene rect = ground(1);
  add(rect, at({0, 1, 0}), Rect{{1, 1}}, emitter(1.0f));
  expectMean(irradiance(rect, {0, 0, 0}, 1024), 0.7522746885, 0.005);
  Scene disk = ground(1);
  add(disk, at({0, 1, 0}), Disk{1.0}, emitter(1.0f));
  expectMean(irradiance(disk, {0, 0, 0}, 1024), pi / 2.0, 0.005);
  Scene sphere = ground(1);
  add(sphere, at({0, 2, 0}), Sphere{1.0}, emitter(1.0f));
  expectMean(irradiance(sphere, {0, 0, 0}, 1024), 0.785398, 0.005);
}

TEST_F(IrradianceTest, row34_unit_squares_exchange_their_form_factors) {
  // A pinhole maps its film evenly onto a parallel plane, so the mean over the film is the mean over the
  // square.
  const double height = 0.999;
  const CameraView square = lookAt({0, height, 0}, {0, 0, 0}, 2.0 * std::atan(0.5 / height));
  Scene parallel = ground(1);
  add(parallel, at({0, 1, 0}), Rect{{1, 1}}, emitter(1.0f));
  expectMean(meanOf(render(parallel, square, {32, 32}, 256)), 0.1998248957, 0.005);
  Scene corner = ground(1);
  add(corner, at({-0.5, 0.5, 0}, {0, 0, 1}, pi / 2.0), Rect{{1, 1}}, emitter(1.0f));
  expectMean(meanOf(render(corner, square, {32, 32}, 256)), 0.2000437761, 0.005);
}

TEST_F(IrradianceTest, row34_unit_sphere_on_a_plane_hides_its_share_of_the_sky) {
  Scene scene = ground(1);
  add(scene, at({0, 0, 0}), Sphere{1000.0}, emitter(1.0f));
  add(scene, at({0, 1, 0}), Sphere{1.0}, lambert(glm::vec3(0.0f)));
  for (const double x : {0.5, 1.0, 2.0, 4.0}) {
    SCOPED_TRACE(x);
    const dvec3 point = dvec3(0.6, 0, 0.8) * x;
    expectMean(meanOf(render(scene, spotOfGround(point), {16, 16}, 1024)), 1.0 - std::pow(1.0 + x * x, -1.5),
               0.005);
  }
}

}  // namespace
}  // namespace steradian
