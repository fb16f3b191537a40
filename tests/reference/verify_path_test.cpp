// SPDX-License-Identifier: MIT
// Paths of the device judged by the same functions in double: nothing is found where nothing is wrong, and
// what is wrong is named by its stage.
#include <cmath>
#include <set>

#include "renderer/reference/judge.hpp"
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian::reference {
namespace {

constexpr Extent film{12, 8};
constexpr PixelRect everyPixel{0, 0, 12, 8};
// Rows of a record (shaders/path_record.glsl): the header's two, then the first vertex, whose first slot of a
// light chose a light, found a direction and an illuminance, and sent light along the path.
constexpr std::size_t hitRow = 2 + 6, normalRow = 2 + 8, metRow = 2 + 10, slotRow = 2 + 14;
constexpr std::size_t choiceRow = slotRow, illuminanceRow = slotRow + 2, bsdfRow = slotRow + 3,
                      reflectedRow = slotRow + 4, nextSlot = 5;

class VerifiedPaths : public RendererTest {
 protected:
  void SetUp() override {
    RendererTest::SetUp();
    scene_ = scenes::room(4);
    traced_ = tracedScene(packScene(scene_, scenes::roomView(), film), *device_);
  }
  std::vector<PathRecord> record(std::uint64_t end) {
    return recordPaths(*device_, traced_, everyPixel, 0, end);
  }

  // A path of the room, in which a test may plant a fault; recorded once.
  PathRecord onePath() {
    static const PathRecord path = record(1)[40];
    return path;
  }

  // Stages of all that parts on one path.
  std::set<std::string> partingStages(const PathRecord& path) {
    std::set<std::string> stages;
    for (const Finding& f : Judge(traced_).compare(path))
      if (f.parts()) stages.insert(infoOf(f.quantity).stage);
    return stages;
  }

  void expectThoseOf(const std::vector<PathRecord>& paths, const Image& picture) {
    for (const PathRecord& path : paths)
      for (int c = 0; c < 3; ++c) {
        const float value = picture.at(path.x, path.y)[c];
        EXPECT_NEAR(path.rows[1][c], value, 1e-5f * std::fabs(value) + 1e-7f);
      }
  }

  // How many quantities were compared; none may part.
  std::size_t expectNoneParts(const std::vector<PathRecord>& paths) {
    Judge judge(traced_);
    std::size_t compared = 0;
    for (const PathRecord& path : paths)
      for (const Finding& f : judge.compare(path)) {
        EXPECT_FALSE(f.parts()) << infoOf(f.quantity).stage << " " << infoOf(f.quantity).name << " pixel "
                                << path.x << "," << path.y << " vertex " << f.vertex << ": " << f.device
                                << " / " << f.reference;
        compared += 1;
      }
    return compared;
  }

  Scene scene_;
  TracedScene traced_;
};

TEST_F(VerifiedPaths, recorded_paths_are_those_of_the_film) {
  const Image picture = render(scene_, scenes::roomView(), film, 1);
  expectThoseOf(record(1), picture);
}

TEST_F(VerifiedPaths, float_and_double_agree_at_every_stage) {
  const std::vector<PathRecord> paths = record(4);
  EXPECT_GT(expectNoneParts(paths), 5000u);
  Judge judge(traced_);
  std::size_t otherWay = 0;
  for (const PathRecord& path : paths) otherWay += judge.run(path).partedAt ? 1 : 0;
  EXPECT_LE(otherWay, 4u);
}

// Smooth normals, tangents, textures of all kinds, colours and veils.
Scene meshScene() {
  Scene scene = scenes::plainScene(4);
  Mesh ball = textures::smoothBall(2);
  for (const glm::vec3& p : ball.positions) {
    ball.uv0.emplace_back(2.0f * p.x, 2.0f * p.y);
    ball.colors.emplace_back(0.9f, 0.8f + 0.1f * p.z, 1.0f, 0.9f);
  }
  Material m = scenes::plastic(0.6f, glm::vec3(0.9f));
  const auto waves = textures::made(8, 8, textures::Format::rgba8, [](int x, int y) {
    return glm::vec4(0.4f + 0.05f * float((x + y) % 3), 0.5f + 0.05f * float(y % 3), 0.9f,
                     0.7f + 0.03f * float(x));
  });
  m.albedoTexture = m.normalTexture = m.metallicRoughnessTexture = textures::slot(waves, false);
  m.alphaMode = AlphaMode::blend;
  scenes::add(scene, scenes::at({-0.8, 1, -1}, {1, 1, 0}, 0.7), textures::shape(ball), m);
  scenes::add(scene, scenes::at({1.0, 1, -0.5}, {1, 0, 1}, 0.4, {0.7, -1, 0.9}),
              textures::shape(textures::smoothBall(3)), scenes::metal(0.3f, {0.9f, 0.8f, 0.6f}));
  scenes::add(scene, scenes::at({0, 0, 0}), Plane{}, scenes::lambert(glm::vec3(0.5f)));
  scenes::addLight(scene, scenes::at({0, 0, 0}), EnvironmentLight{}, 1.0f);
  scenes::addLight(scene, scenes::at({1.5, 3.4, 2}), PointLight{}, 3.0f);
  return scene;
}

TEST_F(VerifiedPaths, float_and_double_agree_on_textured_meshes) {
  scene_ = meshScene();
  traced_ = tracedScene(packScene(scene_, scenes::roomView(), film), *device_);
  const Image picture = render(scene_, scenes::roomView(), film, 1);
  const std::vector<PathRecord> paths = record(1);
  expectThoseOf(paths, picture);
  EXPECT_GT(expectNoneParts(paths), 1000u);
}

TEST_F(VerifiedPaths, float_and_double_agree_on_shapes_and_meshes_in_one_hierarchy) {
  for (int i = 0; i < 50; ++i)
    scenes::add(scene_, scenes::at({0.1 * i - 2.5, 0.3 + 0.02 * (i * 37 % 50), 0.02 * (i * 23 % 50)}),
                i % 2 ? Shape(Sphere{0.12}) : Shape(Box{glm::dvec3(0.2)}),
                scenes::plastic(0.4f, glm::vec3(0.6f)));
  scenes::add(scene_, scenes::at({0, 2, 0}), textures::shape(textures::smoothBall(2)),
              scenes::lambert(glm::vec3(0.5f)));
  traced_ = tracedScene(packScene(scene_, scenes::roomView(), film), *device_);
  ASSERT_TRUE(traced_.scene.shapeHierarchy());
  EXPECT_GT(expectNoneParts(record(2)), 1000u);
}

// Lights that whole pipelines are specialized for: a mesh and a box that glow.
TEST_F(VerifiedPaths, float_and_double_agree_where_meshes_and_solids_glow) {
  scenes::add(scene_, scenes::at({-1.5, 2.5, 0.5}, {1, 1, 0}, 0.7, glm::dvec3(0.4)),
              textures::shape(meshes::icosphere(1)), scenes::emitter(4.0f, glm::vec3(0.2f)));
  scenes::add(scene_, scenes::at({1.5, 2.5, 0.5}, {1, 1, 0}, 0.7), Box{glm::dvec3(0.5)},
              scenes::emitter(4.0f, glm::vec3(0.2f)));
  traced_ = tracedScene(packScene(scene_, scenes::roomView(), film), *device_);
  const Image picture = render(scene_, scenes::roomView(), film, 1);
  const std::vector<PathRecord> paths = record(1);
  expectThoseOf(paths, picture);
  EXPECT_GT(expectNoneParts(paths), 1000u);
}

TEST_F(VerifiedPaths, a_wrong_distance_is_named_intersection) {
  PathRecord path = onePath();
  path.rows[hitRow].x *= 1.01f;
  EXPECT_TRUE(partingStages(path).count("intersection"));
}

TEST_F(VerifiedPaths, another_primitive_is_named_intersection) {
  PathRecord path = onePath();
  path.rows[hitRow].y = path.rows[hitRow].y == 0.0f ? 1.0f : 0.0f;
  EXPECT_TRUE(partingStages(path).count("intersection"));
}

TEST_F(VerifiedPaths, a_tilted_normal_is_named_normal) {
  PathRecord path = onePath();
  path.rows[normalRow] += glm::vec4(0.01f, 0.01f, 0.01f, 0.0f);
  EXPECT_TRUE(partingStages(path).count("normal"));
}

TEST_F(VerifiedPaths, a_wrong_reflectance_is_named_bsdf_alone) {
  PathRecord path = onePath();
  ASSERT_GT(path.rows[bsdfRow].x, 0.0f);
  path.rows[bsdfRow].x *= 1.01f;
  EXPECT_EQ(partingStages(path), std::set<std::string>{"BSDF"});
}

TEST_F(VerifiedPaths, a_wrong_light_is_named_light_alone) {
  const PathRecord right = onePath();
  // What the device would have recorded with a fault of one kind: the value must be there to be wrong.
  const auto stagesWith = [&](std::size_t row, int component, auto wrong) {
    PathRecord path = right;
    path.rows[row][component] = wrong(path.rows[row][component]);
    EXPECT_NE(path.rows[row][component], right.rows[row][component]) << "nothing was planted";
    return partingStages(path);
  };
  const auto larger = [](float x) { return 1.01f * x; };
  const std::set<std::string> light{"light"};
  EXPECT_EQ(stagesWith(illuminanceRow, 0, larger), light);
  EXPECT_EQ(stagesWith(illuminanceRow + nextSlot, 3, larger), light) << "density of an area light";
  EXPECT_EQ(stagesWith(metRow, 0, [](float) { return 0.01f; }), light) << "nothing shines there";
  PathRecord shadowed = right;
  ASSERT_GT(shadowed.rows[reflectedRow].x, 0.0f);
  shadowed.rows[reflectedRow] = glm::vec4(0.0f, 0.0f, 0.0f, shadowed.rows[reflectedRow].w);
  EXPECT_EQ(partingStages(shadowed), light) << "a shadow ray that met something";
}

// Forty lamps of which eight are tried: the choice itself can be wrong.
TEST_F(VerifiedPaths, another_light_is_named_light) {
  for (int i = 0; i < 40; ++i)
    scenes::addLight(scene_, scenes::at({0.1 * i - 2.0, 3.0, 0.05 * i - 1.0}), PointLight{}, 1.0f);
  traced_ = tracedScene(packScene(scene_, scenes::roomView(), film), *device_);
  PathRecord path = record(1)[40];
  EXPECT_TRUE(partingStages(path).empty());
  path.rows[choiceRow].y = path.rows[choiceRow].y == 0.0f ? 1.0f : 0.0f;
  EXPECT_TRUE(partingStages(path).count("light"));
}

}  // namespace
}  // namespace steradian::reference
