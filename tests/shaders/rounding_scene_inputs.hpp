// SPDX-License-Identifier: MIT
// A scene for the functions that read one, and hard questions about it.
#pragma once
#include <array>
#include <bit>

#include "renderer/gpu_scene.hpp"
#include "tests/renderer/scenes.hpp"
#include "tests/renderer/textures.hpp"
#include "tests/shaders/kernel.hpp"

namespace steradian::kernel {

using SceneQuestion = std::array<glm::vec4, 2>;

/// The sky of the scene below: dim, black in places, and with one texel that outshines all others.
inline std::shared_ptr<const Image> hardSky() {
  auto image = std::make_shared<Image>(Image{16, 8, 3, std::vector<float>(16 * 8 * 3)});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x)
      for (int c = 0; c < 3; ++c) image->at(x, y)[c] = 0.02f * float((3 * x + 5 * y + 2 * c) % 7);
  image->at(11, 2)[1] = 1e4f;
  return image;
}

/// One texture for each of the formats and ways of wrapping that lookups tell apart.
inline std::array<TextureSlot, 3> hardTextures() {
  using textures::Format;
  const auto texel = [](int x, int y) {
    const auto part = [&](int a, int b) { return float(1 + (x * a + y * b) % 16) / 16.0f; };
    return glm::vec4(part(5, 3), part(7, 11), part(2, 9), part(3, 8));
  };
  std::array<TextureSlot, 3> slots = {textures::slot(textures::made(13, 7, Format::rgba8, texel), false),
                                      textures::slot(textures::made(64, 32, Format::rgba16, texel), false),
                                      textures::slot(textures::made(5, 9, Format::rgbaHalf, texel), true)};
  slots[1].wrapU = Wrap::mirror;
  slots[1].wrapV = Wrap::clamp;
  slots[1].transformX = {1.3f, -0.4f, 0.2f};
  slots[1].transformY = {0.5f, 0.8f, -0.1f};
  return slots;
}

/// Fifty lights at distances and of powers over many decades; the last is a mesh that glows in the pattern of
/// a texture, stretched and mirrored.
inline Scene hardScene() {
  using namespace scenes;
  Random random(77);
  Scene scene = plainScene(2);
  EnvironmentLight sky;
  sky.image = hardSky();
  addLight(scene, at({0, 0, 0}, {1, 2, 3}, 0.9), sky, 1.0f);
  for (int i = 0; i < 49; ++i) {
    const dvec3 place = random.direction() * random.decades(-1, 3);
    const float power = float(random.decades(-4, 4));
    if (i % 3 == 0) addLight(scene, at(place), SphereLight{random.decades(-2, 0)}, power);
    if (i % 3 == 1) addLight(scene, at(place), PointLight{}, power);
    if (i % 3 == 2) addLight(scene, at(place), DirectionalLight{0.01f}, power);
  }
  Mesh lantern = textures::smoothBall(1);
  for (glm::vec3& p : lantern.positions) {
    lantern.uv0.emplace_back(2.0f * p.x, 2.0f * p.y);
    p.x = p.x > 0.0f ? p.x * p.x : p.x;
  }
  Material m = emitter(3.0f);
  m.albedoTexture = hardTextures()[0];
  m.emissionTexture = hardTextures()[1];
  m.metallicRoughnessTexture = hardTextures()[2];
  add(scene, at({0.3, 1, -2}, {1, 1, 0}, 0.8, dvec3(0.5, -0.9, 0.3)), textures::shape(lantern), m);
  return scene;
}
inline CameraView hardView() {
  return scenes::lookAt({3, 1, 4}, {0, 0.5, 0}, 0.8);
}

/// The lamp's middle as the shaders see it, relative to the camera.
inline glm::dvec3 lampCentre() {
  return glm::dvec3(0.3, 1, -2) - glm::dvec3(hardView().worldFromCamera[3]);
}

/// Rows of a primitive's texture references: albedo, metallic-roughness, normal, emission.
inline glm::uvec4 textureRefs(const GpuScene& packed, std::uint32_t primitive) {
  return std::bit_cast<glm::uvec4>(
      packed.rows[packed.params.materialRow + primitive * gpu::MATERIAL_ROWS + 6]);
}

/// Which light is the mesh.
inline float meshLightOf(const GpuScene& packed) {
  std::uint32_t light = 0;
  while (packed.rows[packed.params.lightRow + light * gpu::LIGHT_ROWS].w != float(gpu::LIGHT_MESH)) ++light;
  return float(light);
}

}  // namespace steradian::kernel
