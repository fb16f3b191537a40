// SPDX-License-Identifier: MIT
// Parts that a device rendered: split anywhere and merged in any order they are the render of all samples at
// once, bit by bit.
#include "editor/part/part.hpp"
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

class DeviceParts : public RendererTest {
 protected:
  static Scene room() {
    Scene scene = plainScene(4);
    add(scene, at({0, 0, 0}), Plane{}, lambert(glm::vec3(0.7f)));
    add(scene, at({0, 0.5, 0}), Sphere{0.5}, plastic(0.3f, glm::vec3(0.6f)));
    add(scene, at({0.8, 0.3, 0.4}), Sphere{0.3}, metal(0.2f));
    addLight(scene, at({1, 2, 1}), SphereLight{0.3}, 8.0f);
    return scene;
  }
  /// Light that comes through glass alone, from a small lamp: samples from a millionth to a thousandfold.
  static Scene caustic() {
    Scene scene = room();
    scene.render.maxBounces = 8;
    Material glass;
    glass.albedo = {0.02f, 0.5f, 0.98f};
    glass.transmission = 1.0f;
    glass.roughness = 0.05f;
    add(scene, at({-0.8, 0.4, 0.5}), Sphere{0.4}, add(scene, glass));
    addLight(scene, at({-1.5, 1.5, 0.5}), SphereLight{0.01}, 1e5f);
    return scene;
  }
  Part part(const Scene& scene, std::uint64_t begin, std::uint64_t end) {
    const CameraView view = lookAt({0, 1.5, 3}, {0, 0.3, 0}, 0.8);
    render(scene, view, {33, 17}, end, begin);
    PartOrigin origin;
    origin.scene = "room";
    return partOf(renderer().filmSums(), origin);
  }
};

TEST_F(DeviceParts, merged_in_any_order_are_the_render_of_all_samples) {
  const Scene scene = room();
  const Part whole = part(scene, 0, 64);
  const std::vector<Part> parts = {part(scene, 0, 16), part(scene, 16, 17), part(scene, 17, 64)};
  EXPECT_EQ(whole, merged(parts, {"a", "b", "c"}));
  EXPECT_EQ(whole, merged({parts[2], parts[0], parts[1]}, {"c", "a", "b"}));
  EXPECT_EQ(whole, merged({merged({parts[2], parts[1]}, {"c", "b"}), parts[0]}, {"cb", "a"}));
}

TEST_F(DeviceParts, row36_of_thousands_of_samples_far_apart_in_size_merge_without_loss) {
  const Scene scene = caustic();
  const Part whole = part(scene, 0, 2000);
  EXPECT_EQ(meanOf(whole), renderer().radiance());
  const Part both = merged({part(scene, 0, 633), part(scene, 633, 2000)}, {"a", "b"});
  EXPECT_EQ(whole, both);
  measured("parts that differ", !(whole == both), 0);
}

}  // namespace
}  // namespace steradian
