// SPDX-License-Identifier: MIT
#include "tests/oracle/agreement_scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

const CameraView kView = lookAt({0, 1.6, 5}, {0, 0.7, 0}, 0.65);
/// From above, without the horizon: brute force would not find a lamp from there.
const CameraView kDown = lookAt({0, 3.2, 4.2}, {0, 0.6, 0}, 0.65);

Transform shining(const dvec3& place, const dvec3& direction) {
  return {place, facing(direction), dvec3(1.0)};
}

/// A matt ground of a warm grey.
Scene stage(int maxBounces = 3) {
  Scene scene = plainScene(maxBounces);
  scene.render.energyCompensation = false;
  add(scene, at({0, 0, 0}), Plane{}, lambert({0.5f, 0.4f, 0.3f}));
  return scene;
}
/// A ball of 1.6 m on the ground, the subject of most scenes.
Scene ball(const Material& material, int maxBounces = 3) {
  Scene scene = stage(maxBounces);
  add(scene, at({0, 0.8, 0}), Sphere{0.8}, material);
  return scene;
}
Scene withSky(Scene scene, float nit = 1.0f) {
  EnvironmentLight sky;
  sky.horizon = {0.6f, 0.8f, 1.0f};
  sky.ground = glm::vec3(0.3f);
  addLight(scene, at({0, 0, 0}), sky, nit, {1.0f, 0.9f, 0.8f});
  return scene;
}
Scene withPoint(Scene scene) {
  addLight(scene, at({2, 3, 3}), PointLight{}, 20.0f, {1.0f, 0.8f, 0.6f});
  return scene;
}
/// A wide lamp of an emissive shape above the scene.
Scene withLamp(Scene scene) {
  add(scene, at({1, 5, 1}), Sphere{2.0}, emitter(2.0f));
  return scene;
}
template <class Kind>
Scene withLight(Scene scene, const Transform& place, Kind kind, float intensity) {
  addLight(scene, place, kind, intensity, {1.0f, 0.8f, 0.6f});
  return scene;
}

Scene compensated(Scene scene) {
  scene.render.energyCompensation = true;
  return scene;
}

std::shared_ptr<const Image> skyImage() {
  auto image = std::make_shared<Image>(Image{8, 4, 3, std::vector<float>(8 * 4 * 3)});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x)
      for (int c = 0; c < 3; ++c) image->at(x, y)[c] = 0.2f + float((3 * x + 5 * y + 2 * c * x) % 7) / 3.0f;
  image->at(2, 1)[0] = 8.0f;
  return image;
}

}  // namespace

std::vector<AgreementCase> punctualCases() {
  const Material matt = lambert({0.2f, 0.5f, 0.8f});
  const auto lit = [&](const Transform& place, auto kind, float intensity) {
    return withLight(ball(matt), place, kind, intensity);
  };
  return {
      {"LambertUnderAPointLight", withPoint(ball(matt)), kDown},
      {"LambertUnderASpot", lit(shining({2, 4, 2}, {-2, -3.5, -2}), SpotLight{0.15f, 0.4f}, 60.0f), kDown},
      {"LambertUnderParallelLight", lit(shining({0, 0, 0}, {-1, -2, -1}), DirectionalLight{}, 3.0f), kDown},
      {"PlasticUnderAPointLight", withPoint(ball(plastic(0.3f, {0.2f, 0.5f, 0.8f}))), kDown},
      {"MetalUnderAPointLight", withPoint(ball(metal(0.45f, {0.9f, 0.7f, 0.4f}))), kDown}};
}

std::vector<AgreementCase> shapeCases() {
  const auto with = [](const Transform& place, const Shape& shape) {
    Scene scene = stage();
    add(scene, place, shape, plastic(0.6f, {0.2f, 0.5f, 0.8f}));
    return withPoint(withLamp(scene));
  };
  const dvec3 axis(1, 2, 0.5);
  return {{"Sphere", with(at({0, 0.8, 0}), Sphere{0.8}), kDown},
          {"Ellipsoid", with(at({0, 0.8, 0}, axis, 0.7, {1.2, 0.5, 0.8}), Sphere{0.8}), kDown},
          {"Box", with(at({0, 0.8, 0}, axis, 0.7), Box{{1.4, 0.8, 1.1}}), kDown},
          {"Cylinder", with(at({0, 0.8, 0}, axis, 0.9), Cylinder{0.6, 1.3}), kDown},
          {"Rect", with(at({0, 0.9, 0}, axis, 0.6), Rect{{1.5, 2.0}}), kDown},
          {"Disk", with(at({0, 0.9, 0}, {1, 0, 0.3}, 0.8), Disk{1.0}), kDown},
          {"EllipticCylinder", with(at({0, 0.8, 0}, axis, 0.9, {0.6, 1.2, 1.4}), Cylinder{0.5, 1.3}), kDown},
          {"Plane", with(at({0, 0, -1}, {1, 0, 0}, 1.3), Plane{}), kDown}};
}

