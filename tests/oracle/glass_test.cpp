// SPDX-License-Identifier: MIT
// The oracle's transmission: slabs, spheres, absorption and thin sheets in closed form.
#include "tests/oracle/measure.hpp"
#include "tests/oracle/microfacet.hpp"

namespace steradian::oracle {
namespace {

using namespace scenes;

Material glass(float roughness = 0.0f) {
  Material m;
  m.albedo = glm::vec3(1.0f);
  m.roughness = roughness;
  m.transmission = 1.0f;
  return m;
}

TEST(OracleGlass, SlabAtNormalIncidenceReflectsAThirteenth) {
  Scene scene = plainScene(40);
  add(scene, at({0, 0, 0}), Box{{4, 4, 0.5}}, glass());
  addLight(scene, {{0, 0, -3}, facing({0, 0, 1}), dvec3(1.0)}, RectLight{{4, 4}}, 1.0f);  // behind, facing +Z
  const CameraView view = lookAt({0, 0, 3}, {0, 0, 0}, 1e-3);
  expectMean(meanOf(trace(scene, view, 4, 4, 4000)), 12.0 / 13.0);
  for (Object& object : scene.objects)  // beside the eye, facing -Z
    if (std::holds_alternative<Light>(object.content))
      object.transform = {{0, 0, 3.1}, facing({0, 0, -1}), dvec3(1.0)};
  expectMean(meanOf(trace(scene, view, 4, 4, 8000)), 1.0 / 13.0, 0.02);
}

TEST(OracleGlass, ClearSolidsInAFurnaceAreInvisible) {
  const Shape shapes[] = {Sphere{1.0}, Box{{1, 1.5, 1}}, Cylinder{0.7, 1.2}};
  for (const Shape& shape : shapes) {
    Scene scene = plainScene(64);
    add(scene, at({0, 0, 0}, {1, 1, 0}, 0.5), shape, glass());
    addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
    const PictureMean mean = meanOf(trace(scene, lookAt({0, 0.5, 4}, {0, 0, 0}, 0.5), 4, 4, 500));
    // None is trapped: what comes in through a face or side leaves through its like.
    EXPECT_NEAR(mean.value, 1.0, 1e-6);
  }
}

TEST(OracleGlass, SlabsAbsorbByBeerAndLambert) {
  // T = (1 - R)^2 a / (1 - R^2 a^2) with a = colour^(thickness / distance)
  Material m = glass();
  m.attenuationColor = {0.5f, 0.25f, 1.0f};
  m.attenuationDistance = 0.4f;
  Scene scene = plainScene(40);
  add(scene, at({0, 0, 0}), Box{{4, 4, 0.8}}, m);
  addLight(scene, {{0, 0, -3}, facing({0, 0, 1}), dvec3(1.0)}, RectLight{{4, 4}}, 1.0f);
  const Estimate image = trace(scene, lookAt({0, 0, 3}, {0, 0, 0}, 1e-3), 4, 4, 4000);
  for (int channel = 0; channel < 3; ++channel) {
    const double a = std::pow(double(m.attenuationColor[channel]), 2.0), R = 0.04;
    expectMean(meanOf(image, channel), (1 - R) * (1 - R) * a / (1 - R * R * a * a));
  }
}

TEST(OracleGlass, ThinSheetsPassStraightOnAndTintOnce) {
  Material m = glass();
  m.albedo = {1.0f, 0.5f, 0.25f};
  const Shape shapes[] = {Rect{{2, 2}}, Disk{1.0}};
  for (const Shape& shape : shapes) {
    Scene scene = plainScene(4);
    add(scene, at({0, 0, 0}, {1, 0, 0}, pi / 2.0), shape, m);
    addLight(scene, {{0, 0, -3}, facing({0, 0, 1}), dvec3(1.0)}, RectLight{{4, 4}}, 1.0f);
    const Estimate image = trace(scene, lookAt({0, 0, 3}, {0, 0, 0}, 1e-3), 4, 4, 4000);
    for (int channel = 0; channel < 3; ++channel)
      expectMean(meanOf(image, channel), 12.0 / 13.0 * m.albedo[channel]);
  }
}

TEST(OracleGlass, RoughThinSheetsPassTheAlbedoOfTheirLobe) {
  // Reflection and its mirror image share the lobe: white surroundings show its single-scatter albedo.
  for (const float roughness : {0.5f, 0.9f}) {
    Scene scene = plainScene(4);
    scene.render.energyCompensation = false;
    add(scene, at({0, 0, 0}), Rect{{2, 2}}, glass(roughness));
    addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
    const double albedo = AlbedoTable(double(roughness) * roughness, 1.0).at(0.8).white;
    expectMean(meanOf(trace(scene, lookAt({0, 4, 3}, {0, 0, 0}, 1e-4), 4, 4, 60000)), albedo, 0.01);
  }
}

TEST(OracleGlass, RoughWaterOverALitGroundShinesAsTheClearOne) {
  // Radiance over squared index is even: 1 in the sky, 2.25 in the glass.
  Scene scene = plainScene(24);
  scene.render.energyCompensation = false;
  add(scene, at({0, 0, 0}), Plane{}, glass(0.45f));
  add(scene, at({0, -1, 0}), Plane{}, emitter(2.25f));
  addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
  const PictureMean rough = meanOf(trace(scene, lookAt({0, 3, 2}, {0, 0, 0}, 1e-3), 4, 4, 200000));
  EXPECT_NEAR(rough.value, 1.0, 4.0 * rough.sigma + 0.02);  // single scatter loses some
  EXPECT_LT(rough.sigma, 0.01);
}

TEST(OracleGlass, LookingOutOfAPlaneOfWaterShowsTotalReflection) {
  // The eye in the air sees the ground below the water: a bright bottom at 2 m, tinted by the path's length.
  Material water = glass();
  water.ior = 1.33f;
  water.attenuationColor = glm::vec3(0.5f);
  water.attenuationDistance = 2.0f;
  Scene scene = plainScene(40);
  add(scene, at({0, 0, 0}), Plane{}, water);
  add(scene, at({0, -2, 0}), Plane{}, emitter(1.0f));
  const double n = double(water.ior), mu = 0.6;
  const double sinT = 0.8 / n, cosT = std::sqrt(1.0 - sinT * sinT);
  const double s = (mu - n * cosT) / (mu + n * cosT), p = (n * mu - cosT) / (n * mu + cosT);
  const double expected = (1.0 - 0.5 * (s * s + p * p)) * std::pow(0.5, 1.0 / cosT) / (n * n);
  expectMean(meanOf(trace(scene, lookAt({0, 3, 4}, {0, 0, 0}, 1e-4), 4, 4, 4000)), expected);
}

}  // namespace
}  // namespace steradian::oracle
