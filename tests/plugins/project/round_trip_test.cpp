// SPDX-License-Identifier: MIT
// What is saved is what is loaded, to the last bit and the last byte.
#include <cmath>
#include <random>

#include "renderer/scene/validate.hpp"
#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

using ProjectFile = FolderTest;

/// Sound scenes with awkward numbers.
class SceneMaker {
 public:
  explicit SceneMaker(std::uint64_t seed) : random_(seed) {}

  Scene make() {
    Scene scene{.name = text()};
    for (std::uint32_t i = 1; i <= 4; ++i) scene.materials.push_back(material(Id{i}));
    for (std::uint32_t i = 5; i < 25; ++i) scene.objects.push_back(object(Id{i}, scene));
    scene.nextId = Id{25 + below(3)};
    scene.render = {.width = int(1 + below(9000)),
                    .height = 7,
                    .maxBounces = int(below(65)),
                    .lightSamples = int(1 + below(16)),
                    .russianRoulette = below(2) == 0,
                    .errorMeter = below(2) == 0,
                    .energyCompensation = below(2) == 0,
                    .clamp = below(2) ? float(spread(1e-3, 1e6)) : 0.0f,
                    .filter = PixelFilter(below(2)),
                    .seed = std::uint32_t(random_())};
    scene.display = {.exposure = float(real(-9, 9)),
                     .physical = below(2) == 0,
                     .ev100 = float(real(-9, 20)),
                     .tonemapper = "org.nowhere.tonemap.lost",
                     .parameters = {{"whitePoint", float(real(0, 9))}, {"Ünï \"code\"", -0.0f}},
                     .transfer = Transfer(below(2)),
                     .gamma = float(real(1, 3))};
    scene.animation.framesPerSecond = real(1, 120);
    addChannels(scene);
    if (below(2))
      scene.extras = R"({"generator":{"name":"x","numbers":[1,2.5,-1e+300,18446744073709551615]}})";
    return scene;
  }

