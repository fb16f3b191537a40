// SPDX-License-Identifier: MIT
// Every rule of a sound scene: broken once, reported once, at the right place.
#include "renderer/scene/validate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace steradian;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Ids: 1 sphere on material 5, 2 spot light, 3 camera, 4 group.
Scene sound() {
  Scene scene;
  scene.objects.resize(4);
  for (unsigned i = 0; i < 4; ++i) {
    scene.objects[i].id = Id(i + 1);
    scene.objects[i].name = std::string("o") + std::to_string(i + 1);
  }
  scene.objects[0].content = Geometry{Sphere{}, Id(5)};
  scene.objects[1].content = Light{SpotLight{}};
  scene.objects[2].content = Camera{};
  scene.materials.resize(1);
  scene.materials[0].id = Id(5);
  scene.materials[0].name = "m5";
  scene.nextId = Id(6);
  scene.animation.channels = {
      {Id(2), Property::lightIntensity, Interpolation::linear, {{0, {1, 0, 0, 0}}, {1, {2, 0, 0, 0}}}}};
  return scene;
}

struct Breakage {
  const char* where;
  std::function<void(Scene&)> breakIt;
};

Geometry& geometry(Scene& s) {
  return std::get<Geometry>(s.objects[0].content);
}
Light& light(Scene& s) {
  return std::get<Light>(s.objects[1].content);
}
EnvironmentLight& environment(Scene& s) {
  return light(s).kind.emplace<EnvironmentLight>();
}
Camera& camera(Scene& s) {
  return std::get<Camera>(s.objects[2].content);
}
Channel& channel(Scene& s) {
  return s.animation.channels[0];
}

