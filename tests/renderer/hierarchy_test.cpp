// SPDX-License-Identifier: MIT
// A scene whose shapes lie in the hierarchy looks, bit for bit, as with flat lists.
#include <algorithm>
#include <iostream>
#include <random>

#include "tests/renderer/meshes.hpp"
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

constexpr Extent film{48, 32};

/// A closed room full of shapes of all kinds: matt, mirrors and glass, some of them lamps.
Scene fullRoom() {
  Scene scene = plainScene(6);
  scene.render.lightSamples = 2;
  add(scene, at({0, 2, 0}), Box{{8, 6, 12}}, plastic(0.6f, glm::vec3(0.75f)));
  Material glass = plastic(0.0f, glm::vec3(1.0f));
  glass.transmission = 1.0f;
  const Id materials[] = {add(scene, lambert({0.7f, 0.4f, 0.3f})), add(scene, metal(0.2f)), add(scene, glass),
                          add(scene, plastic(0.3f, {0.2f, 0.5f, 0.8f}))};
  std::mt19937 random(4);
  const auto uniform = [&](double low, double high) { return low + (high - low) * random() * 0x1p-32; };
  for (int i = 0; i < 60; ++i) {
    const double size = uniform(0.1, 0.4);
    const Shape kinds[] = {Sphere{size}, Box{dvec3(size)}, Rect{{size, 2 * size}}, Disk{size},
                           Cylinder{0.5 * size, size}};
    const dvec3 scale = i % 6 == 5 ? dvec3(1, 0.4, 1.3) : dvec3(1);
    add(scene,
        at({uniform(-3, 3), uniform(-0.5, 4), uniform(-3, 2)}, {uniform(0.1, 1), uniform(-1, 1), 0.3},
           uniform(0, 6), scale),
        kinds[i % 5], materials[random() % 4]);
  }
  for (int i = 0; i < 3; ++i) addLight(scene, at({2.0 * i - 2, 4.2, 1}), SphereLight{0.2}, 3.0f);
  addLight(scene, {{0, 4.5, 0}, facing({0, -1, 0}), dvec3(1.0)}, RectLight{{2, 1}}, 3.0f);
  return scene;
}

Scene roomWithMeshes() {
  Scene scene = fullRoom();
  const MeshShape ball{sharedMesh(meshes::icosphere(2))};
  const Id matt = add(scene, lambert({0.3f, 0.7f, 0.4f}));
  for (int i = 0; i < 4; ++i)
    add(scene, at({1.3 * i - 2, 0.3, 1.2}, {0, 1, 0}, 0.3 * i, dvec3(0.4)), ball, matt);
  return scene;
}

class HierarchyTest : public RendererTest {
 protected:
  void TearDown() override {
    renderer().setShapeSearch(ShapeSearch::automatic);
    RendererTest::TearDown();
  }
  static CameraView view() { return lookAt({0, 2, 5}, {0, 1.5, 0}, 0.9); }

  static bool usesHierarchy(const RenderStats& stats) {
    const auto& features = stats.variant.features;
    return std::find(features.begin(), features.end(), "shape hierarchy") != features.end();
  }
  void expectSame(const Image& found, const Image& expected) {
    if (onCpu()) {
      EXPECT_TRUE(found == expected) << "MRSE " << mrse(found, expected);
    } else {
      EXPECT_LE(mrse(found, expected), 1e-6);
    }
  }
};

TEST_F(HierarchyTest, the_picture_is_that_of_flat_lists) {
  for (const bool special : {false, true}) {
    SCOPED_TRACE(special ? "special pipelines, meshes among the shapes" : "generic pipelines");
    const Scene scene = special ? roomWithMeshes() : fullRoom();
    renderer().allowSpecialization(special);
    Image pictures[2];
    for (const bool tree : {false, true}) {
      renderer().setShapeSearch(tree ? ShapeSearch::hierarchy : ShapeSearch::list);
      renderer().setScene(scene, view(), film);
      renderer().waitForSpecialization();
      pictures[tree] = render(scene, view(), film, 8);
      EXPECT_EQ(usesHierarchy(renderer().stats()), tree);
      EXPECT_EQ(renderer().stats().variant.specialized, special);
    }
    EXPECT_GT(meanOf(pictures[0]).value, 0.01);
    expectSame(pictures[1], pictures[0]);
  }
}

TEST_F(HierarchyTest, picking_and_the_layers_find_what_lies_in_flat_lists) {
  const Scene scene = roomWithMeshes();
  std::vector<Id> picked[2];
  std::vector<AovLayer> layers[2];
  for (const bool tree : {false, true}) {
    renderer().setShapeSearch(tree ? ShapeSearch::hierarchy : ShapeSearch::list);
    renderer().setScene(scene, view(), film);
    for (int y = 1; y < film.height; y += 6)
      for (int x = 1; x < film.width; x += 6) {
        const auto found = renderer().pick(x, y);
        picked[tree].push_back(found ? found->object : Id::none);
      }
    layers[tree] = renderer().aovs({{Aov::id, Aov::depth}, 2});
  }
  EXPECT_EQ(picked[0], picked[1]);
  for (std::size_t i = 0; i < layers[0].size(); ++i) expectSame(layers[1][i].pixels, layers[0][i].pixels);
}

TEST_F(HierarchyTest, a_thousand_spheres_take_a_fraction_of_the_time_of_flat_lists) {
  Scene scene = plainScene(3);
  const Id matt = add(scene, lambert(glm::vec3(0.5f)));
  std::mt19937 random(6);
  const auto uniform = [&] { return 6.0 * random() * 0x1p-32 - 3.0; };
  for (int i = 0; i < 1000; ++i) add(scene, at({uniform(), uniform(), uniform() - 4.0}), Sphere{0.15}, matt);
  addLight(scene, at({3, 5, 5}), PointLight{}, 30.0f);
  double milliseconds[2];
  Image pictures[2];
  for (const bool tree : {false, true}) {
    renderer().setShapeSearch(tree ? ShapeSearch::hierarchy : ShapeSearch::list);
    render(scene, lookAt({0, 0, 4}, {0, 0, 0}, 0.9), film, 1);  // compiles
    pictures[tree] = render(scene, lookAt({0, 0, 4}, {0, 0, 0}, 0.9), film, 5, 1);
    milliseconds[tree] = renderer().stats().msPerSample;
  }
  expectSame(pictures[1], pictures[0]);
  std::cout << "1,000 spheres, " << film.width << "x" << film.height << ": " << milliseconds[0]
            << " ms per sample with flat lists, " << milliseconds[1] << " ms with the hierarchy\n";
}

TEST_F(HierarchyTest, a_scene_that_flat_lists_could_not_trace_is_traced) {
  if (!onCpu()) GTEST_SKIP() << "GPUs have no such loop budget";
  Scene scene = plainScene(8);
  const Id matt = add(scene, lambert(glm::vec3(0.5f)));
  for (int i = 0; i < 20000; ++i)
    add(scene, at({0.1 * (i % 27), 0.1 * (i / 27 % 27), -0.1 * (i / 729)}), Sphere{0.04}, matt);
  addLight(scene, at({3, 5, 5}), PointLight{}, 30.0f);
  const CameraView front = lookAt({1.3, 1.3, 4}, {1.3, 1.3, 0}, 0.9);
  renderer().setShapeSearch(ShapeSearch::list);
  EXPECT_THROW(renderer().setScene(scene, front, film), Error);
  renderer().setShapeSearch(ShapeSearch::automatic);
  EXPECT_GT(meanOf(render(scene, front, film, 2)).value, 0.01);  // and no sample was cut
}

}  // namespace
}  // namespace steradian
