// SPDX-License-Identifier: MIT
// What is heavy about a scene is made once, ahead when it is asked for, whoever asks; and what a device
// cannot hold is refused by name.
#include <gtest/gtest.h>

#include <thread>

#include "renderer/scene_cache.hpp"
#include "renderer/scene_size.hpp"
#include "tests/renderer/textures.hpp"

namespace steradian {
namespace {

std::shared_ptr<const Texture> grey(int size, const std::string& name) {
  Texture texture =
      *textures::made(size, size, textures::Format::rgba8, [](int, int) { return glm::vec4(0.5f); });
  texture.name = name;
  return std::make_shared<const Texture>(std::move(texture));
}

/// Two balls that share a mesh, a floor, two images, a sky.
Scene furnished() {
  const auto ball = sharedMesh(meshes::icosphere(3));
  Scene scene;
  const auto add = [&](const char* name, auto content) {
    scene.objects.push_back({.id = Id{unsigned(scene.objects.size() + 1)}, .name = name, .content = content});
  };
  add("ball", Geometry{MeshShape{ball}, Id{1}});
  add("floor", Geometry{MeshShape{sharedMesh(meshes::quad(2.0f))}, Id{2}});
  add("other ball", Geometry{MeshShape{ball}, Id{1}});
  auto sky = std::make_shared<const Image>(Image{8, 4, 3, std::vector<float>(96, 1.0f)});
  add("sky", Light{.kind = EnvironmentLight{.image = sky}, .intensity = 1.0f});
  scene.materials.push_back({.id = Id{1}, .name = "a", .albedoTexture = textures::slot(grey(16, "bricks"))});
  scene.materials.push_back({.id = Id{2}, .name = "b", .normalTexture = textures::slot(grey(4, "bumps"))});
  return scene;
}

const std::shared_ptr<const Mesh>& meshOf(const Object& object) {
  return std::get<MeshShape>(std::get<Geometry>(object.content).shape).mesh;
}
const std::shared_ptr<const Image>& skyOf(const Object& object) {
  return std::get<EnvironmentLight>(std::get<Light>(object.content).kind).image;
}
bool goOn(double) {
  return true;
}

TEST(SceneCache, what_was_prepared_is_not_made_again_when_the_scene_is_shown) {
  const Scene scene = furnished();
  SceneCache cache;
  std::vector<double> told;
  cache.prepare(scene, [&](double share) {
    told.push_back(share);
    return true;
  });
  ASSERT_EQ(told.size(), 5u) << "two meshes, two textures, a sky";
  EXPECT_EQ(told.front(), 0.0);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()) && told.back() < 1.0);
  const auto ball = cache.meshes.of(meshOf(scene.objects[0]));
  const GpuScene shown = packScene(scene, {}, {8, 8}, cache);
  ASSERT_EQ(shown.meshes.size(), 2u);
  EXPECT_EQ(shown.meshes[0], ball);
  EXPECT_EQ(cache.skyOf(skyOf(scene.objects[3])), cache.skyOf(skyOf(scene.objects[3])));
}

TEST(SceneCache, a_moved_object_rebuilds_no_mesh) {
  Scene scene = furnished();
  SceneCache cache;
  const GpuScene before = packScene(scene, {}, {8, 8}, cache);
  scene.objects[0].transform.translation.x += 3.0;
  const GpuScene after = packScene(scene, {}, {8, 8}, cache);
  EXPECT_FALSE(after.sameRadiance(before));
  EXPECT_EQ(after.meshes, before.meshes);
  EXPECT_EQ(after.vertices, before.vertices);
  EXPECT_EQ(after.textures, before.textures);
}

TEST(SceneCache, a_cancelled_preparation_stops_before_the_next_thing) {
  const Scene scene = furnished();
  SceneCache cache;
  int asked = 0;
  cache.prepare(scene, [&](double) { return ++asked < 2; });
  EXPECT_EQ(asked, 2);
  EXPECT_GT(cache.meshes.bytesOf(*meshOf(scene.objects[0])), 0u);
  EXPECT_EQ(cache.meshes.bytesOf(*meshOf(scene.objects[1])), 0u) << "not built yet";
}

