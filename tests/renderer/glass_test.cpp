// SPDX-License-Identifier: MIT
// Glass and coats in pictures: even light stays even, absorption follows Beer and Lambert, slabs pass the
// textbook's share.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

class GlassTest : public RendererTest {
 protected:
  static Material glass(float roughness = 0.0f) {
    Material m;
    m.albedo = glm::vec3(1.0f);
    m.transmission = 1.0f;
    m.roughness = roughness;
    return m;
  }
  /// An even sky of radiance 1.
  /// Without reflection or bending; leaves all red, half of green and a quarter of blue after `distance`
  /// metres.
  static Material tint(float distance) {
    Material m = glass();
    m.ior = 1.0f;
    m.attenuationColor = {1.0f, 0.5f, 0.25f};
    m.attenuationDistance = distance;
    return m;
  }
  static void expectTint(const Image& seen, const Image& clear, double power) {
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(meanOf(seen, c).value / meanOf(clear, c).value, std::exp2(-power * c), 2e-3) << c;
  }
  /// Weights that grow with every round inside would show as a mean that a few pixels carry.
  static void expectNoHeavyTail(const Mean& mean, double gate) {
    EXPECT_LT(mean.sigma, gate);
    measured("standard error of the mean", mean.sigma, gate);
  }
  static void addSky(Scene& scene) { addLight(scene, at({0, 0, 0}), EnvironmentLight{}, 1.0f); }
  Mean ball(const Material& material, int samples, int bounces = 32) {
    Scene scene = plainScene(bounces);
    addSky(scene);
    add(scene, at({0, 0, 0}), Sphere{1.0}, material);
    return meanOf(render(scene, lookAt({0, 0, 4}, {0, 0, 0}, 0.6), {24, 24}, samples));
  }
};

TEST_F(GlassTest, row35_a_glass_ball_vanishes_in_even_light) {
  const Mean smooth = ball(glass(), 64);
  expectMean(smooth, 1.0, 0.005);
  EXPECT_LT(smooth.sigma, 0.005);
}

TEST_F(GlassTest, roulette_loses_no_path_in_clear_glass) {
  Scene scene = plainScene(32);
  scene.render.russianRoulette = true;
  addSky(scene);
  for (const double z : {0.0, -2.5, -5.0}) add(scene, at({0, 0, z}), Sphere{1.0}, glass());
  const Mean seen = meanOf(render(scene, lookAt({0, 0, 4}, {0, 0, 0}, 0.2), {24, 24}, 64));
  expectMean(seen, 1.0, 1e-3);
  EXPECT_LT(seen.sigma, 1e-3) << "a path that is lost leaves a hole, and others count for it";
}

TEST_F(GlassTest, row35_a_rough_glass_ball_vanishes_too) {
  for (const float roughness : {0.1f, 0.25f, 0.5f, 1.0f}) {
    SCOPED_TRACE(testing::Message() << "roughness " << roughness);
    const Mean seen = ball(glass(roughness), 256, 64);
    expectMean(seen, 1.0, 0.005);
    expectNoHeavyTail(seen, roughness > 0.5f ? 0.003 : 0.001);
  }
  Material dense = glass(0.3f);
  dense.ior = 3.0f;
  const Mean seen = ball(dense, 256, 64);
  expectMean(seen, 1.0, 0.025);  // after 16, 32, 64 bounces .915, .949, .982: the rest is still inside
  expectNoHeavyTail(seen, 0.002);
}

TEST_F(GlassTest, row35_balls_that_pass_a_part_of_the_light_vanish_as_well) {
  for (const float transmission : {0.1f, 0.5f, 0.9f})
    for (const float roughness : {0.0f, 0.2f, 0.5f, 1.0f}) {
      SCOPED_TRACE(testing::Message() << "transmission " << transmission << ", roughness " << roughness);
      Material milky = glass(roughness);
      milky.transmission = transmission;
      // Some of what a rough wall turns back goes round for longer than 64 bounces.
      const Mean seen = ball(milky, 128, 64);
      expectMean(seen, 1.0, roughness == 0.0f ? 0.005 : 0.015);
      expectNoHeavyTail(seen, roughness < 0.4f ? 0.002 : 0.006);
    }
}