 private:
  std::uint32_t below(std::uint32_t n) { return std::uint32_t(random_() % n); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double spread(double low, double high) { return std::exp(real(std::log(low), std::log(high))); }
  std::string text() {
    static const char* const texts[] = {
        "", "Lamp", "tab\tnew\nline", "日本語", "quote \" back \\ slash / \x7f", "🙂"};
    return texts[below(6)];
  }
  glm::dquat rotation() {
    const glm::dquat q(real(-1, 1), real(-1, 1), real(-1, 1), real(0.1, 1));
    return q / glm::length(q);
  }
  Material material(Id id) {
    const auto unit = [&] { return float(real(0, 1)); };
    return {.id = id,
            .name = text(),
            .albedo = {unit(), unit(), 0.1f},
            .metallic = unit(),
            .roughness = unit(),
            .specular = unit(),
            .ior = float(real(1, 3)),
            .emissionColor = {unit(), 3.0f, unit()},
            .emissionLuminance = float(spread(1e-20, 1e9)),
            .transmission = unit(),
            .attenuationColor = {unit() + 1e-9f, 1.0f, 0.3f},
            .attenuationDistance = below(2) ? float(spread(1e-9, 1e9)) : 0.0f,
            .clearcoat = unit(),
            .clearcoatRoughness = unit(),
            .edgeTint = {unit(), 1.0f, 0.2f},
            .extras = below(2) ? R"({"coat":{"weight":0.30000000000000004}})" : ""};
  }
  Shape shape() {
    switch (below(6)) {
      case 0:
        return Sphere{spread(1e-9, 1e9)};
      case 1:
        return Plane{};
      case 2:
        return Box{{spread(1e-9, 1e9), 2.0, 1.0 / 3.0}};
      case 3:
        return Rect{{spread(1e-9, 1e9), 2.0}};
      case 4:
        return Disk{real(0.1, 1)};
      default:
        return Cylinder{1.0, spread(1e-9, 1e9)};
    }
  }
  Light light() {
    Light out{.color = {float(real(0, 1)), 1.0f, 0.7f}, .intensity = float(spread(1e-30, 1e11))};
    if (below(2)) out.temperature = float(real(1000, 40000));
    out.kind = lightKind();
    return out;
  }
  decltype(Light::kind) lightKind() {
    switch (below(8)) {
      case 0:
        return PointLight{};
      case 1:
        return SpotLight{0.1f, float(real(0.2, 1.5))};
      case 2:
        return DirectionalLight{};
      case 3:
        return DirectionalLight{float(real(0, 1.5))};
      case 4:
        return SphereLight{below(2) ? 0.25 : spread(1e-9, 1e9)};
      case 5:
        return RectLight{{below(2) ? 1.0 : spread(1e-9, 1e9), 1.0}};
      case 6:
        return DiskLight{below(2) ? 0.5 : spread(1e-9, 1e9)};
      default:
        return EnvironmentLight{.horizon = {float(real(0, 9)), 1.0f, 0.0f},
                                .ground = below(2) ? glm::vec3(1.0f) : glm::vec3(0.0f, 0.1f, 0.2f),
                                .file = below(2) ? "" : "maps/sky \"ü\".exr"};
    }
  }
  Camera camera() {
    Camera out{real(0.01, 3.1)};
    if (below(2) == 0) return out;
    out.projection = Projection(below(2));
    out.orthographicHeight = spread(1e-9, 1e9);
    out.fNumber = spread(0.1, 64);
    out.focusDistance = spread(1e-3, 1e6);
    return out;
  }
  Object object(Id id, const Scene& scene) {
    Object out{.id = id, .name = text()};
    if (!scene.objects.empty() && below(3) == 0) out.parent = scene.objects[below(scene.objects.size())].id;
    out.transform = {
        {real(-1, 1) * spread(1e-9, 1e6), -0.0, real(-5, 5)}, rotation(), {real(0.5, 2), -1.0, 1.0}};
    out.visible = below(4) != 0;
    switch (below(4)) {
      case 0:
        out.content = Geometry{shape(), Id{below(5)}};
        break;
      case 1:
        out.content = light();
        break;
      case 2:
        out.content = camera();
        break;
      default:
        break;
    }
    if (below(3) == 0) out.extras = R"({"vendor":[{"a":null},true,"x"]})";
    return out;
  }
  void addChannels(Scene& scene) {
    for (const Object& object : scene.objects) {
      const bool light = std::holds_alternative<Light>(object.content);
      Channel channel{object.id, Property(below(light ? 5 : 3)), Interpolation(below(3))};
      double time = real(-1, 1);
      for (std::uint32_t i = 0; i < 3; ++i, time += spread(1e-6, 10))
        channel.keys.push_back({time, value(channel)});
      scene.animation.channels.push_back(channel);
    }
  }
  glm::dvec4 value(const Channel& channel) {
    if (channel.property == Property::rotation) {
      const glm::dquat q = rotation();
      return {q.x, q.y, q.z, q.w};
    }
    if (channel.property == Property::lightIntensity) return {real(0, 99), 0, 0, 0};
    return {real(0.1, 9), real(0.1, 9), 1.0 / 3.0, 0};
  }

  std::mt19937_64 random_;
};

TEST_F(ProjectFile, RandomScenesComeBackEqualAndSaveToTheSameBytes) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Scene scene = SceneMaker(seed).make();
    const auto problems = problemsOf(scene);
    ASSERT_TRUE(problems.empty()) << problems[0].where << " " << problems[0].what;
    stockPlugins().exportScene(scene, folder / "a.srad");
    const ImportResult loaded = stockPlugins().importScene(folder / "a.srad");
    ASSERT_TRUE(loaded.scene == scene) << "seed " << seed << "\n" << readText(folder / "a.srad");
    EXPECT_TRUE(loaded.report.notKept.empty());
    stockPlugins().exportScene(loaded.scene, folder / "b.srad");
    ASSERT_EQ(readText(folder / "a.srad"), readText(folder / "b.srad"));
  }
}

TEST_F(ProjectFile, LightsOfTheDefaultSizeAreWrittenEmptyAndReadAlike) {
  Scene scene;
  for (const Light& light :
       {Light{SphereLight{}}, Light{RectLight{}}, Light{DiskLight{}}, Light{EnvironmentLight{}}})
    scene.objects.push_back({.id = Id{unsigned(scene.objects.size()) + 1}, .content = light});
  scene.nextId = Id{5};
  stockPlugins().exportScene(scene, folder / "a.srad");
  for (const char* part :
       {"\"sphereLight\": {}", "\"rectLight\": {}", "\"diskLight\": {}", "\"environmentLight\": {}"})
    EXPECT_CONTAINS(readText(folder / "a.srad"), part);
  EXPECT_TRUE(stockPlugins().importScene(folder / "a.srad").scene == scene);
}