TEST(SceneCache, a_worker_may_prepare_while_another_scene_is_shown) {
  const Scene shown = furnished(), next = furnished();
  SceneCache cache;
  std::jthread worker([&] { cache.prepare(next, goOn); });
  for (int i = 0; i < 50; ++i) packScene(shown, {}, {8, 8}, cache);
  worker.join();
  const auto mesh = cache.meshes.of(meshOf(next.objects[0]));
  EXPECT_EQ(packScene(next, {}, {8, 8}, cache).meshes[0], mesh);
}

TEST(SceneCache, what_nobody_holds_any_more_is_forgotten_with_the_next_scene) {
  SceneCache cache;
  std::weak_ptr<const MeshBvh> built;
  {
    const Scene scene = furnished();
    cache.prepare(scene, goOn);
    built = cache.meshes.of(meshOf(scene.objects[0]));
  }
  packScene(Scene{}, {}, {8, 8}, cache);
  EXPECT_TRUE(built.expired());
}

TEST(SceneCache, memory_is_told_as_it_lies_on_the_device) {
  const Scene scene = furnished();
  SceneCache cache;
  cache.prepare(scene, goOn);
  const Mesh& ball = *meshOf(scene.objects[0]);
  const auto bvh = cache.meshes.of(meshOf(scene.objects[0]));
  EXPECT_EQ(cache.meshes.bytesOf(ball), 16 * (bvh->nodes.size() + 3 * ball.triangles.size()));
  const Texture& bricks = *scene.materials[0].albedoTexture.texture;
  EXPECT_EQ(cache.textures.bytesOf(bricks), 4u * (5 + 256 + 64 + 16 + 4 + 1)) << "with its levels";
}

TEST(SceneSize, fault17_what_fits_is_not_refused) {
  const Scene scene = furnished();
  EXPECT_EQ(tooLarge(scene, packScene(scene, {}, {8, 8}), 1u << 20), "");
}

TEST(SceneSize, fault17_meshes_that_are_too_large_are_refused_with_need_limit_and_the_largest_of_them) {
  const Scene scene = furnished();
  const GpuScene packed = packScene(scene, {}, {8, 8});
  const std::size_t rows = packed.meshes[0]->nodes.size() + packed.meshes[0]->triangles.size() +
                           packed.meshes[1]->nodes.size() + packed.meshes[1]->triangles.size();
  EXPECT_EQ(tooLarge(scene, packed, rows - 1),
            "the geometry of the scene's meshes needs 1 MiB, the device allows 0 MiB in one buffer; the "
            "largest is 'ball' with 1280 triangles. Leave out or simplify meshes.");
  EXPECT_EQ(tooLarge(scene, packed, rows), "");
}

TEST(SceneSize, fault17_a_texture_set_that_is_too_large_is_refused_with_its_largest) {
  Scene scene = furnished();
  scene.objects.resize(1);
  scene.objects[0].content = Geometry{Sphere{}, Id{1}};
  GpuScene packed = packScene(scene, {}, {8, 8});
  ASSERT_FALSE(packed.textures.empty());
  packed.textures.resize(3'000'000, packed.textures[0]);  // the same in place of many
  const std::string line = tooLarge(scene, packed, 134'217'728);
  EXPECT_NE(line.find("textures needs 3"), std::string::npos) << line;
  EXPECT_NE(line.find("MiB, the device allows 512 MiB in one buffer; the largest is 'bricks' with 16 x 16"),
            std::string::npos)
      << line;
}

TEST(SceneSize, fault17_a_sky_that_is_too_large_is_refused_with_its_size) {
  Scene scene = furnished();
  scene.objects.erase(scene.objects.begin(), scene.objects.begin() + 3);
  scene.materials.clear();
  const std::string line = tooLarge(scene, packScene(scene, {}, {8, 8}), 20);
  EXPECT_NE(line.find("sky image"), std::string::npos) << line;
  EXPECT_NE(line.find("8 x 4"), std::string::npos) << line;
}

}  // namespace
}  // namespace steradian