TEST_F(GlassTest, visible_and_all_normals_give_the_same_glass_sheets_and_coats) {
  Material sheet = glass(0.4f), coated = glass(0.5f);
  sheet.thinWalled = true;
  coated.clearcoat = 1.0f;
  coated.clearcoatRoughness = 0.3f;
  Ablation allNormals;
  allNormals.visibleNormals = false;
  renderer().allowSpecialization(true);  // the generic pipeline obeys no ablation
  for (const Material& material : {glass(0.4f), sheet, coated}) {
    const Mean visible = ball(material, 256);
    renderer().setAblation(allNormals);
    const Mean all = ball(material, 256);
    renderer().setAblation({});
    EXPECT_NE(all.value, visible.value) << "the method was not switched";
    EXPECT_NEAR(all.value, visible.value, 3.0 * std::hypot(all.sigma, visible.sigma));
    EXPECT_LT(all.sigma, 0.01);
  }
  renderer().allowSpecialization(false);
}

TEST_F(GlassTest, row35_a_slab_passes_what_both_faces_leave) {
  // A box and a sheet, seen head-on against a wall of radiance 1 in the dark: 1 / (1 + ...) = 12/13.
  for (const bool solid : {true, false}) {
    Scene scene = plainScene(32);
    const Id material = add(scene, glass());
    if (solid)
      add(scene, at({0, 0, 0}), Box{{40, 40, 1}}, material);
    else
      add(scene, at({0, 0, 0}, {1, 0, 0}, pi / 2), Rect{{40, 40}}, material);
    add(scene, at({0, 0, -4}), Box{{60, 60, 1}}, emitter(1.0f));
    const Image image = render(scene, lookAt({0, 0, 5}, {0, 0, 0}, 0.05), {16, 16}, 256);
    expectMean(meanOf(image), 12.0 / 13.0, 0.005);
  }
}

TEST_F(GlassTest, AbsorptionFollowsTheDistance) {
  // A mirrorless solid (index 1) of 2 m halves green and quarters blue.
  Material m = glass();
  m.ior = 1.0f;
  m.attenuationColor = {1.0f, 0.5f, 0.25f};
  m.attenuationDistance = 2.0f;
  Scene scene = plainScene(8);
  addSky(scene);
  add(scene, at({0, 0, 0}), Box{{40, 40, 2}}, m);
  const Image image = render(scene, lookAt({0, 0, 5}, {0, 0, 0}, 0.02), {8, 8}, 16);
  EXPECT_NEAR(meanOf(image, 0).value, 1.0, 1e-3);
  EXPECT_NEAR(meanOf(image, 1).value, 0.5, 1e-3);
  EXPECT_NEAR(meanOf(image, 2).value, 0.25, 1e-3);
}

TEST_F(GlassTest, light_inside_a_tinted_solid_is_absorbed_on_its_way) {
  const auto seen = [&](const Material& solid) {
    Scene scene = plainScene(8);
    add(scene, at({0, 0, 0}), Box{{8, 8, 4}}, solid);
    add(scene, at({0, 0, -1}, {1, 0, 0}, pi / 2), Rect{{1, 1}}, lambert(glm::vec3(0.8f)));
    addLight(scene, at({0, 0, 1}), PointLight{}, 10.0f);
    return render(scene, lookAt({0, 0, 10}, {0, 0, 0}, 0.002), {8, 8}, 16);
  };
  Material clear = tint(1.0f);
  clear.attenuationDistance = 0.0f;
  expectTint(seen(tint(5.0f)), seen(clear), 1.0);  // 2 m to the light and 3 m to the face
}

TEST_F(GlassTest, a_camera_inside_a_tinted_solid_sees_through_it) {
  for (const Shape& solid : {Shape(Sphere{3}), Shape(Box{{6, 6, 6}}), Shape(Cylinder{3, 8})}) {
    const auto seen = [&](float distance) {
      Scene scene = plainScene(8);
      addSky(scene);
      add(scene, at({0, 0, 1}, {0, 1, 0}, 0.4), solid, tint(distance));
      return render(scene, lookAt({0, 0, 1}, {0, 0, 9}, 0.002), {8, 8}, 16);
    };
    const double way = std::holds_alternative<Box>(solid) ? 3.0 / std::cos(0.4) : 3.0;
    expectTint(seen(6.0f), seen(0.0f), way / 6.0);
  }
}

