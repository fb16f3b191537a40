// SPDX-License-Identifier: MIT
// Nodes, scenes, cameras, lights and animation of glTF.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/plugins/gltf/maker.hpp"

namespace steradian::plugins {
namespace {

using GltfScene = Gltf;

Json listOf(const glm::dmat4& m) {
  Json out = Json::array();
  for (int i = 0; i < 16; ++i) out.push_back(m[i / 4][i % 4]);
  return out;
}

double distance(const glm::dmat4& a, const glm::dmat4& b) {
  double most = 0;
  for (int i = 0; i < 16; ++i) most = std::max(most, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
  return most;
}

TEST_F(GltfScene, NodesKeepTheirTreeAndTransforms) {
  GltfMaker maker;
  const std::size_t child = maker.append("nodes", {{"name", "child"}, {"scale", {2, 3, 4}}});
  maker.root(
      {{"name", "top"}, {"translation", {1, 2, 3}}, {"rotation", {0, 0.6, 0, 0.8}}, {"children", {child}}});
  const Scene scene = import(maker).scene;
  const Object &top = named(scene, "top"), &inner = named(scene, "child");
  EXPECT_EQ(top.transform.translation, glm::dvec3(1, 2, 3));
  EXPECT_NEAR(top.transform.rotation.y, 0.6, 1e-15);
  EXPECT_EQ(inner.parent, top.id);
  EXPECT_EQ(inner.transform.scale, glm::dvec3(2, 3, 4));
}

TEST_F(GltfScene, MatricesAreTakenApartExactlyMirroredOnesToo) {
  const glm::dmat4 turned =
      glm::rotate(glm::translate(glm::dmat4(1), {1, 2, 3}), 0.7, glm::dvec3(0.6, 0.8, 0));
  for (const glm::dvec3 scale :
       {glm::dvec3(1), glm::dvec3(2, 0.5, 3), glm::dvec3(1, -2, 1), glm::dvec3(-1, -2, -3)}) {
    const glm::dmat4 matrix = glm::scale(turned, scale);
    GltfMaker maker;
    maker.root({{"name", "n"}, {"matrix", listOf(matrix)}});
    const ImportResult result = import(maker);
    EXPECT_LT(distance(worldFromObject(result.scene, named(result.scene, "n").id), matrix), 1e-12);
    EXPECT_EQ(linesOf(result.report), "");
  }
}

TEST_F(GltfScene, AShearIsReportedAsApproximated) {
  GltfMaker maker;
  glm::dmat4 matrix(1);
  matrix[1][0] = 0.5;
  maker.root({{"name", "n"}, {"matrix", listOf(matrix)}});
  EXPECT_CONTAINS(linesOf(import(maker).report), "node 'n', matrix: approximated: its shear is left out");
}

TEST_F(GltfScene, fault6_FlatAndZeroScalesAreHiddenOrNearlyFlat) {
  GltfMaker maker;
  maker.root({{"name", "hidden"}, {"scale", {0, 0, 0}}});
  maker.root({{"name", "flat"}, {"scale", {1, 0, 1}}});
  maker.root({{"name", "singular"},
              {"matrix", listOf(glm::dmat4(0) + glm::dmat4(glm::dmat3(1, 1, 1, 1, 1, 1, 1, 1, 1)))}});
  const ImportResult result = import(maker);
  EXPECT_FALSE(named(result.scene, "hidden").visible);
  EXPECT_EQ(named(result.scene, "flat").transform.scale, glm::dvec3(1, 1e-9, 1));
  EXPECT_CONTAINS(linesOf(result.report), "node 'flat', scale: approximated: 0 becomes 1e-9");
}

TEST_F(GltfScene, fault6_NodesThatLeaveTheRangeOfNumbersAreLeftOutByName) {
  GltfMaker maker;
  std::size_t node = maker.append("nodes", {{"scale", {1e12, 1e12, 1e12}}});
  for (int i = 0; i < 3; ++i)
    node = maker.append("nodes", {{"name", "n"}, {"scale", {1e12, 1e12, 1e12}}, {"children", {node}}});
  maker.root({{"name", "top"}, {"children", {node}}});
  const ImportResult result = import(maker);
  EXPECT_CONTAINS(linesOf(result.report),
                  "'n' and all inside it: left out: its size or place is out of range");
  EXPECT_NE(findByName(result.scene, "top"), nullptr);
}

TEST_F(GltfScene, TheDefaultSceneIsShownAndTheParameterChooses) {
  GltfMaker maker;
  maker.root({{"name", "first"}});
  maker.append("nodes", {{"name", "second"}});
  maker.append("scenes", {{"name", "B"}, {"nodes", {1}}});
  const ImportResult shown = import(maker);
  EXPECT_NE(findByName(shown.scene, "first"), nullptr);
  EXPECT_EQ(findByName(shown.scene, "second"), nullptr);
  EXPECT_CONTAINS(linesOf(shown.report),
                  "scene 'B': left out: one scene is imported; the parameter scene = 1");
  const ImportResult other = import(maker, {{"scene", 1}});
  EXPECT_NE(findByName(other.scene, "second"), nullptr);
  EXPECT_EQ(other.scene.name, "B");
  EXPECT_CONTAINS(faultOf([&] { import(maker, {{ "scene", 2 }}); }).first, "there is no scene 2");
  maker.json.erase("scenes");
  maker.json.erase("scene");
  EXPECT_EQ(import(maker).scene.objects.size(), 2u);
}

TEST_F(GltfScene, SeveralPrimitivesAreChildrenOfTheirNode) {
  GltfMaker maker;
  maker.triangle();
  Json second = maker.json["meshes"][0]["primitives"][0];
  second["material"] = maker.append("materials", {{"name", "red"}});
  maker.json["meshes"][0]["primitives"].push_back(second);
  const Scene scene = import(maker).scene;
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<Group>(named(scene, "tri").content));
  EXPECT_EQ(scene.objects[1].parent, named(scene, "tri").id);
  EXPECT_EQ(findMaterial(scene, std::get<Geometry>(named(scene, "red").content).material)->name, "red");
}

TEST_F(GltfScene, CamerasKeepTheirLensAndTheFirstAspectRatioSetsThePicture) {
  GltfMaker maker;
  maker.append("cameras", {{"type", "perspective"},
                           {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"aspectRatio", 2.0}}}});
  maker.append("cameras", {{"type", "orthographic"},
                           {"orthographic", {{"xmag", 3}, {"ymag", 1.5}, {"znear", 0}, {"zfar", 9}}}});
  maker.root({{"name", "p"}, {"camera", 0}});
  maker.root({{"name", "o"}, {"camera", 1}});
  const Scene scene = import(maker).scene;
  EXPECT_EQ(std::get<Camera>(named(scene, "p").content).fovY, 0.5);
  EXPECT_EQ(std::get<Camera>(named(scene, "o").content).projection, Projection::orthographic);
  EXPECT_EQ(std::get<Camera>(named(scene, "o").content).orthographicHeight, 3.0);
  EXPECT_EQ(scene.render.width, 2 * scene.render.height);
  EXPECT_CONTAINS(named(scene, "p").extras, "\"znear\":0.1");
}

