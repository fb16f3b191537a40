// SPDX-License-Identifier: MIT
// glTF materials, textures and their extensions.
#include <cmath>

#include "tests/plugins/gltf/maker.hpp"

namespace steradian::plugins {
namespace {

using GltfMaterial = Gltf;

const std::string kPng = "\x89PNG\r\n\x1a\n not decoded by the importer";

/// One triangle with this material.
GltfMaker with(Json material) {
  GltfMaker maker;
  maker.triangle()["material"] = maker.append("materials", std::move(material));
  return maker;
}

const Material& onlyMaterial(const ImportResult& result) {
  return result.scene.materials.at(0);
}

TEST_F(GltfMaterial, WithoutOneTheDefaultOfGltfIsWhiteRoughMetal) {
  GltfMaker maker;
  maker.triangle();
  const ImportResult result = import(maker);
  EXPECT_EQ(onlyMaterial(result).albedo, glm::vec3(1));
  EXPECT_EQ(onlyMaterial(result).metallic, 1.0f);
  EXPECT_EQ(onlyMaterial(result).roughness, 1.0f);
  EXPECT_EQ(std::get<Geometry>(result.scene.objects[0].content).material, onlyMaterial(result).id);
}

TEST_F(GltfMaterial, FactorsArriveAndTheDoubleSidedFlagIsKept) {
  const ImportResult result = import(
      with({{"name", "m"},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"metallicFactor", 0.5}, {"roughnessFactor", 0.6}}},
            {"emissiveFactor", {1, 0, 0.5}},
            {"alphaMode", "MASK"},
            {"alphaCutoff", 0.7},
            {"doubleSided", true}}));
  const Material& m = onlyMaterial(result);
  EXPECT_EQ(m.albedo, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(m.opacity, 0.4f);
  EXPECT_EQ(m.metallic, 0.5f);
  EXPECT_EQ(m.roughness, 0.6f);
  EXPECT_EQ(m.emissionColor, glm::vec3(1, 0, 0.5));
  EXPECT_EQ(m.emissionLuminance, 1.0f);
  EXPECT_EQ(m.alphaMode, AlphaMode::mask);
  EXPECT_EQ(m.alphaCutoff, 0.7f);
  EXPECT_EQ(m.extras, R"({"gltf":{"doubleSided":true}})");
  EXPECT_EQ(linesOf(result.report), "");
}

TEST_F(GltfMaterial, TexturesAreHandedOverEncodedAndSharedByImage) {
  GltfMaker maker = with({{"pbrMetallicRoughness",
                           {{"baseColorTexture", {{"index", 0}}},
                            {"metallicRoughnessTexture", {{"index", 1}, {"texCoord", 1}}}}},
                          {"normalTexture", {{"index", 0}, {"scale", 0.5}}},
                          {"occlusionTexture", {{"index", 0}}},
                          {"emissiveTexture", {{"index", 0}}},
                          {"emissiveFactor", {1, 1, 1}}});
  maker.append("images", {{"uri", "two%20words.png"}});
  maker.append("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
  maker.append("textures", {{"source", 0}});
  maker.append("textures", {{"source", 0}, {"sampler", 0}});
  writeText(folder / "two words.png", kPng);
  const ImportResult result = import(maker);
  const Material& m = onlyMaterial(result);
  ASSERT_TRUE(m.albedoTexture.texture);
  EXPECT_EQ(std::string(m.albedoTexture.texture->encoded.begin(), m.albedoTexture.texture->encoded.end()),
            kPng);
  EXPECT_EQ(m.albedoTexture.texture, m.normalTexture.texture);
  EXPECT_EQ(m.albedoTexture.texture, m.emissionTexture.texture);
  EXPECT_EQ(m.normalScale, 0.5f);
  EXPECT_EQ(m.albedoTexture.wrapU, Wrap::repeat);
  EXPECT_EQ(m.metallicRoughnessTexture.uvSet, 1u);
  EXPECT_EQ(m.metallicRoughnessTexture.wrapU, Wrap::clamp);
  EXPECT_EQ(m.metallicRoughnessTexture.wrapV, Wrap::mirror);
  EXPECT_TRUE(m.metallicRoughnessTexture.nearest);
  EXPECT_CONTAINS(linesOf(result.report),
                  "material 0, occlusion texture: left out: a path tracer computes the occlusion");
}

TEST_F(GltfMaterial, ImagesComeFromBufferViewsAndDataUrisToo) {
  GltfMaker maker = with(
      {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"normalTexture", {{"index", 1}}}});
  maker.append("images", {{"bufferView", maker.view(std::vector<char>(kPng.begin(), kPng.end()))},
                          {"mimeType", "image/png"}});
  maker.append("images", {{"uri", "data:image/png;base64," + base64(kPng)}});
  maker.append("textures", {{"source", 0}});
  maker.append("textures", {{"source", 1}});
  const ImportResult result = import(maker);
  const Material& m = onlyMaterial(result);
  ASSERT_TRUE(m.albedoTexture.texture && m.normalTexture.texture) << linesOf(result.report);
  EXPECT_EQ(m.albedoTexture.texture->encoded, m.normalTexture.texture->encoded);
}