TEST_F(GlassTest, solids_within_each_other_absorb_both) {
  const auto seen = [&](float outer, float inner) {
    Scene scene = plainScene(8);
    addSky(scene);
    add(scene, at({0, 0, 0}), Box{{8, 8, 4}}, tint(outer));
    add(scene, at({0, 0, 0.5}), Box{{6, 6, 1}}, tint(inner));
    return render(scene, lookAt({0, 0, 10}, {0, 0, 0}, 0.02), {8, 8}, 16);
  };
  expectTint(seen(8.0f, 2.0f), seen(0.0f, 0.0f), 4.0 / 8.0 + 1.0 / 2.0);
}

TEST_F(GlassTest, solids_within_each_other_leave_no_rest_that_hides_the_sun) {
  const auto seen = [&](float outer, float inner) {
    Scene scene = plainScene(8);
    addLight(scene, {{0, 0, 0}, facing({-1, 0, -1}), dvec3(1.0)}, DirectionalLight{}, 1.0f);
    add(scene, at({0, 0, 0}), Box{{8, 8, 2}}, tint(outer));
    add(scene, at({0, 0, 0.2}), Box{{6, 6, 1}}, tint(inner));
    add(scene, at({0, 0, -30}, {1, 0, 0}, pi / 2), Rect{{9, 9}}, lambert(glm::vec3(0.8f)));
    return render(scene, lookAt({0, 0, 10}, {0, 0, 0}, 0.02), {8, 8}, 16);
  };
  for (const auto& [outer, inner] : {std::pair(1.7f, 0.9f), std::pair(0.9f, 1.7f), std::pair(30.0f, 0.7f)})
    expectTint(seen(outer, inner), seen(0.0f, 0.0f), 2.0 / outer + 1.0 / inner);
}

TEST_F(GlassTest, an_absorbing_half_space_lets_nothing_of_the_sky_through) {
  Scene scene = plainScene(8);
  addSky(scene);
  add(scene, at({0, 0, 0}), Plane{}, tint(1.0f));
  const Image image = render(scene, lookAt({0, 4, 3}, {0, 0, 0}, 0.02), {8, 8}, 16);
  EXPECT_EQ(meanOf(image, 2).value, 0.0);
  EXPECT_NEAR(meanOf(image, 0).value, 1.0, 1e-3) << "red is not absorbed";
}

TEST_F(GlassTest, row23_compensated_white_balls_vanish) {
  for (const float roughness : {0.3f, 0.7f, 1.0f})
    for (const float metallic : {0.0f, 1.0f})
      for (const float coat : {0.0f, 1.0f}) {
        SCOPED_TRACE(testing::Message() << roughness << ", " << metallic << ", coat " << coat);
        Material m = plastic(roughness, glm::vec3(1.0f));
        m.metallic = metallic;
        m.clearcoat = coat;
        m.clearcoatRoughness = 0.3f;
        const Mean mean = ball(m, 64, 4);
        expectMean(mean, 1.0, 0.005);
        EXPECT_LT(mean.sigma, 0.004);
      }
}

TEST_F(GlassTest, row41_glass_coats_and_tints_look_the_same_in_a_special_pipeline) {
  for (const bool compensation : {true, false}) {
    Scene scene = plainScene(6);
    scene.render.energyCompensation = compensation;
    addSky(scene);
    Material tinted = metal(0.3f, {0.9f, 0.6f, 0.4f});
    tinted.edgeTint = {0.8f, 0.9f, 0.7f};
    Material coated = plastic(0.6f, {0.2f, 0.5f, 0.3f});
    coated.clearcoat = 0.7f;
    Material milky = glass(0.2f);
    milky.transmission = 0.5f;
    add(scene, at({0, -1, 0}), Plane{}, lambert(glm::vec3(0.5f)));
    const std::vector<Material> materials = {glass(0.3f), tinted, coated, glass(), milky};
    for (std::size_t i = 0; i <= materials.size(); ++i) {  // one more kind at a time
      const CameraView view = lookAt({0, 1, 6}, {0, 0, 0}, 0.8);
      renderer().allowSpecialization(false);
      const Image generic = render(scene, view, {32, 32}, 8);
      renderer().allowSpecialization(true);
      renderer().waitForSpecialization();
      const Image special = render(scene, view, {32, 32}, 8);
      EXPECT_TRUE(renderer().stats().variant.specialized);
      SCOPED_TRACE(testing::Message() << "compensation " << compensation << ", kinds " << i);
      expectSamePicture(special, generic);
      if (i < materials.size()) add(scene, at({1.2 * double(i) - 2.4, -0.4, 0}), Sphere{0.55}, materials[i]);
    }
  }
}

}  // namespace
}  // namespace steradian
