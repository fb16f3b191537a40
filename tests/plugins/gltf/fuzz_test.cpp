// SPDX-License-Identifier: MIT
// Mutated and real files: each is imported or refused with a reason, none crashes, hangs or fails without
// one.
#include <chrono>
#include <random>

#include "tests/plugins/gltf/maker.hpp"

namespace steradian::plugins {
namespace {

using GltfFuzz = Gltf;

GltfMaker everything() {
  GltfMaker maker;
  Json& primitive = maker.triangle();
  primitive["indices"] = maker.accessor<std::uint8_t>({0, 1, 2}, "SCALAR");
  Json& a = primitive["attributes"];
  a["NORMAL"] = maker.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  a["TEXCOORD_0"] = maker.accessor<std::uint16_t>({0, 0, 65535, 0, 0, 65535}, "VEC2", true);
  a["JOINTS_0"] = maker.accessor<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
  a["WEIGHTS_0"] = maker.accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  primitive["targets"] = {{{"POSITION", a["POSITION"]}}};
  maker.json["meshes"][0]["weights"] = {0.5};
  primitive["material"] = maker.append(
      "materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                    {"alphaMode", "BLEND"},
                    {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}});
  maker.append("textures", {{"source", 0}, {"sampler", 0}});
  maker.append("samplers", {{"wrapS", 33071}});
  maker.append("images", {{"uri", "data:image/png;base64,iVBORw0KGgo="}});
  const std::size_t joint = maker.root({{"name", "j"}, {"rotation", {0, 0, 0, 1}}});
  maker.json["nodes"][0]["skin"] = maker.append("skins", {{"joints", {joint}}});
  const std::size_t times = maker.accessor<float>({0, 1}, "SCALAR"),
                    turns = maker.accessor<float>({0, 0, 0, 1, 0, 1, 0, 0}, "VEC4");
  maker.append("animations",
               {{"samplers", {{{"input", times}, {"output", turns}}}},
                {"channels", {{{"sampler", 0}, {"target", {{"node", joint}, {"path", "rotation"}}}}}}});
  maker.root({{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
              {"camera", maker.append("cameras", {{"type", "perspective"},
                                                  {"perspective", {{"yfov", 1}, {"znear", 1}}}})},
              {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  maker.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"spot", Json::object()}}};
  return maker;
}

/// Changes a few bytes, cuts, repeats, or puts in a number or word that parsers dislike.
std::string mutated(std::string file, std::mt19937_64& random) {
  static const char* const kTokens[] = {
      "-1", "0", "1e308", "4294967296", "18446744073709551615", "null", "[", "{}", "\"\"", "true", "9999"};
  const auto below = [&](std::size_t n) { return std::size_t(random() % std::max<std::size_t>(n, 1)); };
  for (std::size_t n = 1 + below(2); n > 0 && !file.empty(); --n) {
    const std::size_t i = below(file.size());
    switch (below(5)) {
      case 0:
        file[i] = char(random());
        break;
      case 1:
        file.erase(i, 1 + below(8));
        break;
      case 2:
        file.insert(i, file.substr(below(file.size()), below(32)));
        break;
      case 3: {  // a number that stands in the text
        const std::size_t digit = file.find_first_of("0123456789", i);
        if (digit != file.npos) file.replace(digit, 1, kTokens[below(std::size(kTokens))]);
        break;
      }
      default:
        file[i] = char(file[i] ^ (1 << below(8)));
    }
  }
  return file;
}

TEST_F(GltfFuzz, ThousandsOfMutationsAreImportedOrRefusedWithAReason) {
  std::mt19937_64 random(20261122);
  GltfMaker small;
  small.triangle();
  const std::pair<const char*, std::string> seeds[] = {
      {"a.gltf", everything().text()}, {"a.glb", everything().glb()}, {"a.glb", small.glb()}};
  ASSERT_EQ(import(seeds[0].second).scene.objects.size(), 6u);
  std::size_t imported = 0, refused = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto& seed = seeds[i % 3];
    const std::string file = mutated(seed.second, random);
    const auto [message, code] = faultOf([&] { import(file, {}, seed.first); });
    (code == ExitCode::ok ? imported : refused)++;
    ASSERT_TRUE(code == ExitCode::ok || code == ExitCode::badInput) << "mutation " << i << ": " << message;
  }
  std::printf("%zu imported, %zu refused\n", imported, refused);
  EXPECT_GT(imported, 150u);
  EXPECT_GT(refused, 300u);
}

TEST_F(GltfFuzz, AllModelsOfDebiansAssimpTestmodelsAreImportedOrRefusedWithAReason) {
  const fs::path models = "/usr/share/assimp/models";
  if (!fs::exists(models / "glTF2")) GTEST_SKIP() << "the package assimp-testmodels is not installed";
  std::size_t imported = 0;
  std::string refusals;
  for (const auto& entry : fs::recursive_directory_iterator(models)) {
    if (entry.path().extension() != ".gltf" && entry.path().extension() != ".glb") continue;
    const auto begin = std::chrono::steady_clock::now();
    const auto [message, code] = faultOf([&] { stockPlugins().importScene(entry.path()); });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    EXPECT_TRUE(code == ExitCode::ok || code == ExitCode::badInput) << message;
    EXPECT_LT(seconds, 5.0) << entry.path();
    if (code == ExitCode::ok)
      ++imported;
    else
      refusals += message + "\n";
  }
  std::printf("%zu imported; refused:\n%s", imported, refusals.c_str());
  EXPECT_GT(imported, 25u);
}

}  // namespace
}  // namespace steradian::plugins