TEST_F(GltfMaterial, TextureTransformsAreMatrices) {
  GltfMaker maker = with({{"pbrMetallicRoughness",
                           {{"baseColorTexture",
                             {{"index", 0},
                              {"extensions",
                               {{"KHR_texture_transform",
                                 {{"offset", {0.25, 0.5}},
                                  {"rotation", 1.5707963267948966},
                                  {"scale", {2, 3}},
                                  {"texCoord", 1}}}}}}}}}});
  maker.append("images", {{"uri", "data:image/png;base64," + base64(kPng)}});
  maker.append("textures", {{"source", 0}});
  const TextureSlot slot = onlyMaterial(import(maker)).albedoTexture;
  // (u, v) = (1, 0) scaled to (2, 0), a quarter turn counter-clockwise on an image whose v points down: (0,
  // -2).
  const glm::vec3 uv(1, 0, 1);
  EXPECT_NEAR(glm::dot(slot.transformX, uv), 0.25, 1e-6);
  EXPECT_NEAR(glm::dot(slot.transformY, uv), 0.5 - 2, 1e-6);
  EXPECT_EQ(slot.uvSet, 1u);
}

TEST_F(GltfMaterial, ExtensionsThatTheMaterialKnowsAreExact) {
  const ImportResult result = import(
      with({{"emissiveFactor", {1, 1, 1}},
            {"extensions",
             {{"KHR_materials_emissive_strength", {{"emissiveStrength", 250}}},
              {"KHR_materials_ior", {{"ior", 1.33}}},
              {"KHR_materials_transmission", {{"transmissionFactor", 1}}},
              {"KHR_materials_volume",
               {{"thicknessFactor", 2}, {"attenuationDistance", 3}, {"attenuationColor", {0.5, 0, 1}}}},
              {"KHR_materials_clearcoat", {{"clearcoatFactor", 0.25}, {"clearcoatRoughnessFactor", 0.125}}},
              {"KHR_materials_specular", {{"specularFactor", 0.75}}}}}}));
  const Material& m = onlyMaterial(result);
  EXPECT_EQ(m.emissionLuminance, 250.0f);
  EXPECT_EQ(m.ior, 1.33f);
  EXPECT_EQ(m.transmission, 1.0f);
  EXPECT_FALSE(m.thinWalled);
  EXPECT_EQ(m.attenuationDistance, 3.0f);
  EXPECT_EQ(m.attenuationColor, glm::vec3(0.5f, 1e-6f, 1));
  EXPECT_EQ(m.clearcoat, 0.25f);
  EXPECT_EQ(m.clearcoatRoughness, 0.125f);
  EXPECT_EQ(m.specular, 0.75f);
  EXPECT_EQ(linesOf(result.report), "");
}