const Breakage kBreakages[] = {
    {"object 'o1'.transform.translation.y", [](Scene& s) { s.objects[0].transform.translation.y = kNan; }},
    {"object 'o1'.transform.translation.x", [](Scene& s) { s.objects[0].transform.translation.x = 1e30; }},
    {"object 'o1'.transform.scale", [](Scene& s) { s.objects[0].transform.scale.z = 0.0; }},
    {"object 'o1'.transform.scale.x", [](Scene& s) { s.objects[0].transform.scale.x = kInf; }},
    {"object 'o1'.transform.scale.x", [](Scene& s) { s.objects[0].transform.scale.x = 1e-30; }},
    {"object 'o1'.transform.rotation", [](Scene& s) { s.objects[0].transform.rotation.w = 1.00001; }},
    {"object 'o1'.transform.rotation", [](Scene& s) { s.objects[0].transform.rotation.x = kNan; }},
    {"object 'o1'.shape.radius", [](Scene& s) { geometry(s).shape = Sphere{0.0}; }},
    {"object 'o1'.shape.radius", [](Scene& s) { geometry(s).shape = Disk{-1.0}; }},
    {"object 'o1'.shape.height",
     [](Scene& s) {
       geometry(s).shape = Cylinder{1.0, kInf};
     }},
    {"object 'o1'.shape.size.z",
     [](Scene& s) {
       geometry(s).shape = Box{{1, 1, 0}};
     }},
    {"object 'o1'.shape.size.x",
     [](Scene& s) {
       geometry(s).shape = Rect{{kNan, 1}};
     }},
    {"object 'o1'.material", [](Scene& s) { geometry(s).material = Id(4); }},
    {"object 'o2'.light.intensity", [](Scene& s) { light(s).intensity = -1.0f; }},
    {"object 'o2'.light.color.x", [](Scene& s) { light(s).color.x = NAN; }},
    {"object 'o2'.light.outerConeAngle",
     [](Scene& s) { std::get<SpotLight>(light(s).kind).outerConeAngle = 1.6f; }},
    {"object 'o2'.light.innerConeAngle",
     [](Scene& s) { std::get<SpotLight>(light(s).kind).innerConeAngle = 0.8f; }},
    {"object 'o2'.light.temperature", [](Scene& s) { light(s).temperature = 999.0f; }},
    {"object 'o2'.light.temperature", [](Scene& s) { light(s).temperature = 40001.0f; }},
    {"object 'o2'.light.temperature", [](Scene& s) { light(s).temperature = NAN; }},
    {"object 'o2'.light.angularDiameter", [](Scene& s) { light(s).kind = DirectionalLight{1.6f}; }},
    {"object 'o2'.light.angularDiameter", [](Scene& s) { light(s).kind = DirectionalLight{-0.1f}; }},
    {"object 'o2'.light.radius", [](Scene& s) { light(s).kind = SphereLight{0.0}; }},
    {"object 'o2'.light.radius", [](Scene& s) { light(s).kind = DiskLight{kInf}; }},
    {"object 'o2'.light.size.y",
     [](Scene& s) {
       light(s).kind = RectLight{{1.0, -1.0}};
     }},
    {"object 'o2'.light.horizon.x", [](Scene& s) { environment(s).horizon.x = -1.0f; }},
    {"object 'o2'.light.ground.z", [](Scene& s) { environment(s).ground.z = INFINITY; }},
    {"object 'o2'.light.image",
     [](Scene& s) {
       environment(s).image = std::make_shared<const Image>(Image{1, 1, 4, {1, 1, 1, 1}});
     }},
    {"object 'o3'.camera.orthographicHeight", [](Scene& s) { camera(s).orthographicHeight = 0.0; }},
    {"object 'o3'.camera.fNumber", [](Scene& s) { camera(s).fNumber = -1.0; }},
    {"object 'o3'.camera.fNumber", [](Scene& s) { camera(s).fNumber = kNan; }},
    {"object 'o3'.camera.focusDistance", [](Scene& s) { camera(s).focusDistance = 0.0; }},
    {"object 'o3'.camera.fovY", [](Scene& s) { s.objects[2].content = Camera{0.0}; }},
    {"object 'o3'.camera.fovY", [](Scene& s) { s.objects[2].content = Camera{3.15}; }},
    {"object 'o2'.id",
     [](Scene& s) {
       s.objects[1].id = Id(4), s.animation.channels.clear();
       s.objects.pop_back();
       s.objects.push_back(s.objects[1]), std::swap(s.objects[1], s.objects[3]);
       s.objects[3].name = "o2";
     }},
    {"material 'm5'.id", [](Scene& s) { s.nextId = Id(5); }},
    {"object 'o4'.id", [](Scene& s) { s.objects[3].id = Id::none; }},
    {"object 'o4'.parent", [](Scene& s) { s.objects[3].parent = Id(4); }},
    {"object 'o4'.parent", [](Scene& s) { s.objects[3].parent = Id(9); }},
    {"object 'o4'.parent", [](Scene& s) { s.objects[3].parent = Id(5); }},
    {"object 'o1'.parent", [](Scene& s) { s.objects[0].parent = Id(4), s.objects[3].parent = Id(1); }},
    {"material 'm5'.albedo.y", [](Scene& s) { s.materials[0].albedo.y = 1.5f; }},
    {"material 'm5'.metallic", [](Scene& s) { s.materials[0].metallic = -0.1f; }},
    {"material 'm5'.roughness", [](Scene& s) { s.materials[0].roughness = NAN; }},
    {"material 'm5'.specular", [](Scene& s) { s.materials[0].specular = 2.0f; }},
    {"material 'm5'.ior", [](Scene& s) { s.materials[0].ior = 0.9f; }},
    {"material 'm5'.emissionColor.z", [](Scene& s) { s.materials[0].emissionColor.z = -1.0f; }},
    {"material 'm5'.emissionLuminance", [](Scene& s) { s.materials[0].emissionLuminance = INFINITY; }},
    {"material 'm5'.transmission", [](Scene& s) { s.materials[0].transmission = 1.1f; }},
    {"material 'm5'.attenuationColor.y", [](Scene& s) { s.materials[0].attenuationColor.y = 0.0f; }},
    {"material 'm5'.attenuationColor.z", [](Scene& s) { s.materials[0].attenuationColor.z = 1.1f; }},
    {"material 'm5'.attenuationDistance", [](Scene& s) { s.materials[0].attenuationDistance = -1.0f; }},
    {"material 'm5'.clearcoat", [](Scene& s) { s.materials[0].clearcoat = NAN; }},
    {"material 'm5'.clearcoatRoughness", [](Scene& s) { s.materials[0].clearcoatRoughness = 2.0f; }},
    {"material 'm5'.edgeTint.x", [](Scene& s) { s.materials[0].edgeTint.x = -0.1f; }},
    {"animation.framesPerSecond", [](Scene& s) { s.animation.framesPerSecond = 0.0; }},
    {"animation.channels[0].target", [](Scene& s) { channel(s).target = Id(9); }},
    {"animation.channels[0].target", [](Scene& s) { channel(s).target = Id(1); }},
    {"animation.channels[0].keys", [](Scene& s) { channel(s).keys.clear(); }},
    {"animation.channels[0].keys[1].time", [](Scene& s) { channel(s).keys[1].time = 0.0; }},
    {"animation.channels[0].keys[1].value.x", [](Scene& s) { channel(s).keys[1].value.x = -1.0; }},
    {"animation.channels[0].keys[0].value",
     [](Scene& s) {
       channel(s) = {Id(1), Property::rotation, {}, {{0, {0, 0, 0, 2}}}};
     }},
    {"animation.channels[0].keys[0].value",
     [](Scene& s) {
       channel(s) = {Id(1), Property::scale, {}, {{0, {1, 0, 1, 0}}}};
     }},
    {"render.width", [](Scene& s) { s.render.width = 16385; }},
    {"render.height", [](Scene& s) { s.render.height = 0; }},
    {"render.maxBounces", [](Scene& s) { s.render.maxBounces = 65; }},
    {"render.lightSamples", [](Scene& s) { s.render.lightSamples = 0; }},
    {"render.clamp", [](Scene& s) { s.render.clamp = -1.0f; }},
    {"display.ev100", [](Scene& s) { s.display.ev100 = 26.0f; }},
    {"display.exposure", [](Scene& s) { s.display.exposure = NAN; }},
    {"display.gamma", [](Scene& s) { s.display.gamma = 0.0f; }},
    {"display.parameters.white", [](Scene& s) { s.display.parameters["white"] = NAN; }},
    {"activeCamera", [](Scene& s) { s.activeCamera = Id(1); }},
};

}  // namespace

