// SPDX-License-Identifier: MIT
// The oracle against answers known in closed form: matt surfaces under every kind of light.
#include "tests/oracle/measure.hpp"

namespace steradian::oracle {
namespace {

using namespace scenes;

Scene ground(int bounces, const Material& material = lambert(glm::vec3(1.0f))) {
  Scene scene = plainScene(bounces);
  add(scene, at({0, 0, 0}), Plane{}, material);
  return scene;
}
PictureMean irradiance(const Scene& scene, const dvec3& point, int samples) {
  const PictureMean L = meanOf(trace(scene, closeUp(point), 4, 4, samples));
  return {L.value * pi, L.sigma * pi};
}

TEST(OracleClosedForm, EnclosuresOfAnyShapeShineByTheGeometricSeries) {
  const Shape shapes[] = {Sphere{1.0}, Box{{2, 1, 3}}, Cylinder{1.0, 2.0}};
  for (const Shape& shape : shapes) {
    Scene scene = plainScene(8);
    add(scene, at({0, 0, 0}, {1, 2, 3}, 0.7, {1.0, 0.8, 1.3}), shape, emitter(1.0f, glm::vec3(0.5f)));
    const auto image = trace(scene, lookAt({0.1, 0.05, 0}, {1, 0.3, 0.2}, 1.0), 4, 4, 4000);
    expectMean(meanOf(image), 2.0 * (1.0 - std::pow(0.5, 9)));
  }
}

TEST(OracleClosedForm, PointLightInASphereLightsItEvenly) {
  Scene scene = plainScene(24);
  add(scene, at({0, 0, 0}), Sphere{2.0}, lambert(glm::vec3(0.5f)));
  addLight(scene, at({0, 0, 0}), PointLight{}, 3.0f);
  expectMean(meanOf(trace(scene, lookAt({0.3, 0, 0}, {1, 1, 0}, 1.0), 4, 4, 2000)),
             0.5 * 3.0 / (pi * 4.0 * 0.5));
}

TEST(OracleClosedForm, TwoInfinitePlanesExchangeLight) {
  Scene scene = plainScene(60);
  add(scene, at({0, 0, 0}), Plane{}, emitter(1.0f, glm::vec3(0.5f)));
  add(scene, at({0, 1, 0}), Plane{}, lambert(glm::vec3(0.8f)));
  expectMean(meanOf(trace(scene, lookAt({0, 0.5, 0}, {1, 0.1, 0}, 0.3), 4, 4, 2000)), 1.0 / 0.6);
  expectMean(meanOf(trace(scene, lookAt({0, 0.5, 0}, {1, 0.9, 0}, 0.3), 4, 4, 2000)), 0.8 / 0.6);
}

TEST(OracleClosedForm, PunctualLightsFollowTheirLaws) {
  Scene point = ground(0);
  addLight(point, at({0, 1, 0}), PointLight{}, 1.0f);
  EXPECT_NEAR(irradiance(point, {1, 0, 0}, 4).value, 0.3535534, 1e-4);
  Scene parallel = ground(0);
  addLight(parallel, {{0, 50, 0}, facing({3, -4, 0}), dvec3(1.0)}, DirectionalLight{}, 10.0f);
  EXPECT_NEAR(irradiance(parallel, {5, 0, 7}, 4).value, 8.0, 1e-9);
  Scene spot = ground(0);
  addLight(spot, {{0, 2, 0}, facing({0, -1, 0}), dvec3(1.0)}, SpotLight{0.3f, 0.6f}, 5.0f);
  const double edge =
      (std::cos(0.45) - std::cos(double(0.6f))) / (std::cos(double(0.3f)) - std::cos(double(0.6f)));
  EXPECT_NEAR(irradiance(spot, {2.0 * std::tan(0.45), 0, 0}, 4).value,
              5.0 * edge * edge * std::pow(std::cos(0.45), 3) / 4.0, 1e-3);
  EXPECT_EQ(irradiance(spot, {2.0 * std::tan(0.7), 0, 0}, 4).value, 0.0);
}

TEST(OracleClosedForm, AreaLightsGiveTheirFormFactors) {
  const dvec3 origin(0.0);
  const auto lit = [](auto kind, const dvec3& place, const dvec3& towards) {
    Scene scene = ground(1);
    addLight(scene, {place, facing(towards), dvec3(1.0)}, kind, 1.0f);
    return scene;
  };
  expectMean(irradiance(lit(RectLight{{1, 1}}, {0, 1, 0}, {0, -1, 0}), origin, 20000), 0.7522746885);
  expectMean(irradiance(lit(DiskLight{1.0}, {0, 1, 0}, {0, -1, 0}), origin, 20000), pi / 2.0);
  expectMean(irradiance(lit(SphereLight{1.0}, {0, 2, 0}, {0, -1, 0}), origin, 20000), pi / 4.0);
  // Lambert's cosine for a sphere that lies askew: E = pi L (r / d)^2 cos
  expectMean(irradiance(lit(SphereLight{1.0}, {2, 2, 0}, {0, -1, 0}), origin, 40000),
             pi / 8.0 * std::sqrt(0.5));
  EXPECT_EQ(irradiance(lit(RectLight{{1, 1}}, {0, 1, 0}, {0, 1, 0}), origin, 1000).value, 0.0);
  EXPECT_EQ(irradiance(lit(DiskLight{1.0}, {0, 1, 0}, {0, 1, 0}), origin, 1000).value, 0.0);
}

TEST(OracleClosedForm, EmissiveShapesActLikeLightsOfBothSides) {
  Scene scene = ground(1);
  add(scene, at({0, 1, 0}), Rect{{1, 1}}, emitter(1.0f));
  expectMean(irradiance(scene, {0, 0, 0}, 20000), 0.7522746885);
  scene.render.maxBounces = 0;  // a surface's emission is one bounce away
  EXPECT_EQ(irradiance(scene, {0, 0, 0}, 100).value, 0.0);
}

TEST(OracleClosedForm, UnitSquaresExchangeTheirFormFactors) {
  const double height = 0.999;
  const CameraView square = lookAt({0, height, 0}, {0, 0, 0}, 2.0 * std::atan(0.5 / height));
  Scene parallel = ground(1);
  add(parallel, at({0, 1, 0}), Rect{{1, 1}}, emitter(1.0f));
  expectMean(meanOf(trace(parallel, square, 8, 8, 4000)), 0.1998248957, 0.006);
  Scene corner = ground(1);
  add(corner, at({-0.5, 0.5, 0}, {0, 0, 1}, pi / 2.0), Rect{{1, 1}}, emitter(1.0f));
  expectMean(meanOf(trace(corner, square, 8, 8, 4000)), 0.2000437761, 0.006);
}

TEST(OracleClosedForm, ASphereHidesItsShareOfTheSky) {
  Scene scene = ground(1);
  addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f);
  add(scene, at({0, 1, 0}), Sphere{1.0}, lambert(glm::vec3(0.0f)));
  for (const double x : {0.5, 2.0}) {
    const PictureMean L = meanOf(trace(scene, closeUp(dvec3(0.6, 0, 0.8) * x), 4, 4, 20000));
    expectMean(L, 1.0 - std::pow(1.0 + x * x, -1.5));
  }
}

TEST(OracleClosedForm, TheSkyGradientGivesItsIrradiance) {
  // E = 2 pi int (h + (1 - h) y) y dy = pi (h + (1 - h) 2 / 3)
  EnvironmentLight sky;
  sky.horizon = glm::vec3(0.25f);
  sky.ground = glm::vec3(9.0f);
  Scene scene = ground(1);
  addLight(scene, at({0, 0, 0}), sky, 2.0f);
  expectMean(irradiance(scene, {0, 0, 0}, 20000), 2.0 * pi * (0.25 + 0.75 * 2.0 / 3.0));
  // Seen straight: zenith, horizon, nadir
  Scene empty = plainScene(0);
  addLight(empty, at({0, 0, 0}), sky, 2.0f);
  const auto seen = [&](const dvec3& to) {
    return meanOf(trace(empty, lookAt({0, 0, 0}, to, 1e-5), 1, 1, 4)).value;
  };
  EXPECT_NEAR(seen({0, 1, 0}), 2.0, 1e-4);
  EXPECT_NEAR(seen({1, 0, 0}), 0.5, 1e-4);
  EXPECT_NEAR(seen({0, -1, 0}), 18.0, 1e-3);
}

TEST(OracleClosedForm, TheSkyImageLiesAsItsContractSays) {
  // Columns: left half red, right half green; top half twice as bright. Its centre lies along -Z.
  auto image = std::make_shared<Image>(Image{2, 2, 3, {2, 0, 0, 0, 2, 0, 1, 0, 0, 0, 1, 0}});
  EnvironmentLight sky;
  sky.image = image;
  Scene scene = plainScene(0);
  const auto seen = [&](const dvec3& to) {
    return trace(scene, lookAt({0, 0, 0}, to, 1e-3), 1, 1, 4).mean[0];
  };
  const Id id = addLight(scene, at({0, 0, 0}), sky, 3.0f);
  EXPECT_EQ(seen({1, 0.2, -1}), dvec3(0, 6, 0));  // +X is to the right of -Z
  EXPECT_EQ(seen({-1, -0.2, -1}), dvec3(3, 0, 0));
  EXPECT_EQ(seen({1, -0.2, 1}), dvec3(0, 3, 0));
  // Turned a quarter to the left about +Y, its centre lies along -X.
  for (Object& object : scene.objects)
    if (object.id == id) object.transform.rotation = glm::angleAxis(pi / 2.0, dvec3(0, 1, 0));
  EXPECT_EQ(seen({-1, 0.2, -0.5}), dvec3(0, 6, 0));
  EXPECT_EQ(seen({-1, 0.2, 0.5}), dvec3(6, 0, 0));
}

TEST(OracleClosedForm, ASunDiscGivesTheIlluminanceOfItsParallelLight) {
  Scene scene = ground(1);
  addLight(scene, {{0, 0, 0}, facing({3, -4, 0}), dvec3(1.0)}, DirectionalLight{0.8f}, 10.0f);
  // A disc wholly above the horizon: Lambert's E = pi L sin^2 cos, with L = E0 / (pi sin^2)
  expectMean(irradiance(scene, {0, 0, 0}, 60000), 8.0);
}

TEST(OracleClosedForm, MattSphereUnderFrontalLightReflectsTwoThirds) {
  Scene scene = plainScene(0);
  add(scene, at({0, 0, 0}), Sphere{1.0}, lambert(glm::vec3(0.6f)));
  addLight(scene, {{0, 0, 0}, facing({0, 0, -1}), dvec3(1.0)}, DirectionalLight{}, 2.0f);
  CameraView view = lookAt({0, 0, 50}, {0, 0, 0}, 1.0);
  view.lens.projection = Projection::orthographic;
  view.lens.orthographicHeight = 2.2;
  expectMean(meanOf(trace(scene, view, 16, 16, 400)), pi / (2.2 * 2.2) * 0.6 / pi * 2.0 * 2.0 / 3.0);
}

TEST(OracleClosedForm, AThinLensBlursByTheCircleOfConfusion) {
  // Half-space edge at distance D, focus at F: the opening's disc of radius R, seen through a point at F, has
  // the radius R |D - F| / F at D. The share of it beyond the edge is the blurred edge's height.
  Scene scene = plainScene(0);
  add(scene, at({5, 0, -4}, {1, 0, 0}, pi / 2.0), Rect{{10, 20}}, emitter(1.0f));  // covers x > 0
  CameraView view = lookAt({0, 0, 0}, {0, 0, -1}, 0.2);
  view.lens.focusDistance = 2.0;
  view.lens.fNumber = 0.5 * 0.024 / std::tan(0.1) / (2.0 * 0.05);  // opening of radius 0.05
  const Estimate image = trace(scene, view, 16, 1, 4000);
  const double radius = 0.05;                      // of the blur at 4 m
  const double pixel = 2.0 * 4.0 * std::tan(0.1);  // metres at 4 m
  double sum = 0.0;
  for (const dvec3& p : image.mean) sum += p.x;
  EXPECT_NEAR(sum / 16.0, 0.5, 0.01);
  // In the pixel right of the edge: mean over x of the disc's share at >= 0, = 1 - int_0^R (1 - share(x)) dx
  // / pixel
  const double missing = 2.0 * radius / (3.0 * pi);  // int_0^R of a unit disc's segment share, R * 2 / (3 pi)
  EXPECT_NEAR(image.mean[8].x, 1.0 - missing / pixel, 4.0 * std::sqrt(image.variance[8].x / 4000.0));
  EXPECT_GT(image.variance[8].x, 1e-3);
}

}  // namespace
}  // namespace steradian::oracle
