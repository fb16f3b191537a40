// SPDX-License-Identifier: MIT
// Scenes of meshes and of what they carry. Texels are wide beside a pixel, so that both look at the finest
// level; smooth normals lean little enough for mirrored directions to stay above the facets.
#include "tests/oracle/agreement_scenes.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian {
namespace {

using namespace scenes;

const CameraView kAbove = lookAt({0, 3.2, 4.2}, {0, 0.6, 0}, 0.65);
/// A picture of 2 x 2 m that hangs around the origin, alone.
const CameraView kFacing = lookAt({0.8, 0.5, 6}, {0, 0, 0}, 0.3);

/// A matt ground and a point light, which brute force sees without noise.
Scene litGround() {
  Scene scene = plainScene(1);
  scene.render.energyCompensation = false;
  add(scene, at({0, 0, 0}), Plane{}, lambert({0.5f, 0.4f, 0.3f}));
  addLight(scene, at({2, 3, 3}), PointLight{}, 20.0f, {1.0f, 0.8f, 0.6f});
  return scene;
}
Scene skyOver(Scene scene) {
  EnvironmentLight sky;
  sky.horizon = {0.6f, 0.8f, 1.0f};
  sky.ground = glm::vec3(0.3f);
  addLight(scene, at({0, 0, 0}), sky, 1.0f, {1.0f, 0.9f, 0.8f});
  return scene;
}

/// A hill of 0.35 m on 2 x 2 m, its normals those of the height's formula.
Mesh hill() {
  const auto height = [](float x, float z) { return 0.35f * (1.0f - x * x) * (1.0f - z * z); };
  Mesh mesh = meshes::terrain(6, height);
  for (const glm::vec3& p : mesh.positions)
    mesh.normals.push_back(
        glm::normalize(glm::vec3(0.7f * p.x * (1.0f - p.z * p.z), 1.0f, 0.7f * p.z * (1.0f - p.x * p.x))));
  return mesh;
}

Scene onGround(const Mesh& mesh, const Material& material, double up, double scale = 1.0) {
  Scene scene = litGround();
  add(scene, at({0, up, 0}, {1, 2, 0.5}, up > 0.1 ? 0.7 : 0.0, dvec3(scale)), textures::shape(mesh),
      material);
  return scene;
}
Scene glassUnderSky(const Mesh& mesh, Material material) {
  Scene scene = plainScene(24);
  scene.render.energyCompensation = false;
  add(scene, at({0, 0, 0}), Plane{}, lambert({0.5f, 0.4f, 0.3f}));
  material.transmission = 1.0f;
  add(scene, at({0, 0.9, 0}, {1, 2, 0.5}, 0.7, dvec3(0.9)), textures::shape(mesh), material);
  return skyOver(scene);
}
Scene glowing(const Mesh& mesh, const Material& material) {
  Scene scene = plainScene(3);
  scene.render.energyCompensation = false;
  add(scene, at({0, 0, 0}), Plane{}, lambert({0.5f, 0.4f, 0.3f}));
  add(scene, at({0, 0.5, 0}), Sphere{0.5}, plastic(0.5f, {0.2f, 0.5f, 0.8f}));
  add(scene, at({0.5, 2.8, 0.5}, {1, 1, 1}, 0.8, {1.9, 1.5, 1.7}), textures::shape(mesh), material);
  return scene;
}

/// Eight-bit colours of all kinds, opacity from 0.2 to 1.
std::shared_ptr<const Texture> tiles(textures::Format format = textures::Format::rgba8) {
  return textures::made(4, 4, format, [](int x, int y) {
    return glm::vec4(0.3f + 0.2f * float((x + 2 * y) % 4), 0.9f - 0.2f * float((2 * x + y) % 4),
                     0.25f * float(1 + (x * y) % 4), 0.2f + 0.2f * float((x + 3 * y) % 5));
  });
}
Scene painted(const Material& material, Mesh mesh = textures::picture()) {
  Scene scene = plainScene(2);
  scene.render.energyCompensation = false;
  add(scene, at({0, 0, 0}, {0, 1, 0}, 0.3), textures::shape(std::move(mesh)), material);
  add(scene, at({0, 0, -2}, {1, 0, 0}, 0.5 * pi), Rect{{12, 12}}, lambert({0.7f, 0.3f, 0.2f}));
  addLight(scene, at({2, 3, 4}), PointLight{}, 30.0f, {1.0f, 0.8f, 0.6f});
  return skyOver(scene);
}

}  // namespace

