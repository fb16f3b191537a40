// SPDX-License-Identifier: MIT
// Scenes of more lamps than are tried at a vertex, and lamps whose colour is a temperature.
#include "tests/oracle/agreement_scenes.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian {
namespace {

using namespace scenes;

const CameraView kOverLamps = lookAt({0, 3.2, 4.2}, {0, 0.4, 0}, 0.65);

Scene unlit(int maxBounces = 2) {
  Scene scene = plainScene(maxBounces);
  scene.render.energyCompensation = false;
  add(scene, at({0, 0, 0}), Plane{}, lambert({0.5f, 0.4f, 0.3f}));
  add(scene, at({0, 0.6, 0}), Sphere{0.6}, plastic(0.5f, {0.2f, 0.5f, 0.8f}));
  return scene;
}
/// The i-th of a garland of n: a spiral around the ball, above the eye's line.
dvec3 garland(int i, int n) {
  const double turn = 2.0 * pi * 3.0 * i / n, radius = 1.0 + 1.5 * i / n;
  return {radius * std::cos(turn), 2.6 + 0.7 * std::sin(5.0 * turn), radius * std::sin(turn)};
}
glm::vec3 hue(int i) {
  return {0.3f + 0.1f * float(i % 7), 0.9f - 0.1f * float(i % 5), 0.4f + 0.2f * float(i % 3)};
}
template <class Kind>
Scene garlandOf(int n, const Kind& kind, float intensity) {
  Scene scene = unlit();
  for (int i = 0; i < n; ++i)
    addLight(scene, {garland(i, n), facing({0.2, -1, -0.1 * i / n}), dvec3(1.0)}, kind,
             intensity * float(1 + i % 4), hue(i));
  return scene;
}
/// Every kind that shines from somewhere, four of each.
Scene manyKinds() {
  Scene scene = unlit();
  constexpr int n = 36;
  for (int i = 0; i < n; ++i) {
    const Transform place{garland(i, n), facing({0.1, -1, 0.2}), dvec3(1.0)};
    const Material glow = emitter(2.0f, 0.5f * hue(i));
    switch (i % 9) {
      case 0:
        addLight(scene, place, PointLight{}, 1.5f, hue(i));
        break;
      case 1:
        addLight(scene, place, SpotLight{0.3f, 0.8f}, 4.0f, hue(i));
        break;
      case 2:
        addLight(scene, place, SphereLight{0.3}, 2.0f, hue(i));
        break;
      case 3:
        addLight(scene, place, RectLight{{0.7, 0.5}}, 3.0f, hue(i));
        break;
      case 4:
        addLight(scene, place, DiskLight{0.4}, 3.0f, hue(i));
        break;
      case 5:
        add(scene, place, Sphere{0.25}, glow);
        break;
      case 6:
        add(scene, place, Box{{0.5, 0.3, 0.4}}, glow);
        break;
      case 7:
        add(scene, place, Cylinder{0.2, 0.5}, glow);
        break;
      default:
        add(scene, {place.translation, place.rotation, dvec3(0.3)}, textures::shape(meshes::icosphere(0)),
            glow);
    }
  }
  return scene;
}
template <class Kind>
Scene ofTemperature(float kelvin, const Kind& kind, float intensity, const Transform& place) {
  Scene scene = unlit();
  addLight(scene, place, kind, intensity);
  std::get<Light>(scene.objects.back().content).temperature = kelvin;
  return scene;
}

}  // namespace

std::vector<AgreementCase> lampCases() {
  EnvironmentLight sky;
  sky.horizon = {0.6f, 0.8f, 1.0f};
  const Transform sun{{0, 0, 0}, facing({-1, -2, -1}), dvec3(1.0)};
  return {{"FortyPointLights", garlandOf(40, PointLight{}, 0.5f), kOverLamps, 8, 64, 1000},
          {"TwentyFourSphereLights", garlandOf(24, SphereLight{0.35}, 1.0f), kOverLamps},
          {"LampsOfAllKinds", manyKinds(), kOverLamps, 8, 64, 3000},
          {"LampOf2700Kelvin", ofTemperature(2700.0f, SphereLight{1.5}, 2.0f, at({1, 4, 1})), kOverLamps},
          {"SunOf5778Kelvin", ofTemperature(5778.0f, DirectionalLight{1.0f}, 3.0f, sun), kOverLamps},
          {"PointLightOf6500Kelvin", ofTemperature(6500.0f, PointLight{}, 30.0f, at({1, 4, 1})), kOverLamps},
          {"SkyOf12000Kelvin", ofTemperature(12000.0f, sky, 1.0f, at({0, 0, 0})), kOverLamps}};
}

}  // namespace steradian