std::vector<AgreementCase> lightCases() {
  const Material subject = plastic(0.5f, {0.2f, 0.5f, 0.8f});
  const Scene dark = ball(subject);
  const auto lit = [&](const Transform& place, auto kind, float intensity) {
    return withLight(dark, place, kind, intensity);
  };
  const auto emissive = [&](const Transform& place, const Shape& shape) {
    Scene scene = dark;
    add(scene, place, shape, emitter(3.0f, glm::vec3(0.3f)));
    return scene;
  };
  EnvironmentLight image;
  image.image = skyImage();
  const Transform above = shining({0.5, 3, 0.5}, {-0.1, -1, -0.1});
  return {
      {"EmissiveSphere", withLamp(dark), kDown},
      {"EmissiveBox", emissive(at({1.5, 3, 1}, {1, 1, 1}, 0.6), Box{{2, 1.5, 1}}), kDown},
      {"EmissiveRect", emissive(at({0.5, 3, 0.5}, {1, 1, 1}, 0.6), Rect{{3, 3}}), kDown},
      {"EmissiveDisk", emissive(at({0.5, 3, 0.5}, {1, 1, 1}, 0.6), Disk{1.6}), kDown},
      {"EmissiveCylinder", emissive(at({1.0, 3, 0.5}, {1, 1, 1}, 0.6), Cylinder{0.9, 2.0}), kDown},
      {"SphereLight", lit(at({1, 4, 1}), SphereLight{1.5}, 2.0f), kDown},
      {"EllipsoidLight", lit(at({1, 4, 1}, {1, 1, 1}, 0.5, {1.5, 0.6, 1.0}), SphereLight{1.5}, 2.0f), kDown},
      {"RectLight", lit(above, RectLight{{3, 2.5}}, 2.0f), kDown},
      {"DiskLight", lit(above, DiskLight{1.6}, 2.0f), kDown},
      {"SunDisc", lit(shining({0, 0, 0}, {-1, -2, -1}), DirectionalLight{1.0f}, 3.0f), kDown},
      {"Sky", withSky(dark), kView},
      {"SkyImage", lit(at({0, 0, 0}, {0, 1, 0}, 0.6), image, 1.0f), kView}};
}

std::vector<AgreementCase> materialCases() {
  Material mixed = plastic(0.5f, {0.9f, 0.5f, 0.2f});
  mixed.metallic = 0.5f;
  mixed.specular = 0.6f;
  mixed.ior = 1.9f;
  Material coated = plastic(0.7f, {0.9f, 0.5f, 0.2f});
  coated.clearcoat = 0.8f;
  Material roughCoat = coated;
  roughCoat.clearcoatRoughness = 0.4f;
  Material edge = metal(0.4f, {0.9f, 0.7f, 0.4f});
  edge.edgeTint = {0.2f, 0.5f, 0.9f};
  return {{"Plastic", withSky(ball(plastic(0.3f, {0.2f, 0.5f, 0.8f}))), kView},
          {"PolishedPlastic", withSky(ball(plastic(0.0f, {0.2f, 0.5f, 0.8f}))), kView},
          {"Metal", withSky(ball(metal(0.4f, {0.9f, 0.7f, 0.4f}))), kView},
          {"Mirror", withSky(ball(metal(0.0f, {0.9f, 0.7f, 0.4f}))), kView},
          {"MetalMixedWithPlastic", withSky(ball(mixed)), kView},
          {"CompensatedMetal", compensated(withSky(ball(metal(0.9f, {0.9f, 0.7f, 0.4f})))), kView},
          {"CompensatedPlastic", compensated(withSky(ball(plastic(0.8f, {0.9f, 0.5f, 0.2f})))), kView},
          {"CompensatedMixture", compensated(withSky(ball(mixed))), kView},
          {"Clearcoat", withSky(ball(coated)), kView},
          {"RoughClearcoat", withSky(ball(roughCoat)), kView},
          {"CompensatedRoughClearcoat", compensated(withSky(ball(roughCoat))), kView},
          {"EdgeTint", withSky(ball(edge)), kView}};
}

