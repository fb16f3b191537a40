// SPDX-License-Identifier: MIT
// Parts that a device rendered: split anywhere and merged in any order they are the render of all samples at
// once.
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
  Part part(std::uint64_t begin, std::uint64_t end) {
    const CameraView view = lookAt({0, 1.5, 3}, {0, 0.3, 0}, 0.8);
    render(room(), view, {33, 17}, end, begin);
    PartOrigin origin;
    origin.scene = "room";
    return partOf(renderer().filmSums(), origin);
  }
};

TEST_F(DeviceParts, merged_in_any_order_are_the_render_of_all_samples) {
  const Image whole = meanOf(part(0, 64));
  const std::vector<Part> parts = {part(0, 16), part(16, 17), part(17, 64)};
  const Part forward = merged(parts, {"a", "b", "c"});
  EXPECT_EQ(forward, merged({parts[2], parts[0], parts[1]}, {"c", "a", "b"}));
  EXPECT_EQ(forward, merged({merged({parts[2], parts[1]}, {"c", "b"}), parts[0]}, {"cb", "a"}));
  const Image mean = meanOf(forward);
  ASSERT_EQ(mean.pixels.size(), whole.pixels.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    EXPECT_NEAR(mean.pixels[i], whole.pixels[i], 1.3e-7f * whole.pixels[i]);
    different += mean.pixels[i] != whole.pixels[i];
  }
  EXPECT_LE(different, 1u) << "a film keeps 2^-48 of its sums: the last bit of hardly a value may differ";
}

}  // namespace
}  // namespace steradian
