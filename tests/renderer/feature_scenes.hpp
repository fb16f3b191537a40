// SPDX-License-Identifier: MIT
// Small scenes that between them need every feature of the tracer: who proves something of all features loops
// here.
#pragma once
#include <memory>
#include <vector>

#include "tests/renderer/scenes.hpp"

namespace steradian::scenes {

struct FeatureScene {
  const char* name;
  Scene scene;
  CameraView view;
};

inline CameraView frontView() {
  return lookAt({0, 0.8, 5}, {0, 0.2, 0}, 0.9);
}

/// A floor, a matt and a glossy ball: what the lights and skies below shine on.
inline Scene stage(int maxBounces) {
  Scene scene = plainScene(maxBounces);
  add(scene, at({0, -1, 0}), Plane{}, lambert({0.6f, 0.55f, 0.5f}));
  add(scene, at({-1.1, 0, 0}), Sphere{1.0}, plastic(0.5f, {0.7f, 0.3f, 0.2f}));
  add(scene, at({1.1, 0, 0.3}), Sphere{1.0}, metal(0.6f, {0.9f, 0.8f, 0.6f}));
  return scene;
}

/// 32x16 texels: a blue gradient with a small bright sun.
inline std::shared_ptr<const Image> skyImage() {
  Image sky{32, 16, 3, std::vector<float>(32 * 16 * 3)};
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) {
      const float up = 1.0f - float(y) / 16.0f;
      const bool sun = y == 4 && x == 20;
      sky.at(x, y)[0] = sun ? 60.0f : 0.2f + 0.2f * up;
      sky.at(x, y)[1] = sun ? 50.0f : 0.3f + 0.3f * up;
      sky.at(x, y)[2] = sun ? 40.0f : 0.4f + 0.6f * up;
    }
  return std::make_shared<const Image>(std::move(sky));
}

inline Scene lampsOfAllKinds() {
  Scene scene = stage(3);
  addLight(scene, {{0, 3, 0}, facing({0, -1, 0}), dvec3(1.0)}, RectLight{{1.5, 1.0}}, 6.0f);
  addLight(scene, at({2.5, 1.5, 1}), SphereLight{0.3}, 12.0f, {1.0f, 0.7f, 0.4f});
  addLight(scene, {{-2.5, 1.5, 1.5}, facing({2.5, -1.5, -1}), dvec3(1.0)}, DiskLight{0.5}, 6.0f);
  return scene;
}

inline Scene gradientSky() {
  Scene scene = stage(3);
  addLight(scene, at({0, 0, 0}), EnvironmentLight{glm::vec3(0.8f), glm::vec3(0.2f)}, 1.0f,
           {0.4f, 0.6f, 1.0f});
  return scene;
}

inline Scene sunnySky() {
  Scene scene = gradientSky();
  addLight(scene, {{0, 0, 0}, facing({1, -2, -1}), dvec3(1.0)}, DirectionalLight{0.05f}, 3.0f);
  return scene;
}

inline Scene imageSky() {
  Scene scene = stage(3);
  EnvironmentLight sky;
  sky.image = skyImage();
  addLight(scene, at({0, 0, 0}, {0, 1, 0}, 0.7), sky, 1.0f);
  return scene;
}

inline Scene glassAndSky(float roughness, float attenuationDistance) {
  Scene scene = gradientSky();
  Material glass = plastic(roughness, glm::vec3(1.0f));
  glass.transmission = 1.0f;
  glass.attenuationColor = {0.3f, 0.8f, 0.5f};
  glass.attenuationDistance = attenuationDistance;
  add(scene, at({0, 0.2, 1.6}), Sphere{0.6}, glass);
  add(scene, at({1.8, -0.3, 1.6}, {0, 1, 0}, 0.4), Box{{0.8, 1.2, 0.8}}, glass);
  add(scene, at({-1.8, 0, 1.8}, {1, 0, 0}, 1.4), Rect{{0.8, 1.0}}, glass);
  scene.render.maxBounces = 8;
  return scene;
}

inline Scene coatedAndTinted() {
  Scene scene = gradientSky();
  Material coated = plastic(0.6f, {0.7f, 0.1f, 0.1f});
  coated.clearcoat = 0.9f;
  coated.clearcoatRoughness = 0.1f;
  Material tinted = metal(0.3f, {0.6f, 0.6f, 0.7f});
  tinted.edgeTint = {0.5f, 0.7f, 1.0f};
  add(scene, at({0, 0.2, 1.6}), Sphere{0.5}, coated);
  add(scene, at({0, 1.4, 0.3}), Sphere{0.5}, tinted);
  return scene;
}

inline Scene manyLamps() {
  Scene scene = stage(2);
  for (int i = 0; i < 40; ++i)
    addLight(scene, at({4.0 * std::cos(i * 1.7), 0.5 + 0.08 * i, 3.0 * std::sin(i * 2.3)}), SphereLight{0.05},
             20.0f + float(10 * (i % 3)));
  scene.render.lightSamples = 3;
  return scene;
}

inline Scene clamped() {
  Scene scene = lampsOfAllKinds();
  scene.render.clamp = 0.5f;
  scene.render.maxBounces = 6;
  scene.render.russianRoulette = true;
  return scene;
}

inline CameraView throughALens() {
  CameraView view = frontView();
  view.lens.fNumber = 0.05;
  view.lens.focusDistance = 4.0;
  return view;
}

inline CameraView inParallel() {
  CameraView view = frontView();
  view.lens.projection = Projection::orthographic;
  view.lens.orthographicHeight = 4.0;
  return view;
}

inline std::vector<FeatureScene> featureScenes() {
  return {{"lamps of all kinds", lampsOfAllKinds(), frontView()},
          {"gradient sky", gradientSky(), frontView()},
          {"sunny sky", sunnySky(), frontView()},
          {"image sky", imageSky(), frontView()},
          {"clear glass", glassAndSky(0.0f, 0.0f), frontView()},
          {"rough coloured glass", glassAndSky(0.4f, 0.5f), frontView()},
          {"coated and tinted", coatedAndTinted(), frontView()},
          {"many lamps", manyLamps(), frontView()},
          {"clamped", clamped(), frontView()},
          {"through a lens", lampsOfAllKinds(), throughALens()},
          {"in parallel", lampsOfAllKinds(), inParallel()}};
}

}  // namespace steradian::scenes
