// SPDX-License-Identifier: MIT
// The oracle's textures and interpolated attributes, against what can be said of them in one line.
#include "tests/oracle/surface.hpp"

#include <gtest/gtest.h>

#include "tests/oracle/texture.hpp"
#include "tests/renderer/scenes.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian::oracle {
namespace {

using textures::Format;

/// Red 0 1 / 2 3 thirds.
TextureSlot fourTexels(bool nearest) {
  return textures::slot(
      textures::made(2, 2, Format::rgba16,
                     [](int x, int y) { return glm::vec4(float(x + 2 * y) / 3.0f, 0, 0, 1); }),
      nearest);
}
double red(const TextureSlot& slot, double u, double v) {
  return 3.0 * lookUp(slot, {u, v}, false).x;
}

TEST(OracleTexture, texels_lie_half_a_texel_inside_and_blend_between) {
  const TextureSlot blocks = fourTexels(true), smooth = fourTexels(false);
  EXPECT_NEAR(red(blocks, 0.49, 0.01), 0.0, 1e-4);
  EXPECT_NEAR(red(blocks, 0.51, 0.99), 3.0, 1e-4);
  EXPECT_NEAR(red(smooth, 0.25, 0.25), 0.0, 1e-4);
  EXPECT_NEAR(red(smooth, 0.75, 0.75), 3.0, 1e-4);
  EXPECT_NEAR(red(smooth, 0.5, 0.25), 0.5, 1e-4);
  EXPECT_NEAR(red(smooth, 0.5, 0.5), 1.5, 1e-4);
}

TEST(OracleTexture, wraps_repeat_clamp_and_mirror) {
  TextureSlot slot = fourTexels(true);
  EXPECT_NEAR(red(slot, 1.1, 0.1), 0.0, 1e-4);
  EXPECT_NEAR(red(slot, -0.1, 0.1), 1.0, 1e-4);
  slot.wrapU = Wrap::clamp;
  EXPECT_NEAR(red(slot, 1.1, 0.1), 1.0, 1e-4);
  EXPECT_NEAR(red(slot, -7.1, 0.1), 0.0, 1e-4);
  slot.wrapU = Wrap::mirror;
  EXPECT_NEAR(red(slot, 1.1, 0.1), 1.0, 1e-4);
  EXPECT_NEAR(red(slot, 1.9, 0.1), 0.0, 1e-4);
  EXPECT_NEAR(red(slot, -0.1, 0.1), 0.0, 1e-4);
  EXPECT_NEAR(red(slot, -0.6, 0.1), 1.0, 1e-4);
}

TEST(OracleTexture, colours_of_codes_are_srgb_and_opacity_is_not) {
  const auto grey = [](Format format) {
    return lookUp(textures::uniform(glm::vec4(128.0f / 255.0f), format), {0.3, 0.4}, true);
  };
  EXPECT_NEAR(grey(Format::rgba8).x, 0.21586, 1e-5);
  EXPECT_NEAR(grey(Format::rgba8).w, 128.0 / 255.0, 1e-12);
  EXPECT_NEAR(grey(Format::rgbaHalf).x, 128.0 / 255.0, 3e-4);
}

TEST(OracleTexture, a_transform_turns_the_coordinates_first) {
  TextureSlot slot = fourTexels(true);
  slot.transformX = {0.0f, 1.0f, 0.5f};  // u' = v + 1/2
  slot.transformY = {1.0f, 0.0f, 0.0f};  // v' = u
  EXPECT_NEAR(red(slot, 0.1, 0.2), 1.0, 1e-4);
  EXPECT_NEAR(red(slot, 0.6, 0.2), 3.0, 1e-4);
}

/// One triangle in XY seen from +Z at barycentrics (1/2, 1/4, 1/4).
struct OneTriangle {
  explicit OneTriangle(const Material& material, Mesh mesh) : finish{material, nullptr, nullptr} {
    mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.uv0.assign(3, {0.5f, 0.5f});
    body.shape = textures::shape(mesh);
    body.finish = &finish;
    body.objectFromWorld = glm::inverse(matrixOf(scenes::at({0, 0, 0}, {0, 0, 1}, 0.0, {1.0, 2.0, 1.0})));
    hit = *intersect(body, {{1, 2, 3}, {0, 0, -1}}, 0.0);
  }
  Finish finish;
  Body body;
  Hit hit;
};

TEST(OracleSurface, attributes_are_weighed_by_the_opposite_areas) {
  Mesh mesh;
  mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0}};
  Material m = scenes::lambert({1.0f, 1.0f, 1.0f});
  m.alphaMode = AlphaMode::blend;
  m.opacity = 0.5f;
  const OneTriangle one(m, mesh);
  const glm::vec3 albedo = paintedFinish(one.hit)->material.albedo;
  EXPECT_NEAR(albedo.x, 0.5f, 1e-6f);
  EXPECT_NEAR(albedo.y, 0.25f, 1e-6f);
  EXPECT_NEAR(albedo.z, 0.25f, 1e-6f);
  EXPECT_NEAR(opacityAt(one.hit), 0.5 * 0.75, 1e-12);
}

TEST(OracleSurface, smooth_normals_turn_as_normals_do_and_maps_bend_them_along_the_tangents) {
  Mesh mesh;
  mesh.normals.assign(3, {0, 0.6f, 0.8f});
  mesh.tangents.assign(3, {1, 0, 0, 1});
  Material m = scenes::lambert({1.0f, 1.0f, 1.0f});
  const dvec3 plain = shadingNormal(OneTriangle(m, mesh).hit);  // twice as high: y counts half
  EXPECT_NEAR(glm::length(plain - glm::normalize(dvec3(0, 0.3, 0.8))), 0.0, 1e-6);
  m.normalTexture = textures::uniform({0.8f, 0.5f, 0.9f, 1.0f});
  const dvec3 bent = shadingNormal(OneTriangle(m, mesh).hit);
  EXPECT_NEAR(glm::length(bent - glm::normalize(0.6 * dvec3(1, 0, 0) + 0.8 * plain)), 0.0, 2e-3);
}

}  // namespace
}  // namespace steradian::oracle
