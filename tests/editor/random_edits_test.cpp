// SPDX-License-Identifier: MIT
// Property test: 1,000 random edits, undo all == start, redo all == end, and every scene between is sound.
#include <gtest/gtest.h>

#include <random>

#include "editor/document.hpp"
#include "editor/edits.hpp"
#include "renderer/scene/validate.hpp"

using namespace steradian;
namespace e = steradian::edits;

namespace {

class RandomEditor {
 public:
  explicit RandomEditor(unsigned seed) : random_(seed) {}

  /// One edit drawn from all operations.
  Scene next(const Scene& scene) {
    switch (upTo(18)) {
      case 0:
      case 1:
        return e::addShape(scene, shape(), transform(), material(scene)).scene;
      case 2:
        return e::addLight(scene, light(), transform()).scene;
      case 3:
        return e::addCamera(scene, Camera{0.1 + real()}, transform()).scene;
      case 4:
        return e::addGroup(scene, transform()).scene;
      case 5:
        return e::remove(scene, objects(scene, 1), upTo(2) ? e::Children::keep : e::Children::remove);
      case 6:
        return scene.objects.size() < 200 ? e::duplicate(scene, objects(scene, 2)).scene : scene;
      case 7:
        return e::rename(scene, object(scene), "Name" + std::to_string(upTo(5)));
      case 8:
        return e::setVisible(scene, objects(scene, 3), upTo(2) == 0);
      case 9:
        return reparented(scene);
      case 10:
        return e::setTransform(scene, object(scene), transform());
      case 11:
        return e::setContent(scene, object(scene), content(scene));
      case 12:
        return e::assignMaterial(scene, objects(scene, 3), material(scene));
      case 13:
        return e::assignNewMaterial(scene, object(scene)).scene;
      case 14:
        return upTo(4) ? changedMaterial(scene) : e::removeUnusedMaterials(scene);
      case 15:
        return settings(scene);
      case 16:
        return e::setActiveCamera(scene, object(scene));
      default:
        return keyed(scene);
    }
  }

 private:
  unsigned upTo(unsigned n) { return unsigned(random_() % n); }
  double real() { return std::uniform_real_distribution<>(0.1, 1.0)(random_); }
  Id object(const Scene& s) { return s.objects.empty() ? Id::none : s.objects[upTo(s.objects.size())].id; }
  std::vector<Id> objects(const Scene& s, unsigned count) {
    std::vector<Id> ids;
    for (unsigned i = 0; i < count; ++i) ids.push_back(object(s));
    return ids;
  }
  Id material(const Scene& s) {
    return s.materials.empty() ? Id::none : s.materials[upTo(s.materials.size())].id;
  }
  Transform transform() {
    const glm::dquat q(real(), real() - 0.5, real() - 0.5, real() - 0.5);
    return {{real(), real(), real()}, glm::normalize(q), glm::dvec3(0.5 + real())};
  }
  Shape shape() {
    const Shape shapes[] = {Sphere{real()}, Plane{}, Box{}, Rect{}, Disk{real()}, Cylinder{real(), real()}};
    return shapes[upTo(6)];
  }
  Light light() {
    const Light lights[] = {{PointLight{}},
                            {SpotLight{}},
                            {DirectionalLight{float(real())}},
                            {SphereLight{real()}},
                            {RectLight{{real(), 2.0}}},
                            {DiskLight{real()}},
                            {EnvironmentLight{.horizon = glm::vec3(float(real()))}}};
    Light light = lights[upTo(7)];
    light.intensity = float(real());
    if (upTo(2)) light.temperature = float(1000.0 + 1000.0 * real());
    return light;
  }
  e::Content content(const Scene& scene) {
    const e::Content contents[] = {Group{}, Geometry{shape(), material(scene)}, light(), Camera{real()}};
    return contents[upTo(4)];
  }
  Scene reparented(const Scene& scene) try {
    return e::setParent(scene, objects(scene, 2), upTo(3) ? object(scene) : Id::none);
  } catch (const Error&) {
    return scene;  // a cycle was refused
  }
  Scene changedMaterial(const Scene& scene) {
    const Material* found = findMaterial(scene, material(scene));
    if (!found) return e::addMaterial(scene).scene;
    Material changed = *found;
    changed.roughness = float(real());
    changed.transmission = float(real());
    changed.attenuationColor = glm::vec3(float(real()));
    changed.clearcoat = float(real());
    changed.edgeTint.y = float(real());
    changed.name = "M" + std::to_string(upTo(3));
    return e::setMaterial(scene, changed);
  }
  Scene settings(const Scene& scene) {
    RenderSettings render = scene.render;
    render.maxBounces = int(upTo(65));
    render.energyCompensation = upTo(2) == 0;
    render.clamp = float(real());
    DisplaySettings display = scene.display;
    display.exposure = float(real());
    display.physical = upTo(2) == 0;
    display.ev100 = float(real());
    return e::setDisplay(e::setRender(scene, render), display);
  }
  Scene keyed(const Scene& scene) {
    const auto property = Property(upTo(5));
    return upTo(3) ? e::setKeyframe(scene, object(scene), property, upTo(4))
                   : e::removeKeyframe(scene, object(scene), property, upTo(4));
  }

  std::mt19937 random_;
};

}  // namespace

TEST(RandomEdits, undo_all_is_the_start_and_redo_all_is_the_end) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    RandomEditor editor(seed);
    Document document;
    const Scene start = document.scene();
    std::vector<Scene> committed{start};
    for (int i = 0; i < 1000; ++i) {
      document.apply(editor.next(document.scene()), "Edit " + std::to_string(i));
      const auto problems = problemsOf(document.scene());
      ASSERT_TRUE(problems.empty()) << problems[0].where << " " << problems[0].what << " after edit " << i;
      if (!(document.scene() == committed.back())) committed.push_back(document.scene());
    }
    ASSERT_GT(committed.size(), 600u);
    const Scene end = document.scene();
    ASSERT_FALSE(start == end);
    for (std::size_t i = committed.size(); i-- > 1;) {
      ASSERT_TRUE(document.scene() == committed[i]);
      ASSERT_TRUE(document.undo());
    }
    EXPECT_EQ(document.scene(), start);
    EXPECT_FALSE(document.unsaved());
    while (document.redo()) {
    }
    EXPECT_EQ(document.scene(), end);
  }
}