TEST_F(ProjectFile, EveryNewKeyIsReadByItsName) {
  writeText(folder / "a.srad", R"({"steradian": 1,
    "render": {"energyCompensation": false, "clamp": 20},
    "display": {"physical": true, "ev100": 9.5},
    "materials": [{"id": 1, "transmission": 0.9, "attenuationColor": [0.5, 0.6, 0.7], "attenuationDistance": 0.1,
      "clearcoat": 0.8, "clearcoatRoughness": 0.2, "edgeTint": [0.9, 0.8, 0.7]}],
    "objects": [{"id": 2, "camera": {"projection": "orthographic", "orthographicHeight": 3, "fNumber": 1.4, "focusDistance": 2}},
      {"id": 3, "directionalLight": {"angularDiameter": 0.0093, "temperature": 5778}},
      {"id": 4, "sphereLight": {"radius": 2}}, {"id": 5, "rectLight": {"size": [3, 4]}}, {"id": 6, "diskLight": {"radius": 5}},
      {"id": 7, "environmentLight": {"horizon": [1, 2, 3], "ground": [4, 5, 6], "file": "sky.exr", "intensity": 7}}]})");
  const Scene s = stockPlugins().importScene(folder / "a.srad").scene;
  EXPECT_FALSE(s.render.energyCompensation);
  EXPECT_EQ(s.render.clamp, 20.0f);
  EXPECT_TRUE(s.display.physical);
  EXPECT_EQ(s.display.ev100, 9.5f);
  const Material glass{.id = Id{1},
                       .transmission = 0.9f,
                       .attenuationColor = {0.5f, 0.6f, 0.7f},
                       .attenuationDistance = 0.1f,
                       .clearcoat = 0.8f,
                       .clearcoatRoughness = 0.2f,
                       .edgeTint = {0.9f, 0.8f, 0.7f}};
  EXPECT_EQ(s.materials[0], glass);
  EXPECT_EQ(std::get<Camera>(s.objects[0].content), (Camera{0.7853982, Projection::orthographic, 3, 1.4, 2}));
  EXPECT_EQ(std::get<Light>(s.objects[1].content),
            (Light{.kind = DirectionalLight{0.0093f}, .temperature = 5778.0f}));
  EXPECT_EQ(std::get<Light>(s.objects[2].content), Light{SphereLight{2}});
  EXPECT_EQ(std::get<Light>(s.objects[3].content), (Light{RectLight{{3, 4}}}));
  EXPECT_EQ(std::get<Light>(s.objects[4].content), Light{DiskLight{5}});
  EXPECT_EQ(std::get<Light>(s.objects[5].content),
            (Light{.kind = EnvironmentLight{{1, 2, 3}, {4, 5, 6}, "sky.exr", nullptr}, .intensity = 7.0f}));
}

TEST_F(ProjectFile, KeepsTheSignOfZero) {
  Scene scene;
  scene.objects = {{.id = Id{1}}};
  scene.nextId = Id{2};
  scene.objects[0].transform.translation.x = -0.0;
  stockPlugins().exportScene(scene, folder / "a.srad");
  EXPECT_TRUE(
      std::signbit(stockPlugins().importScene(folder / "a.srad").scene.objects[0].transform.translation.x));
}

TEST_F(ProjectFile, UnknownKeysSurviveAtEveryLevel) {
  writeText(folder / "a.srad",
            R"({"steradian": 1, "future": {"b": 1, "a": [{"x": 1}]}, "render": {"denoise": true},
    "animation": {"loop": true}, "materials": [{"id": 1, "coat": 0.5}],
    "objects": [{"id": 2, "tags": ["a"], "sphere": {"radius": 2, "segments": 9}}]})");
  const Scene scene = stockPlugins().importScene(folder / "a.srad").scene;
  stockPlugins().exportScene(scene, folder / "b.srad");
  const std::string text = readText(folder / "b.srad");
  for (const char* part : {"\"future\"", "\"denoise\": true", "\"loop\": true", "\"coat\": 0.5",
                           "\"tags\": [\"a\"]", "{\"radius\": 2, \"segments\": 9}"})
    EXPECT_CONTAINS(text, part);
  EXPECT_TRUE(stockPlugins().importScene(folder / "b.srad").scene == scene);
}

TEST_F(ProjectFile, AnOldContentsUnknownKeysDoNotComeBackOnAnotherContent) {
  writeText(folder / "a.srad", R"({"steradian": 1, "objects": [{"id": 2, "sphere": {"segments": 9}}]})");
  Scene scene = stockPlugins().importScene(folder / "a.srad").scene;
  scene.objects[0].content = Geometry{Box{}};
  stockPlugins().exportScene(scene, folder / "b.srad");
  EXPECT_TRUE(std::holds_alternative<Box>(
      std::get<Geometry>(stockPlugins().importScene(folder / "b.srad").scene.objects[0].content).shape));
}

