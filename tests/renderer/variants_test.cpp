// SPDX-License-Identifier: MIT
// A pipeline that models only what a scene needs must give the picture of the one that models everything.
#include <set>
#include <string_view>
#include <thread>

#include "tests/renderer/feature_scenes.hpp"
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian {
namespace {

using namespace scenes;

Scene ballsUnderALamp() {
  Scene scene = plainScene(3);
  add(scene, at({0, 0, 0}), Sphere{1.0}, lambert({0.8f, 0.2f, 0.1f}));
  add(scene, at({1.5, 0.2, 0.5}), Sphere{0.6}, lambert({0.1f, 0.2f, 0.9f}));
  addLight(scene, at({2, 4, 3}), PointLight{}, 30.0f);
  return scene;
}

Scene planesUnderASpot() {
  Scene scene = plainScene(3);
  add(scene, at({0, -1, 0}), Plane{}, plastic(0.4f, glm::vec3(0.6f)));
  add(scene, at({0, 0, -3}, {1, 0, 0}, pi / 2), Plane{}, plastic(0.8f, {0.7f, 0.4f, 0.2f}));
  addLight(scene, {{0, 3, 2}, facing({0, -1, -0.8}), dvec3(1.0)}, SpotLight{0.2f, 0.7f}, 40.0f);
  return scene;
}

Scene wallsThatFaceAllAxes() {  // and one that faces none
  Scene scene = plainScene(4);
  const Id white = add(scene, lambert(glm::vec3(0.7f)));
  add(scene, at({0, -2, 0}), Plane{}, plastic(0.3f, {0.3f, 0.6f, 0.4f}));
  add(scene, at({0, 3, 0}, {1, 0, 0}, pi), Plane{}, white);
  add(scene, at({-3, 0, 0}, {0, 0, 1}, -pi / 2), Plane{}, lambert({0.8f, 0.2f, 0.2f}));
  add(scene, at({3, 0, 0}, {0, 0, 1}, pi / 2), Plane{}, white);
  add(scene, at({0, 0, -3}, {1, 0, 0}, pi / 2), Plane{}, metal(0.2f, {0.9f, 0.8f, 0.6f}));
  add(scene, at({0, 0, 6}, {1, 0, 0}, -pi / 2), Plane{}, white);
  add(scene, at({0, 0, -2}, {1, 0.2, 0}, 0.8), Plane{}, lambert({0.2f, 0.3f, 0.8f}));
  add(scene, at({0, 0, 0}), Sphere{0.8}, plastic(0.2f, {0.8f, 0.5f, 0.2f}));
  addLight(scene, at({2, 2.5, 2}), PointLight{}, 12.0f);
  addLight(scene, {{-2, 2, 3}, facing({1, -1, -2}), dvec3(1.0)}, SpotLight{0.3f, 0.8f}, 20.0f);
  return scene;
}

Scene planetInTheSun() {
  Scene scene = plainScene(2);
  add(scene, at({0, -6e6 - 1.0, 0}), Sphere{6e6}, lambert(glm::vec3(0.5f)));
  add(scene, at({0, 0, 0}), Sphere{1.0}, metal(0.3f, {0.9f, 0.7f, 0.5f}));
  addLight(scene, {{0, 0, 0}, facing({1, -2, -1}), dvec3(1.0)}, DirectionalLight{}, 3.0f);
  return scene;
}

Scene boxesAndGlowingRect() {
  Scene scene = plainScene(4);
  add(scene, at({0, -1, 0}), Box{{6, 0.2, 6}}, lambert(glm::vec3(0.7f)));
  add(scene, at({-0.5, 0, 0}, {0, 1, 0}, 0.5), Box{{1, 2, 1}}, lambert({0.3f, 0.7f, 0.3f}));
  add(scene, at({0, 3, 0}), Rect{{3, 3}}, emitter(4.0f));
  return scene;
}

Scene turnedAndStretched() {
  Scene scene = plainScene(3);
  add(scene, at({0, -0.5, 0}, {1, 0, 0}, 0.3), Disk{3.0}, plastic(0.3f, glm::vec3(0.6f)));
  add(scene, at({-1, 0.3, 0}, {1, 0, 1}, 0.6), Cylinder{0.5, 1.2}, plastic(0.5f, {0.8f, 0.3f, 0.3f}));
  add(scene, at({1, 0.4, 0}, {0, 1, 1}, 0.8, {0.9, 0.4, 0.6}), Sphere{1.0}, metal(0.4f, {0.9f, 0.9f, 0.5f}));
  addLight(scene, at({1, 4, 2}), PointLight{}, 20.0f);
  addLight(scene, {{0, 0, 0}, facing({-1, -2, -1}), dvec3(1.0)}, DirectionalLight{}, 1.0f);
  return scene;
}

Scene allMirrors() {
  Scene scene = plainScene(6);
  add(scene, at({-0.8, 0, 0}), Sphere{0.8}, metal(0.0f, {0.9f, 0.6f, 0.4f}));
  add(scene, at({0.9, 0, 0.3}), Sphere{0.7}, metal(0.0f, {0.5f, 0.7f, 0.9f}));
  Material sky = metal(0.0f, glm::vec3(0.2f));
  sky.emissionLuminance = 1.0f;
  add(scene, at({0, 0, 0}), Sphere{30.0}, sky);
  return scene;
}

Scene polishedFloor() {  // a mirror lobe over a diffuse one
  Scene scene = plainScene(4);
  add(scene, at({0, -1, 0}), Plane{}, plastic(0.0f, {0.4f, 0.5f, 0.3f}));
  add(scene, at({0, 0, 0}), Sphere{1.0}, emitter(2.0f, glm::vec3(0.3f)));
  addLight(scene, at({3, 3, 3}), PointLight{}, 10.0f);
  scene.render.filter = PixelFilter::blackmanHarris;
  scene.render.russianRoulette = true;
  return scene;
}

Scene crowd() {  // more than can be baked into a pipeline
  Scene scene = plainScene(2);
  for (int i = 0; i < 12; ++i)
    add(scene, at({-2.0 + 0.35 * i, 0.3 * (i % 3), 0.2 * (i % 5)}), Sphere{0.25},
        lambert(glm::vec3(0.3f + 0.05f * float(i))));
  for (int i = 0; i < 11; ++i) addLight(scene, at({double(i) - 5.0, 3.0, 2.0}), PointLight{}, 2.0f);
  scene.render.lightSamples = 4;
  return scene;
}

Scene veilBeforeABall() {  // meshes, textures, opacity
  Scene scene = plainScene(3);
  Material veil = lambert(glm::vec3(0.8f));
  veil.albedoTexture = textures::slot(textures::made(4, 4, textures::Format::rgba8, [](int x, int y) {
    return glm::vec4(float(x) / 3.0f, float(y) / 3.0f, 0.5f, float(x + y) / 6.0f);
  }));
  veil.alphaMode = AlphaMode::blend;
  add(scene, at({0, 0, 1}), textures::shape(textures::picture()), veil);
  add(scene, at({0, 0, -0.5}), textures::shape(textures::smoothBall(2)), plastic(0.4f, {0.8f, 0.3f, 0.2f}));
  addLight(scene, at({2, 4, 3}), PointLight{}, 30.0f);
  return scene;
}

Scene shortestRoulette() {  // played once, before the ray that may meet a light
  Scene scene = lampsOfAllKinds();
  scene.render.russianRoulette = true;
  EXPECT_EQ(scene.render.maxBounces, 3);
  return scene;
}

Scene partlyGlass() {  // every lobe at once
  Scene scene = glassAndSky(0.2f, 0.5f);
  Material cloudy = plastic(0.3f, {0.4f, 0.6f, 0.9f});
  cloudy.transmission = 0.5f;
  cloudy.clearcoat = 0.7f;
  cloudy.clearcoatRoughness = 0.2f;
  add(scene, at({0, 1.4, 0.3}), Sphere{0.5}, cloudy);
  return scene;
}

// Aslant: along an axis products with 0 add up exactly, whatever their order.
CameraView aslant(const CameraView& view) {
  CameraView turned = lookAt({2.4, 1.6, 4.3}, {0.1, 0.2, 0.3}, 0.9);
  turned.lens = view.lens;
  return turned;
}

std::vector<FeatureScene> cases() {
  std::vector<FeatureScene> all = featureScenes();
  const FeatureScene basic[] = {{"balls under a lamp", ballsUnderALamp(), frontView()},
                                {"planes under a spot", planesUnderASpot(), frontView()},
                                {"walls that face all axes", wallsThatFaceAllAxes(), frontView()},
                                {"planet in the sun", planetInTheSun(), frontView()},
                                {"boxes and a glowing rect", boxesAndGlowingRect(), frontView()},
                                {"turned and stretched", turnedAndStretched(), frontView()},
                                {"all mirrors", allMirrors(), frontView()},
                                {"polished floor", polishedFloor(), frontView()},
                                {"crowd", crowd(), frontView()},
                                {"veil before a ball", veilBeforeABall(), frontView()},
                                {"shortest roulette", shortestRoulette(), frontView()},
                                {"partly glass", partlyGlass(), frontView()},
                                {"furnished room", room(4), frontView()}};
  all.insert(all.end(), std::begin(basic), std::end(basic));
  all.back().scene.render.energyCompensation = false;
  for (const FeatureScene& c : featureScenes()) {
    const std::string_view name(c.name);
    if (name != "coated and tinted" && name != "rough coloured glass") continue;
    all.push_back(c);
    all.back().scene.render.energyCompensation = false;
  }
  for (FeatureScene& c : all) c.view = aslant(c.view);
  return all;
}

class VariantsTest : public RendererTest {};

TEST_F(VariantsTest, row41_special_pipelines_give_the_picture_of_the_generic_one) {
  std::set<std::string> used, leftOut;
  for (const FeatureScene& c : cases()) {
    SCOPED_TRACE(c.name);
    const CameraView& view = c.view;
    renderer().allowSpecialization(false);
    const Image generic = render(c.scene, view, {32, 32}, 16);
    EXPECT_FALSE(renderer().stats().variant.specialized);
    EXPECT_GT(meanOf(generic).value, 0.01);
    renderer().allowSpecialization(true);
    renderer().waitForSpecialization();
    const Image special = render(c.scene, view, {32, 32}, 16);
    const VariantInfo& variant = renderer().stats().variant;
    EXPECT_TRUE(variant.specialized);
    expectSamePicture(special, generic);
    used.insert(variant.features.begin(), variant.features.end());
    leftOut.insert(variant.leftOut.begin(), variant.leftOut.end());
  }
  // Each feature was compiled in once and left out once.
  for (const std::string& feature : leftOut) EXPECT_TRUE(used.count(feature)) << feature;
  EXPECT_EQ(leftOut.size(), 32u);
}

TEST_F(VariantsTest, ChangeOfTheSceneFallsBackToAPipelineThatCoversIt) {
  Scene scene = ballsUnderALamp();
  const CameraView view = lookAt({0, 0.8, 5}, {0, 0.2, 0}, 0.9);
  renderer().allowSpecialization(true);
  renderer().setScene(scene, view, {32, 32});
  renderer().waitForSpecialization();
  render(scene, view, {32, 32}, 4);
  add(scene, at({0, 1.5, 0}), Box{{0.5, 0.5, 0.5}}, metal(0.0f));
  const Image edited = render(scene, view, {32, 32}, 4);  // expects that no sample met a missing feature
  renderer().allowSpecialization(false);
  expectSamePicture(edited, render(scene, view, {32, 32}, 4));
}

TEST_F(VariantsTest, AWallThatIsTurnedGivesUpThePipelineOfOneThatFacesAnAxis) {
  Scene scene = wallsThatFaceAllAxes();
  const CameraView view = aslant(frontView());
  renderer().allowSpecialization(true);
  renderer().setScene(scene, view, {32, 32});
  renderer().waitForSpecialization();
  render(scene, view, {32, 32}, 4);
  scene.objects[2].transform.rotation =
      glm::angleAxis(0.1, dvec3(0, 0, 1)) * scene.objects[2].transform.rotation;
  const Image turned = render(scene, view, {32, 32}, 4);
  renderer().allowSpecialization(false);
  expectSamePicture(turned, render(scene, view, {32, 32}, 4));
}

TEST_F(VariantsTest, APatientRendererDoesNothingUntilAPipelineIsReadyAndThenTracesTheSame) {
  const CameraView view = lookAt({0, 0.8, 5}, {0, 0.2, 0}, 0.9);
  Renderer patient(device_);
  patient.setPatient(true);
  patient.allowSpecialization(false);
  patient.setScene(ballsUnderALamp(), view, {32, 32});
  patient.trace(200.0);
  EXPECT_FALSE(patient.stats().compiling) << "the very first is waited for";
  patient.setSampleRange(0, 4);
  patient.setScene(veilBeforeABall(), view, {32, 32});
  int waited = 0;
  while (patient.trace(200.0)) {
    if (!patient.stats().compiling) continue;
    EXPECT_EQ(patient.stats().samples, 0u);
    ++waited;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_GT(waited, 0);
  expectSamePicture(patient.radiance(), render(veilBeforeABall(), view, {32, 32}, 4));
}

TEST_F(VariantsTest, WhatWasPreparedOnAnotherThreadIsTracedAtOnce) {
  const CameraView view = lookAt({0, 0.8, 5}, {0, 0.2, 0}, 0.9);
  Renderer patient(device_);
  patient.setPatient(true);
  patient.setScene(ballsUnderALamp(), view, {32, 32});
  patient.trace(200.0);
  const Scene next = veilBeforeABall();
  std::jthread([&] { patient.prepare(next, view, {32, 32}, [](double) { return true; }); }).join();
  patient.setScene(next, view, {32, 32});
  EXPECT_TRUE(patient.trace(200.0));
  EXPECT_FALSE(patient.stats().compiling);
}

}  // namespace
}  // namespace steradian