TEST_F(GltfScene, PunctualLightsKeepCandelaAndLux) {
  GltfMaker maker;
  maker.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"intensity", 40}, {"color", {1, 0.5, 0}}, {"range", 5}},
      {{"type", "directional"}, {"intensity", 1000}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}}};
  const char* const names[] = {"point", "sun", "spot"};
  for (int i = 0; i < 3; ++i)
    maker.root({{"name", names[i]}, {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  const ImportResult result = import(maker);
  EXPECT_EQ(std::get<Light>(named(result.scene, "point").content),
            (Light{.kind = PointLight{}, .color = {1, 0.5, 0}, .intensity = 40}));
  EXPECT_EQ(std::get<Light>(named(result.scene, "sun").content),
            (Light{.kind = DirectionalLight{}, .intensity = 1000}));
  EXPECT_EQ(std::get<Light>(named(result.scene, "spot").content),
            (Light{.kind = SpotLight{0.2f, 0.4f}, .intensity = 1}));
  EXPECT_CONTAINS(linesOf(result.report), "light of 'point', range: left out");
}

struct Animated : GltfMaker {
  std::size_t node = root({{"name", "n"}});
  std::size_t times = accessor<float>({0, 1, 2}, "SCALAR");
  void add(const char* path, Json output, const char* interpolation = "LINEAR") {
    append("animations",
           {{"samplers", {{{"input", times}, {"output", output}, {"interpolation", interpolation}}}},
            {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}});
  }
};

TEST_F(GltfScene, NodeAnimationsBecomeChannelsOfAllAnimationsAndTheFirstWins) {
  Animated maker;
  maker.add("translation", maker.accessor<float>({0, 0, 0, 1, 0, 0, 2, 0, 0}, "VEC3"));
  maker.add("rotation", maker.accessor<float>({0, 0, 0, 1, 0, 0.6, 0, 0.8, 0, 0, 0, 2}, "VEC4"), "STEP");
  maker.add("translation", maker.accessor<float>({9, 9, 9, 9, 9, 9, 9, 9, 9}, "VEC3"));
  const ImportResult all = import(maker);
  ASSERT_EQ(all.scene.animation.channels.size(), 2u);
  EXPECT_EQ(all.scene.animation.channels[0].property, Property::translation);
  EXPECT_EQ(all.scene.animation.channels[0].keys.at(2).value, glm::dvec4(2, 0, 0, 0));
  EXPECT_EQ(all.scene.animation.channels[1].interpolation, Interpolation::step);
  EXPECT_EQ(all.scene.animation.channels[1].keys.at(2).value, glm::dvec4(0, 0, 0, 1));
  EXPECT_CONTAINS(linesOf(all.report),
                  "animation 2: left out: 1 channels move what an earlier animation moves");
  const ImportResult third = import(maker, {{"animation", 2}});
  ASSERT_EQ(third.scene.animation.channels.size(), 1u);
  EXPECT_EQ(third.scene.animation.channels[0].keys.at(0).value, glm::dvec4(9, 9, 9, 0));
}

TEST_F(GltfScene, CubicSplinesFollowTheirTangentsInSmallSteps) {
  Animated maker;
  // From 0 to 1 with flat tangents: smoothstep, so 5/32 at a quarter.
  maker.add("translation",
            maker.accessor<float>(
                {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0}, "VEC3"),
            "CUBICSPLINE");
  const ImportResult result = import(maker);
  const Scene quarter = evaluatedAt(result.scene, 0.25);
  EXPECT_NEAR(named(quarter, "n").transform.translation.x, 5.0 / 32.0, 1e-9);
  EXPECT_CONTAINS(linesOf(result.report), "animation, cubic splines: approximated");
}

TEST_F(GltfScene, TimesThatDoNotIncreaseCostTheirChannelOnly) {
  Animated maker;
  maker.add("translation", maker.accessor<float>({0, 0, 0, 1, 0, 0, 2, 0, 0}, "VEC3"));
  maker.times = maker.accessor<float>({0, 2, 1}, "SCALAR");
  maker.add("scale", maker.accessor<float>({1, 1, 1, 1, 1, 1, 1, 1, 1}, "VEC3"));
  const ImportResult result = import(maker);
  EXPECT_EQ(result.scene.animation.channels.size(), 1u);
  EXPECT_CONTAINS(linesOf(result.report),
                  "animation 1, channel 0: left out: animations[1].samplers[0].input: "
                  "expected increasing times");
}

TEST_F(GltfScene, WhatIsUnknownIsKeptInExtrasAndListed) {
  GltfMaker maker;
  maker.json["extensionsUsed"] = {"VENDOR_thing", "KHR_lights_punctual"};
  maker.json["asset"]["generator"] = "by hand";
  maker.root({{"name", "n"}, {"extras", {{"price", 5}}}, {"extensions", {{"VENDOR_thing", {{"a", 1}}}}}});
  const ImportResult result = import(maker);
  EXPECT_EQ(Json::parse(named(result.scene, "n").extras),
            Json::parse(R"({"gltf": {"extras": {"price": 5}, "extensions": {"VENDOR_thing": {"a": 1}}}})"));
  EXPECT_CONTAINS(result.scene.extras, "VENDOR_thing");
  EXPECT_CONTAINS(result.scene.extras, "by hand");
  EXPECT_CONTAINS(linesOf(result.report),
                  "extension VENDOR_thing: has no effect here: unknown, kept for export");
}

TEST_F(GltfScene, WhatOurExporterKeptComesBackAsItWas) {
  GltfMaker maker;
  maker.triangle();
  maker.append("materials", {{"name", "m"}, {"extras", {{"steradian", {{"edgeTint", {0.5, 1, 1}}}}}}});
  maker.json["nodes"][0]["extras"] = {
      {"steradian", {{"kind", "sphere"}, {"radius", 2.5}, {"material", 0}, {"visible", false}}}};
  maker.root({{"name", "sky"},
              {"extras",
               {{"steradian", {{"kind", "environmentLight"}, {"file", "sky.exr"}, {"ground", {1, 2, 3}}}}}}});
  maker.root({{"name", "bad"}, {"extras", {{"steradian", {{"kind", "sphere"}, {"radius", -1}}}}}});
  maker.json["scenes"][0]["extras"]["steradian"] = {{"framesPerSecond", 30},
                                                    {"channels",
                                                     {{{"node", 1},
                                                       {"property", 3},
                                                       {"interpolation", 2},
                                                       {"keys", {{-1, 5, 0, 0, 0}, {1, 7, 0, 0, 0}}}}}}};
  const ImportResult result = import(maker);
  const Geometry& sphere = std::get<Geometry>(named(result.scene, "tri").content);
  EXPECT_EQ(std::get<Sphere>(sphere.shape), Sphere{2.5});
  EXPECT_EQ(findMaterial(result.scene, sphere.material)->edgeTint, glm::vec3(0.5, 1, 1));
  EXPECT_FALSE(named(result.scene, "tri").visible);
  EXPECT_EQ(std::get<EnvironmentLight>(std::get<Light>(named(result.scene, "sky").content).kind).file,
            "sky.exr");
  EXPECT_EQ(result.scene.animation.framesPerSecond, 30.0);
  EXPECT_EQ(result.scene.animation.channels.at(0).keys.at(1).value.x, 7.0);
  EXPECT_TRUE(named(result.scene, "tri").extras.empty());
  EXPECT_CONTAINS(linesOf(result.report), "node 'bad': left out: extras.steradian.radius: expected");
}

TEST_F(GltfScene, ImportExportImportKeepsTheScene) {
  Animated maker;
  maker.triangle()["material"] =
      maker.append("materials", {{"name", "m"}, {"doubleSided", true}, {"extras", {{"brand", "x"}}}});
  maker.add("translation", maker.accessor<float>({0, 0, 0, 1, 0, 0, 2, 0, 0}, "VEC3"));
  maker.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}});
  maker.root({{"name", "camera"}, {"camera", 0}, {"rotation", {0, 0.6, 0, 0.8}}});
  maker.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"spot", Json::object()}}};
  maker.root({{"name", "lamp"},
              {"extras", {{"price", 5}}},
              {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  const Scene first = import(maker).scene;
  stockPlugins().exportScene(first, folder / "b.glb");
  const ImportResult again = stockPlugins().importScene(folder / "b.glb");
  EXPECT_EQ(linesOf(again.report), "");
  ASSERT_EQ(again.scene.objects.size(), first.objects.size());
  for (std::size_t i = 0; i < first.objects.size(); ++i) {
    const Object &before = first.objects[i], &after = again.scene.objects[i];
    EXPECT_EQ(before.name, after.name);
    EXPECT_EQ(before.transform, after.transform) << before.name;
    if (!std::holds_alternative<Geometry>(before.content)) {
      EXPECT_EQ(before.content, after.content) << before.name;
    }
    EXPECT_EQ(Json::parse(before.extras.empty() ? "{}" : before.extras)["gltf"]["extras"],
              Json::parse(after.extras.empty() ? "{}" : after.extras)["gltf"]["extras"]);
  }
  EXPECT_EQ(meshOf(named(first, "tri")).positions, meshOf(named(again.scene, "tri")).positions);
  EXPECT_EQ(first.materials.at(0).albedo, again.scene.materials.at(0).albedo);
  EXPECT_CONTAINS(again.scene.materials.at(0).extras, "brand");
  EXPECT_EQ(first.animation.channels, again.scene.animation.channels);
}

TEST_F(GltfScene, SettingsOfPictureAndTimeComeBackToo) {
  Scene scene;
  scene.objects = {{.id = Id{1}, .name = "first", .content = Camera{}},
                   {.id = Id{2}, .name = "second", .content = Camera{}}};
  scene.nextId = Id{3};
  scene.activeCamera = scene.objects[1].id;
  scene.render = {.width = 333, .height = 77, .maxBounces = 17, .lightSamples = 3, .russianRoulette = false};
  scene.render.energyCompensation = false;
  scene.render.clamp = 12.5f;
  scene.render.seed = 4'000'000'000u;
  scene.display.exposure = -1.25f;
  scene.display.tonemapper = "org.steradian.tonemap.reinhard";
  scene.display.physical = true;
  scene.display.ev100 = 9.5f;
  scene.animation.framesPerSecond = 30;
  stockPlugins().exportScene(scene, folder / "settings.gltf");
  const ImportResult again = stockPlugins().importScene(folder / "settings.gltf");
  EXPECT_EQ(linesOf(again.report), "");
  EXPECT_EQ(again.scene.render, scene.render);
  EXPECT_EQ(again.scene.display, scene.display);
  EXPECT_EQ(again.scene.animation.framesPerSecond, 30);
  ASSERT_EQ(again.scene.objects.size(), 2u);
  EXPECT_EQ(again.scene.activeCamera, again.scene.objects[1].id);
}

TEST_F(GltfScene, SettingsOutOfRangeAreReportedAndLeftOut) {
  Animated maker;
  maker.json["scenes"][0]["extras"]["steradian"] = {
      {"render", {{"maxBounces", 1e9}}}, {"display", {{"tonemapper", 5}}}, {"activeCamera", "x"}};
  const ImportResult result = import(maker);
  EXPECT_EQ(result.scene.render, RenderSettings{});
  EXPECT_EQ(result.scene.display, DisplaySettings{});
  for (const char* key : {"maxBounces", "tonemapper", "activeCamera"})
    EXPECT_CONTAINS(linesOf(result.report), key);
}

}  // namespace
}  // namespace steradian::plugins