TEST_F(ProjectFile, UnknownKeysThatWouldNestTooDeepAreLeftOutAndReported) {
  const auto nested = [](std::size_t depth) {
    return R"({"x":)" + std::string(depth, '[') + std::string(depth, ']') + "}";
  };
  Scene scene;
  scene.objects = {{.id = Id{1}, .extras = nested(61)}, {.id = Id{2}, .extras = nested(62)}};
  scene.nextId = Id{3};
  std::string log;
  stockPlugins().exportScene(scene, folder / "a.srad",
                             {.log = [&](const std::string& line) { log += line; }});
  EXPECT_CONTAINS(log, "unknown keys were not saved");
  const Scene loaded = stockPlugins().importScene(folder / "a.srad").scene;
  EXPECT_EQ(loaded.objects[0].extras, nested(61));
  EXPECT_EQ(loaded.objects[1].extras, "");
}

TEST_F(ProjectFile, IsWrittenOneObjectPerLineWithoutDefaults) {
  Scene scene{.name = "hello"};
  scene.materials = {{.id = Id{1}, .name = "red", .albedo = {0.8f, 0.1f, 0.1f}}};
  scene.objects = {{.id = Id{2}, .name = "Ball", .content = Geometry{Sphere{}, Id{1}}},
                   {.id = Id{3}, .content = Light{.intensity = 60}}};
  scene.objects[1].transform.translation = {0, 2.5, 0};
  scene.nextId = Id{4};
  stockPlugins().exportScene(scene, folder / "a.srad");
  EXPECT_EQ(readText(folder / "a.srad"), R"({
  "steradian": 1,
  "name": "hello",
  "materials": [
    {"id": 1, "name": "red", "albedo": [0.8, 0.1, 0.1]}
  ],
  "objects": [
    {"id": 2, "name": "Ball", "sphere": {}, "material": 1},
    {"id": 3, "translation": [0, 2.5, 0], "pointLight": {"intensity": 60}}
  ]
}
)");
}

TEST_F(ProjectFile, ObjectsWrittenWithoutIdsGetFreeOnes) {
  writeText(
      folder / "a.srad",
      R"({"steradian": 1, "nextId": 9, "materials": [{"name": "m"}], "objects": [{"name": "a"}, {"id": 20}]})");
  const Scene scene = stockPlugins().importScene(folder / "a.srad").scene;
  EXPECT_EQ(scene.materials[0].id, Id{21});
  EXPECT_EQ(scene.objects[0].id, Id{22});
  EXPECT_EQ(scene.nextId, Id{23});
}

TEST_F(ProjectFile, AFolderMeansItsOneProject) {
  fs::create_directory(folder / "room");
  EXPECT_CONTAINS(faultOf([&] { stockPlugins().importScene(folder / "room"); }).first, "0 .srad files");
  writeText(folder / "room/a.srad", R"({"steradian": 1, "name": "a"})");
  EXPECT_EQ(stockPlugins().importScene(folder / "room").scene.name, "a");
  writeText(folder / "room/b.srad", "{}");
  EXPECT_CONTAINS(faultOf([&] { stockPlugins().importScene(folder / "room"); }).first, "2 .srad files");
}

TEST_F(ProjectFile, IsRecognisedByItsFirstBytesUnderAForeignName) {
  writeText(folder / "a.txt", R"({"steradian": 1, "name": "a"})");
  EXPECT_EQ(stockPlugins().importScene(folder / "a.txt").scene.name, "a");
}

TEST_F(ProjectFile, ACancelledSaveLeavesTheOldFile) {
  writeText(folder / "a.srad", "old");
  Scene scene;
  scene.objects = {{.id = Id{1}}};
  scene.nextId = Id{2};
  const Progress cancel{.cancelled = [] { return true; }};
  const auto [message, code] = faultOf([&] { stockPlugins().exportScene(scene, folder / "a.srad", cancel); });
  EXPECT_EQ(code, ExitCode::failed);
  EXPECT_CONTAINS(message, "cancelled");
  EXPECT_EQ(readText(folder / "a.srad"), "old");
}

TEST_F(ProjectFile, TheReadmesExampleOpens) {
  const std::string readme = readText(fs::path(PROJECT_FORMAT_README));
  const auto begin = readme.find("```json\n") + 8;
  writeText(folder / "a.srad", readme.substr(begin, readme.find("```", begin) - begin));
  EXPECT_EQ(stockPlugins().importScene(folder / "a.srad").scene.objects.size(), 4u);
}

}  // namespace
}  // namespace steradian::plugins
