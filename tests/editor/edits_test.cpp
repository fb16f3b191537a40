// SPDX-License-Identifier: MIT
// Each editing operation does what its name says and leaves a sound scene.
#include "editor/edits.hpp"

#include <gtest/gtest.h>

#include "tests/editor/sound.hpp"

using namespace steradian;
namespace e = steradian::edits;

namespace {

void expectSamePlace(const glm::dmat4& a, const glm::dmat4& b) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) EXPECT_NEAR(a[column][row], b[column][row], 1e-12);
}

/// Group (1) > Sphere (2) > Point light (3), each turned, scaled and moved.
Scene nested() {
  Transform placed{{1, 2, 3}, glm::normalize(glm::dquat(1, 2, 3, 4)), glm::dvec3(2)};
  Scene scene = e::addGroup({}, placed).scene;
  scene = e::addShape(scene, Sphere{}, placed).scene;
  scene = e::addLight(scene, Light{}, placed).scene;
  scene.objects[1].parent = Id(1);
  scene.objects[2].parent = Id(2);
  return scene;
}

template <class... Ids>
std::vector<Id> ids(Ids... id) {
  return {Id(id)...};
}

}  // namespace

TEST(Edits, add_every_kind_under_a_free_name) {
  Scene scene;
  for (const Shape& shape :
       {Shape{Sphere{}}, Shape{Plane{}}, Shape{Box{}}, Shape{Rect{}}, Shape{Disk{}}, Shape{Cylinder{}}})
    scene = e::addShape(scene, shape).scene;
  for (const Light& light :
       {Light{PointLight{}}, Light{SpotLight{}}, Light{DirectionalLight{}}, Light{SphereLight{}},
        Light{RectLight{}}, Light{DiskLight{}}, Light{EnvironmentLight{}}})
    scene = e::addLight(scene, light).scene;
  scene = e::addCamera(scene, {}).scene;
  scene = e::addGroup(scene).scene;
  scene = e::addShape(scene, Sphere{}).scene;
  const char* names[] = {"Sphere",       "Plane",      "Box",
                         "Rect",         "Disk",       "Cylinder",
                         "Point light",  "Spot light", "Directional light",
                         "Sphere light", "Rect light", "Disk light",
                         "Environment",  "Camera",     "Group",
                         "Sphere.001"};
  ASSERT_EQ(scene.objects.size(), std::size(names));
  for (std::size_t i = 0; i < std::size(names); ++i) EXPECT_EQ(scene.objects[i].name, names[i]);
  EXPECT_EQ(scene.activeCamera, findByName(scene, "Camera")->id);
  expectSound(scene);
}

TEST(Edits, a_second_camera_does_not_take_over) {
  const auto first = e::addCamera({}, {});
  EXPECT_EQ(e::addCamera(first.scene, {}).scene.activeCamera, first.id);
}

TEST(Edits, remove_takes_what_is_inside_and_its_animation_along) {
  Scene scene = e::setKeyframe(nested(), Id(3), Property::lightIntensity, 0.0);
  scene = e::remove(scene, ids(2));
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_TRUE(scene.animation.channels.empty());
  expectSound(scene);
}

TEST(Edits, remove_keeping_children_leaves_them_where_they_were) {
  const Scene before = nested();
  const Scene after = e::remove(before, ids(1, 2), e::Children::keep);
  ASSERT_EQ(after.objects.size(), 1u);
  EXPECT_EQ(after.objects[0].parent, Id::none);
  expectSamePlace(worldFromObject(after, Id(3)), worldFromObject(before, Id(3)));
  const Scene inner = e::remove(before, ids(2), e::Children::keep);
  EXPECT_EQ(find(inner, Id(3))->parent, Id(1));
  expectSamePlace(worldFromObject(inner, Id(3)), worldFromObject(before, Id(3)));
}

TEST(Edits, removing_the_active_camera_leaves_none_active) {
  const auto camera = e::addCamera({}, {});
  expectSound(e::remove(camera.scene, std::vector{camera.id}));
}

TEST(Edits, duplicate_copies_deep_with_new_ids_names_and_keys) {
  const Scene before = e::setKeyframe(nested(), Id(3), Property::translation, 1.0);
  const auto copied = e::duplicate(before, ids(1, 3));  // 3 lies inside 1
  ASSERT_EQ(copied.ids.size(), 1u);
  ASSERT_EQ(copied.scene.objects.size(), 6u);
  const Object* light = findByName(copied.scene, "Point light.001");
  ASSERT_TRUE(light);
  EXPECT_EQ(find(copied.scene, light->parent)->name, "Sphere.001");
  EXPECT_EQ(find(copied.scene, find(copied.scene, light->parent)->parent)->id, copied.ids[0]);
  EXPECT_EQ(copied.scene.animation.channels.at(1).target, light->id);
  expectSamePlace(worldFromObject(copied.scene, light->id), worldFromObject(before, Id(3)));
  expectSound(copied.scene);
}