TEST_F(GltfMaterial, TransmissionWithoutAVolumeIsAThinWall) {
  const ImportResult result =
      import(with({{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.5}}}}}}));
  EXPECT_TRUE(onlyMaterial(result).thinWalled);
}

TEST_F(GltfMaterial, SheenAndColouredSpecularAreApproximatedAndSaySo) {
  const ImportResult result =
      import(with({{"extensions",
                    {{"KHR_materials_sheen", {{"sheenColorFactor", {1, 0, 0}}}},
                     {"KHR_materials_specular", {{"specularColorFactor", {1, 0, 0}}}},
                     {"KHR_materials_clearcoat", {{"clearcoatTexture", {{"index", 0}}}}}}}}));
  EXPECT_CONTAINS(linesOf(result.report), "material 0, sheen: approximated");
  EXPECT_CONTAINS(linesOf(result.report), "material 0, specular colour: approximated");
  EXPECT_CONTAINS(linesOf(result.report), "material 0, clearcoatTexture: left out");
}

TEST_F(GltfMaterial, UnlitIsPureEmission) {
  const ImportResult result = import(with({{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 1}}}},
                                           {"extensions", {{"KHR_materials_unlit", Json::object()}}}}));
  const Material& m = onlyMaterial(result);
  EXPECT_EQ(m.albedo, glm::vec3(0));
  EXPECT_EQ(m.emissionColor, glm::vec3(0.5, 0.25, 1));
  EXPECT_EQ(m.emissionLuminance, 1.0f);
  EXPECT_EQ(m.specular, 0.0f);
  EXPECT_CONTAINS(linesOf(result.report), "material 0, unlit: approximated");
}

TEST_F(GltfMaterial, fault10_MissingAndUnreadableTexturesCostTheirSlotOnly) {
  GltfMaker maker = with(
      {{"name", "m"},
       {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}, {"baseColorTexture", {{"index", 0}}}}},
       {"normalTexture", {{"index", 1}}},
       {"emissiveFactor", {1, 1, 1}},
       {"emissiveTexture", {{"index", 2}}}});
  maker.append("images", {{"uri", "missing.png"}});
  maker.append("images", {{"uri", "empty.png"}});
  maker.append("images", {{"uri", "text.png"}});
  for (int i = 0; i < 3; ++i) maker.append("textures", {{"source", i}});
  writeText(folder / "empty.png", "");
  writeText(folder / "text.png", "this is no image");
  const ImportResult result = import(maker);
  EXPECT_EQ(onlyMaterial(result).albedo, glm::vec3(1, 0, 0));
  EXPECT_FALSE(onlyMaterial(result).albedoTexture.texture);
  EXPECT_CONTAINS(linesOf(result.report), "material 'm', base colour texture: left out: images[0].uri: ");
  EXPECT_CONTAINS(linesOf(result.report), "missing.png: cannot be opened");
  EXPECT_CONTAINS(linesOf(result.report), "material 'm', normal texture: left out: images[1]: is empty");
  EXPECT_CONTAINS(linesOf(result.report),
                  "material 'm', emissive texture: left out: images[2]: expected a PNG or JPEG");
}

TEST_F(GltfMaterial, AMaterialThatIsUnsoundTakesTheDefaultsAndTheRestLoads) {
  const ImportResult result =
      import(with({{"name", "m"}, {"pbrMetallicRoughness", {{"roughnessFactor", 7}}}}));
  EXPECT_EQ(result.scene.objects.size(), 1u);
  EXPECT_CONTAINS(linesOf(result.report),
                  "materials[0].pbrMetallicRoughness.roughnessFactor: expected a number from 0 to 1, got 7");
}

}  // namespace
}  // namespace steradian::plugins
