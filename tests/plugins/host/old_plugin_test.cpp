// SPDX-License-Identifier: MIT
// A plugin built against interface 1.0 works in today's host, in both directions.
#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

using OldPlugin = FolderTest;

TEST_F(OldPlugin, ImportsAndWhatItDoesNotKnowHasItsDefault) {
  add("interface_1_0");
  writeText(folder / "a.old", "x");
  const Scene scene = host().importScene(folder / "a.old").scene;
  EXPECT_EQ(scene.render, (RenderSettings{.width = 7, .height = 8, .seed = 9}));
  EXPECT_EQ(scene.display, DisplaySettings{.exposure = 2.0f});
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0],
            (Material{.id = Id{1}, .name = "Red", .roughness = 0.25f, .emissionLuminance = 3.0f}));
  ASSERT_EQ(scene.objects.size(), 4u);
  EXPECT_EQ(std::get<Geometry>(scene.objects[0].content), (Geometry{Sphere{3.0}, Id{1}}));
  EXPECT_EQ(std::get<Camera>(scene.objects[1].content), Camera{0.5});
  EXPECT_EQ(std::get<Light>(scene.objects[2].content),
            (Light{.kind = SpotLight{0.0f, 0.5f}, .intensity = 5.0f}));
  EXPECT_EQ(std::get<Light>(scene.objects[3].content),
            (Light{.kind = DirectionalLight{}, .intensity = 6.0f}));
}

TEST_F(OldPlugin, ExportsASceneThatHoldsNewerThings) {
  add("interface_1_0");
  Scene scene{.render = {.seed = 4}};
  scene.materials = {{.id = Id{1}, .roughness = 0.5f, .clearcoat = 1.0f}};
  scene.objects = {{.id = Id{2}, .name = "Ball", .content = Geometry{Sphere{}, Id{1}}},
                   {.id = Id{3}, .name = "Panel", .content = Light{RectLight{}}}};
  scene.nextId = Id{4};
  host().exportScene(scene, folder / "a.old");
  EXPECT_EQ(readText(folder / "a.old"), "4\n1 Ball\n12 Panel\n0.500000\n");
}

}  // namespace
}  // namespace steradian::plugins