TEST(Validation, finds_nothing_in_a_sound_scene) {
  for (const Problem& problem : problemsOf(sound())) ADD_FAILURE() << problem.where << " " << problem.what;
  EXPECT_TRUE(problemsOf(Scene{}).empty());
}

TEST(Validation, accepts_the_ends_of_every_range) {
  Scene scene = sound();
  Light& lamp = light(scene);
  Material& material = scene.materials[0];
  camera(scene) = {.projection = Projection::orthographic, .fNumber = 0.0};
  lamp.temperature = 1000.0f;
  lamp.kind = DirectionalLight{1.5707963f};
  material.attenuationColor = glm::vec3(1e-30f, 1.0f, 0.5f);
  material.attenuationDistance = 0.0f;
  scene.display.ev100 = -25.0f;
  EXPECT_TRUE(problemsOf(scene).empty());
  lamp.temperature = 40000.0f;
  lamp.kind = EnvironmentLight{.horizon = glm::vec3(0.0f)};
  EXPECT_TRUE(problemsOf(scene).empty());
}

TEST(Validation, reports_each_broken_rule_once_and_where_it_is) {
  for (const Breakage& breakage : kBreakages) {
    Scene scene = sound();
    breakage.breakIt(scene);
    const auto problems = problemsOf(scene);
    ASSERT_EQ(problems.size(), 1u) << breakage.where
                                   << (problems.empty() ? "" : ", second: " + problems.back().where);
    EXPECT_EQ(problems[0].where, breakage.where);
    EXPECT_NE(problems[0].what.find_first_of(";,"), std::string::npos) << problems[0].what;
  }
}

TEST(Validation, finds_one_cycle_in_a_chain_of_100000_without_recursion) {
  Scene scene;
  scene.objects.resize(100000);
  for (unsigned i = 0; i < scene.objects.size(); ++i) {
    scene.objects[i].id = Id(i + 1);
    scene.objects[i].parent = Id(i == 0 ? 100000 : i);
  }
  scene.nextId = Id(100001);
  EXPECT_EQ(problemsOf(scene).size(), 1u);
}

TEST(Validation, finds_scales_that_overflow_down_a_chain_of_parents) {
  Scene scene;
  scene.objects.resize(40);
  for (unsigned i = 0; i < scene.objects.size(); ++i) {
    scene.objects[i].id = Id(i + 1);
    scene.objects[i].parent = Id(i);
    scene.objects[i].transform.scale = glm::dvec3(1e11);
  }
  scene.nextId = Id(41);
  const auto problems = problemsOf(scene);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].where, "object '#2'.transform");
}