std::vector<AgreementCase> meshCases() {
  const Material satin = plastic(0.6f, {0.2f, 0.5f, 0.8f}), clear = plastic(0.0f, glm::vec3(1.0f));
  Material pane = clear;
  pane.thinWalled = true;
  pane.albedo = {0.9f, 0.5f, 0.2f};
  Material screen = emitter(1.0f, glm::vec3(0.3f));
  screen.emissionTexture = textures::slot(tiles());
  return {{"FlatMesh", onGround(meshes::icosphere(1), satin, 0.8, 0.8), kAbove, 8, 64, 2000},
          {"SmoothMesh", onGround(hill(), satin, 0.01), kAbove, 10, 64, 3000},
          {"SmoothMetalMesh", skyOver(onGround(hill(), metal(0.5f, {0.9f, 0.7f, 0.4f}), 0.01)), kAbove, 10,
           64, 3000},
          {"GlassMesh", glassUnderSky(meshes::icosphere(0), clear), kAbove},
          {"ThinWalledMesh", glassUnderSky(textures::picture(), pane), kAbove},
          {"GlowingMesh", glowing(meshes::icosphere(0), emitter(3.0f, glm::vec3(0.3f))), kAbove},
          {"GlowingTexturedMesh", glowing(textures::picture(), screen), kAbove, 6, 512, 30000}};
}

std::vector<AgreementCase> textureCases() {
  const auto of = [](TextureSlot Material::*place, const TextureSlot& slot) {
    Material m = plastic(0.8f, {0.9f, 0.8f, 0.7f});
    m.*place = slot;
    return m;
  };
  TextureSlot turned = textures::slot(tiles(textures::Format::rgba16), false);
  turned.wrapU = Wrap::mirror;
  turned.wrapV = Wrap::clamp;
  turned.transformX = {1.1f, 0.6f, -0.4f};
  turned.transformY = {-0.5f, 1.2f, 0.1f};
  Material varnish = of(&Material::metallicRoughnessTexture, textures::slot(tiles(), false));
  varnish.metallic = 0.9f;
  varnish.roughness = 1.0f;
  const auto waves = textures::made(4, 4, textures::Format::rgba8, [](int x, int y) {
    return glm::vec4(0.5f + 0.1f * float(x % 3 - 1), 0.5f + 0.1f * float((x + y) % 3 - 1), 0.95f, 1.0f);
  });
  Material bent = of(&Material::normalTexture, textures::slot(waves, false));
  bent.normalScale = 1.5f;
  Mesh withTangents = textures::picture();
  withTangents.normals.assign(4, {0, 0, 1});
  withTangents.tangents.assign(4, {1, 0, 0, -1});
  Mesh colored = textures::picture();
  colored.colors = {{1, 0.2, 0.2, 0.3}, {0.2, 1, 0.2, 1}, {0.2, 0.2, 1, 0.8}, {1, 1, 1, 0.5}};
  Material veil = of(&Material::albedoTexture, textures::slot(tiles(), false)), cut = veil, tinted = veil;
  veil.alphaMode = tinted.alphaMode = AlphaMode::blend;
  veil.opacity = 0.9f;
  cut.alphaMode = AlphaMode::mask;
  Material screen = of(&Material::emissionTexture, textures::slot(tiles(), false));
  screen.emissionLuminance = 2.0f;
  return {{"AlbedoTexture", painted(of(&Material::albedoTexture, textures::slot(tiles(), false))), kFacing},
          {"NearestTexels", painted(of(&Material::albedoTexture, textures::slot(tiles()))), kFacing},
          {"WrappedTexture", painted(of(&Material::albedoTexture, turned)), kFacing},
          {"MetallicRoughnessTexture", painted(varnish), kFacing},
          {"NormalTexture", painted(bent, withTangents), kFacing},
          {"VertexColors", painted(tinted, colored), kFacing},
          {"AlphaBlend", painted(veil), kFacing},
          {"AlphaMask", painted(cut), kFacing},
          {"EmissionTexture", painted(screen), kFacing}};
}

}  // namespace steradian
