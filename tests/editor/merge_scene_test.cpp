// SPDX-License-Identifier: MIT
// Another scene taken into the open one: nothing of it is lost, nothing of the open one changes.
#include <gtest/gtest.h>

#include <set>

#include "editor/bounds.hpp"
#include "editor/document.hpp"
#include "editor/edits.hpp"
#include "editor/first_view.hpp"
#include "tests/editor/sound.hpp"

using namespace steradian;
namespace e = steradian::edits;

namespace {

/// Ball (1, material 5) with a lamp (2) inside, a camera (3) and an animated lamp.
Scene model() {
  Scene scene{.name = "model"};
  const auto mesh = sharedMesh({.positions = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}}, .triangles = {{0, 1, 2}}});
  scene.materials = {{.id = Id{5}, .name = "Clay"}, {.id = Id{6}}};
  scene.objects = {{.id = Id{1}, .name = "Ball", .content = Geometry{MeshShape{mesh}, Id{5}}},
                   {.id = Id{2}, .name = "Lamp", .parent = Id{1}, .content = Light{}},
                   {.id = Id{3}, .name = "", .content = Camera{}}};
  scene.objects[0].transform.translation = {10, 0, 0};
  scene.animation.channels = {{Id{2}, Property::lightIntensity, Interpolation::linear, {{0, {1, 0, 0, 0}}}}};
  scene.animation.framesPerSecond = 60;
  scene.activeCamera = Id{3};
  scene.render.width = 77;
  scene.nextId = Id{7};
  return scene;
}

}  // namespace

TEST(Merge, adds_everything_under_one_group_with_new_ids_and_free_names) {
  const Scene open = model();
  const Scene imported = model();
  const e::Merged merged = e::merge(open, imported, "chair");
  expectSound(merged.scene);
  ASSERT_EQ(merged.scene.objects.size(), 7u);
  const Object& group = *find(merged.scene, merged.group);
  EXPECT_EQ(group.name, "chair");
  EXPECT_EQ(group.parent, Id::none);
  const Object &ball = merged.scene.objects[4], &lamp = merged.scene.objects[5],
               &camera = merged.scene.objects[6];
  EXPECT_EQ(ball.name, "Ball.001");
  EXPECT_EQ(ball.parent, merged.group);
  EXPECT_EQ(lamp.parent, ball.id);
  EXPECT_EQ(camera.name, "Camera");
  EXPECT_EQ(merged.objects, (std::set<Id>{ball.id, lamp.id, camera.id}));
  EXPECT_EQ(std::get<Geometry>(ball.content).material, merged.scene.materials[2].id);
  EXPECT_EQ(std::get<Geometry>(ball.content).shape, std::get<Geometry>(imported.objects[0].content).shape)
      << "the mesh is shared, not copied";
}

TEST(Merge, leaves_the_open_scene_as_it_was) {
  const Scene open = model();
  const e::Merged merged = e::merge(open, model(), "chair");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(merged.scene.objects[i], open.objects[i]);
  EXPECT_EQ(merged.scene.materials[0], open.materials[0]);
  EXPECT_EQ(merged.scene.materials[2].name, "Clay.001");
  EXPECT_EQ(merged.scene.render, open.render);
  EXPECT_EQ(merged.scene.display, open.display);
  EXPECT_EQ(merged.scene.activeCamera, open.activeCamera);
  EXPECT_EQ(merged.scene.animation.framesPerSecond, open.animation.framesPerSecond);
  ASSERT_EQ(merged.scene.animation.channels.size(), 2u);
  EXPECT_EQ(merged.scene.animation.channels[1].target, merged.scene.objects[5].id);
  EXPECT_EQ(merged.scene.name, open.name);
}

TEST(Merge, again_and_again_and_into_nothing_stays_sound) {
  Scene scene;
  for (int i = 0; i < 5; ++i) scene = e::merge(std::move(scene), model(), "chair").scene;
  expectSound(scene);
  std::set<std::string> names;
  for (const Object& object : scene.objects) names.insert(object.name);
  EXPECT_EQ(names.size(), 20u);
  const e::Merged same = e::merge(scene, Scene{}, "");
  expectSound(same.scene);
  EXPECT_TRUE(same.objects.empty());
}

TEST(Merge, is_one_step_that_undo_takes_back) {
  const Scene before = model();
  Document document(before);
  document.apply(e::merge(document.committed(), model(), "chair").scene, "Import chair");
  EXPECT_EQ(document.scene().objects.size(), 7u);
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.scene(), before);
}

TEST(Bounds, of_a_mesh_are_those_of_its_vertices) {
  const auto bounds = boundsOf(model());
  ASSERT_TRUE(bounds);
  EXPECT_EQ(bounds->min, glm::dvec3(0, 0, 0)) << "the camera";
  EXPECT_EQ(bounds->max, glm::dvec3(12, 4, 0));
  const std::set<Id> ball{Id{1}};
  EXPECT_EQ(boundsOf(model(), &ball)->min, glm::dvec3(10, 0, 0));
}

TEST(FirstView, adds_only_what_is_missing) {
  EXPECT_EQ(withFirstView(model()).added, "");
  EXPECT_EQ(withFirstView(model()).scene.objects.size(), 3u);
  Scene bare = model();
  bare.objects.resize(1);
  bare.animation.channels.clear();
  bare.activeCamera = Id::none;
  EXPECT_EQ(withFirstView(bare).added, "a camera that sees everything and a soft sky");
  bare.materials[0].emissionLuminance = 1;
  EXPECT_EQ(withFirstView(bare).added, "a camera that sees everything");
}

TEST(FirstView, sees_every_corner_in_any_format) {
  for (const glm::ivec2 size : {glm::ivec2(640, 480), glm::ivec2(64, 999), glm::ivec2(999, 64)}) {
    Scene scene = model();
    scene.objects.resize(1);
    scene.animation.channels.clear();
    scene.activeCamera = Id::none;
    scene.render.width = size.x, scene.render.height = size.y;
    scene = withFirstView(std::move(scene)).scene;
    expectSound(scene);
    const CameraView view = cameraView(scene);
    const double tangent = std::tan(0.5 * view.fovY);
    for (const glm::dvec3 corner : {glm::dvec3(10, 0, 0), glm::dvec3(12, 0, 0), glm::dvec3(10, 4, 0)}) {
      const glm::dvec4 seen = glm::inverse(view.worldFromCamera) * glm::dvec4(corner, 1.0);
      EXPECT_LT(seen.z, 0);
      EXPECT_LT(std::abs(seen.y), -seen.z * tangent);
      EXPECT_LT(std::abs(seen.x), -seen.z * tangent * size.x / size.y);
    }
  }
}