std::vector<AgreementCase> glassCases() {
  Material glass = plastic(0.0f, glm::vec3(1.0f));
  glass.transmission = 1.0f;
  Material amber = glass;
  amber.attenuationColor = {0.9f, 0.5f, 0.2f};
  amber.attenuationDistance = 0.8f;
  Material frosted = glass;
  frosted.roughness = 1.0f;
  Material satin = glass;
  satin.roughness = 0.65f;
  Material milky = plastic(0.5f, {0.9f, 0.8f, 0.6f});
  milky.transmission = 0.5f;
  Material milkGlass = milky;
  milkGlass.roughness = 0.0f;
  Material tinted = glass;
  tinted.albedo = {0.9f, 0.5f, 0.2f};
  const auto sheet = [](const Material& material, const Shape& shape) {
    Scene scene = stage(24);
    add(scene, at({0, 0.9, 0.3}, {1, 0, 0.2}, 1.2), shape, material);
    add(scene, at({0, 0.8, -1}), Sphere{0.6}, lambert({0.2f, 0.5f, 0.8f}));
    return withSky(scene);
  };
  const auto solid = [](const Material& material, const Shape& shape) {
    Scene scene = stage(24);
    add(scene, at({0, 0.85, 0}, {1, 2, 0.5}, 0.5), shape, material);
    return withSky(scene);
  };
  // One crossing alone, to a lamp at the bottom: two narrow lobes in a row are beyond brute force.
  const auto pool = [](const Material& material) {
    Scene scene = plainScene(3);
    scene.render.energyCompensation = false;
    add(scene, at({0, 0, 0}), Plane{}, material);
    add(scene, at({0, -0.8, 0}), Box{{1.6, 0.6, 1.2}}, emitter(3.0f));
    return withSky(scene);
  };
  return {{"GlassSphere", withSky(ball(glass, 24)), kView},
          {"GlassBox", solid(glass, Box{{1.2, 0.9, 1.0}}), kView},
          {"GlassCylinder", solid(glass, Cylinder{0.6, 1.2}), kView},
          {"AbsorbingSphere", withSky(ball(amber, 24)), kView},
          {"AbsorbingBox", solid(amber, Box{{1.2, 0.9, 1.0}}), kView},
          {"TintedSphere", withSky(ball(tinted, 24)), kView},
          {"ThinGlassRect", sheet(tinted, Rect{{2.0, 1.6}}), kView},
          {"ThinGlassDisk", sheet(glass, Disk{1.0}), kView},
          {"RoughThinGlass", sheet(satin, Rect{{2.0, 1.6}}), kView},
          {"CompensatedRoughThinGlass", compensated(sheet(satin, Disk{1.0})), kView},
          {"CompensatedGlassSphere", compensated(withSky(ball(glass, 24))), kView},
          {"CompensatedHalfTransmission", compensated(pool(milky)), kDown},
          {"CompensatedMilkGlassSphere", compensated(withSky(ball(milkGlass, 24))), kView},
          {"CompensatedRoughGlassPool", compensated(pool(frosted)), kDown, 10, 64, 20000},
          {"CompensatedRoughGlassSphere", compensated(withSky(ball(frosted, 12))), kView, 5, 256, 40000},
          {"RoughGlassPool", pool(satin), kDown, 10, 64, 20000},
          {"RoughGlassSphere", withSky(ball(frosted, 12)), kView, 5, 256, 40000},
          {"HalfTransmission", pool(milky), kDown}};
}

std::vector<AgreementCase> cameraCases() {
  const Scene scene = withPoint(withSky(ball(lambert({0.2f, 0.5f, 0.8f}))));
  CameraView lens = kView;
  lens.lens.focusDistance = 4.0;
  lens.lens.fNumber = 0.15;
  CameraView parallel = kView;
  parallel.lens.projection = Projection::orthographic;
  parallel.lens.orthographicHeight = 2.6;
  Scene filtered = scene;
  filtered.render.filter = PixelFilter::blackmanHarris;
  return {{"ThinLens", scene, lens},
          {"Orthographic", scene, parallel},
          {"BlackmanHarrisFilter", filtered, kView}};
}

}  // namespace steradian
