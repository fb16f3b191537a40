// SPDX-License-Identifier: MIT
// Look-ups, the hierarchy and the camera.
#include "renderer/scene/scene.hpp"

#include <gtest/gtest.h>

#include <ctime>

#include "renderer/scene/error.hpp"
#include "renderer/scene/validate.hpp"

using namespace steradian;

namespace {

Object object(unsigned id, unsigned parent, const glm::dvec3& translation = {}) {
  Object o;
  o.id = Id(id);
  o.name = std::string("o") + std::to_string(id);
  o.parent = Id(parent);
  o.transform.translation = translation;
  return o;
}

Scene sceneOf(std::vector<Object> objects) {
  Scene scene;
  scene.nextId = Id(unsigned(objects.size()) + 1);
  scene.objects = std::move(objects);
  return scene;
}

Scene chain(unsigned length) {
  std::vector<Object> objects;
  for (unsigned i = length; i >= 1; --i) objects.push_back(object(i, i - 1, {1, 0, 0}));  // children first
  return sceneOf(std::move(objects));
}

}  // namespace

TEST(Scene, finds_by_id_and_name_and_says_nothing_for_what_is_absent) {
  const Scene scene = chain(3);
  EXPECT_EQ(find(scene, Id(2))->name, "o2");
  EXPECT_EQ(findByName(scene, "o3")->id, Id(3));
  EXPECT_EQ(find(scene, Id(9)), nullptr);
  EXPECT_EQ(find(scene, Id::none), nullptr);
  EXPECT_EQ(findByName(scene, ""), nullptr);
  EXPECT_EQ(findMaterial(scene, Id(1)), nullptr);
}

TEST(Scene, world_placement_multiplies_down_the_parents) {
  Scene scene = sceneOf({object(1, 2, {0, 0, -1}), object(2, 0, {5, 0, 0})});
  scene.objects[1].transform.scale = {2, 2, 2};
  EXPECT_EQ(worldFromObject(scene, Id(1))[3], glm::dvec4(5, 0, -2, 1));
  EXPECT_EQ(worldTransforms(scene)[0], worldFromObject(scene, Id(1)));
  EXPECT_EQ(worldTransforms(scene)[1], worldFromObject(scene, Id(2)));
}

TEST(Scene, cyclic_and_broken_parents_end_the_walk) {
  const Scene scene = sceneOf({object(1, 2, {1, 0, 0}), object(2, 1, {1, 0, 0}), object(3, 3, {1, 0, 0}),
                               object(4, 99, {1, 0, 0}), object(5, 1, {1, 0, 0})});
  EXPECT_EQ(worldFromObject(scene, Id(1))[3].x, 2.0);
  EXPECT_EQ(worldFromObject(scene, Id(3))[3].x, 1.0);
  EXPECT_EQ(worldFromObject(scene, Id(4))[3].x, 1.0);
  EXPECT_EQ(worldTransforms(scene).size(), 5u);
  EXPECT_TRUE(visibleInHierarchy(scene, Id(1)));
}

TEST(Scene, a_chain_of_100000_parents_takes_linear_time) {
  const Scene scene = chain(100000);
  const std::clock_t start = std::clock();  // of this process: other load must not matter
  EXPECT_EQ(worldFromObject(scene, Id(100000))[3].x, 100000.0);
  EXPECT_EQ(worldTransforms(scene).front()[3].x, 100000.0);
  EXPECT_TRUE(hierarchyVisibility(scene).front());
  EXPECT_TRUE(problemsOf(scene).empty());
  // Linear takes some 50 ms, quadratic more than a minute.
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 10.0);
}

TEST(Scene, hiding_an_object_hides_what_is_inside_it) {
  Scene scene = chain(12);
  scene.objects.back().visible = false;  // the root
  EXPECT_FALSE(visibleInHierarchy(scene, Id(12)));
  EXPECT_FALSE(hierarchyVisibility(scene).front());
  scene.objects.back().visible = true;
  EXPECT_TRUE(visibleInHierarchy(scene, Id(12)));
  EXPECT_FALSE(visibleInHierarchy(scene, Id(13)));
}

TEST(CameraView, is_rigid_below_scaled_parents) {
  Scene scene = sceneOf({object(1, 0), object(2, 1, {0, 1, 0})});
  scene.objects[0].transform.scale = {-3, 2, 5};
  scene.objects[1].content = Camera{1.0};
  scene.objects[1].transform.rotation = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 3)));
  const CameraView view = cameraView(scene);
  const glm::dmat3 r(view.worldFromCamera);
  EXPECT_NEAR(glm::determinant(r), 1.0, 1e-14);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(glm::length(r[i]), 1.0, 1e-14);
  EXPECT_EQ(view.worldFromCamera[3], glm::dvec4(0, 2, 0, 1));
  EXPECT_EQ(view.fovY, 1.0);
}

TEST(CameraView, prefers_the_name_then_the_active_camera_then_the_first) {
  Scene scene = sceneOf({object(1, 0), object(2, 0), object(3, 0)});
  for (int i = 0; i < 3; ++i) scene.objects[i].content = Camera{0.1 * (i + 1)};
  EXPECT_EQ(cameraView(scene).fovY, 0.1);
  scene.activeCamera = Id(2);
  EXPECT_EQ(cameraView(scene).fovY, 0.2);
  EXPECT_EQ(cameraView(scene, "o3").fovY, scene.objects.size() * 0.1);
}

TEST(CameraView, of_an_unknown_name_is_an_error_that_lists_the_cameras) {
  Scene scene = sceneOf({object(1, 0), object(2, 0)});
  scene.objects[1].content = Camera{};
  try {
    cameraView(scene, "o1");  // exists, but is no camera
    FAIL() << "expected an Error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::badInput);
    EXPECT_STREQ(error.what(), "no camera is called 'o1'; there is 'o2'");
  }
}

TEST(CameraView, exists_also_for_a_scene_without_cameras) {
  EXPECT_EQ(cameraView(Scene{}).fovY, Camera{}.fovY);
}