TEST(Edits, names_count_on_from_their_number) {
  Scene scene = e::addGroup({}).scene;
  for (const char* next : {"Group.001", "Group.002"}) {
    scene = e::duplicate(scene, std::vector{scene.objects.back().id}).scene;
    EXPECT_EQ(scene.objects.back().name, next);
  }
  EXPECT_EQ(e::freeObjectName(scene, "Lamp"), "Lamp");
  EXPECT_EQ(e::freeObjectName(scene, "Group", scene.objects[0].id), "Group");
  scene = e::rename(scene, scene.objects[0].id, "v1.999");
  EXPECT_EQ(e::freeObjectName(scene, "v1.999"), "v1.1000");
  scene = e::rename(scene, scene.objects[0].id, "x.99999999999999999999");
  EXPECT_EQ(e::freeObjectName(scene, "x.99999999999999999999"), "x.99999999999999999999.001");
}

TEST(Edits, rename_keeps_names_unique_and_ignores_an_empty_one) {
  Scene scene = e::addGroup(e::addGroup({}).scene).scene;
  EXPECT_EQ(e::rename(scene, Id(2), "Group").objects[1].name, "Group.001");
  EXPECT_EQ(e::rename(scene, Id(2), "").objects[1].name, "Group.001");
  EXPECT_EQ(e::rename(scene, Id(2), "Table").objects[1].name, "Table");
}

TEST(Edits, set_parent_keeps_the_place_in_the_world) {
  const Scene before = nested();
  for (const Id parent : {Id::none, Id(1)}) {
    const Scene after = e::setParent(before, ids(3, 2), parent);
    EXPECT_EQ(find(after, Id(3))->parent, parent);
    for (const Id id : {Id(2), Id(3)})
      expectSamePlace(worldFromObject(after, id), worldFromObject(before, id));
    expectSound(after);
  }
}

TEST(Edits, set_parent_refuses_a_cycle) {
  EXPECT_THROW(e::setParent(nested(), ids(1), Id(3)), Error);
  EXPECT_THROW(e::setParent(nested(), ids(1), Id(1)), Error);
}

TEST(Edits, changing_a_light_into_a_shape_drops_its_light_keys_only) {
  Scene scene = e::addLight({}, {}).scene;
  scene = e::setKeyframe(scene, Id(1), Property::lightIntensity, 0.0);
  scene = e::setKeyframe(scene, Id(1), Property::translation, 0.0);
  scene = e::setContent(scene, Id(1), Geometry{Sphere{}, Id::none});
  EXPECT_EQ(scene.animation.channels.size(), 1u);
  expectSound(scene);
}

TEST(Edits, a_new_material_copies_the_present_one_and_belongs_to_one_object) {
  auto gold = e::addMaterial({}, {.name = "Gold", .metallic = 1.0f});
  Scene scene = e::addShape(gold.scene, Sphere{}, {}, gold.id).scene;
  scene = e::addShape(scene, Box{}, {}, gold.id).scene;
  const auto added = e::assignNewMaterial(scene, scene.objects[0].id);
  EXPECT_EQ(findMaterial(added.scene, added.id)->metallic, 1.0f);
  EXPECT_EQ(findMaterial(added.scene, added.id)->name, "Gold.001");
  EXPECT_EQ(std::get<Geometry>(added.scene.objects[0].content).material, added.id);
  EXPECT_EQ(std::get<Geometry>(added.scene.objects[1].content).material, gold.id);
  expectSound(added.scene);
  EXPECT_EQ(e::removeUnusedMaterials(added.scene).materials.size(), 2u);
  const Scene without = e::remove(added.scene, std::vector{scene.objects[0].id});
  EXPECT_EQ(e::removeUnusedMaterials(without).materials.size(), 1u);
}

TEST(Edits, set_material_changes_the_one_of_that_id) {
  auto first = e::addMaterial({}, {.name = "A"});
  auto second = e::addMaterial(first.scene, {.name = "B"});
  Material changed = *findMaterial(second.scene, first.id);
  changed.roughness = 0.125f;
  changed.name = "B";
  const Scene scene = e::setMaterial(second.scene, changed);
  EXPECT_EQ(scene.materials[0].roughness, 0.125f);
  EXPECT_EQ(scene.materials[0].name, "B.001");
  EXPECT_EQ(scene.materials[1], second.scene.materials[1]);
}

TEST(Edits, keyframes_stay_in_order_and_replace_their_equals) {
  Scene scene = e::addGroup({}).scene;
  for (const double time : {2.0, 0.0, 1.0, 1.0})
    scene = e::setKeyframe(scene, Id(1), Property::translation, time);
  EXPECT_EQ(scene.animation.channels.at(0).keys.size(), 3u);
  expectSound(scene);
  EXPECT_EQ(e::setKeyframe(scene, Id(1), Property::lightColor, 0.0), scene);
  for (const double time : {0.0, 1.0, 2.0})
    scene = e::removeKeyframe(scene, Id(1), Property::translation, time);
  EXPECT_TRUE(scene.animation.channels.empty());
}

TEST(Edits, only_a_camera_becomes_active) {
  const Scene scene = e::addGroup({}).scene;
  EXPECT_EQ(e::setActiveCamera(scene, Id(1)), scene);
}
