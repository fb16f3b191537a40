// SPDX-License-Identifier: MIT
// Pictures of meshes against closed forms and against the analytic shapes that they approximate.
#include <gtest/gtest.h>

#include "tests/renderer/meshes.hpp"
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

constexpr Extent film{16, 16};

class Meshes : public RendererTest {
 protected:
  void TearDown() override {
    renderer().setAblation({});
    RendererTest::TearDown();
  }
};

MeshShape shapeOf(Mesh mesh) {
  return MeshShape{sharedMesh(std::move(mesh))};
}

TEST_F(Meshes, row33_a_closed_mesh_of_glowing_walls_has_the_same_radiance_everywhere) {
  Ablation pathsAlone;
  pathsAlone.lightSampling = false;
  renderer().allowSpecialization(true);
  renderer().setAblation(pathsAlone);
  for (const auto& [albedo, bounces] : {std::pair(0.5, 8), std::pair(0.9, 64)}) {
    Scene scene = plainScene(bounces);
    add(scene, at({0, 0, 0}, {1, 2, 3}, 0.7), shapeOf(meshes::icosphere(2)),
        emitter(1.0f, glm::vec3(float(albedo))));
    const double expected = (1.0 - std::pow(albedo, bounces + 2)) / (1.0 - albedo);
    // Every sample is the same number: a single leak shows.
    const Image image =
        render(scene, lookAt({0.2, 0.1, 0.3}, {1, 0.4, -0.5}, 1.2), film, bounces > 8 ? 8 : 64);
    for (const float value : image.pixels) {
      ASSERT_NEAR(value, expected, 1e-4 * expected);
      measured("relative error of the worst pixel", std::abs(value / expected - 1.0), 1e-4);
    }
  }
}

TEST_F(Meshes, a_fine_ball_looks_like_the_sphere) {
  const auto picture = [&](Shape shape) {
    Scene scene = plainScene(3);
    add(scene, at({0, 0, 0}), shape, lambert(glm::vec3(0.8f)));
    add(scene, at({0, -1, 0}), Plane{}, lambert(glm::vec3(0.5f)));
    addLight(scene, at({3, 4, 5}), PointLight{}, 100.0f);
    return render(scene, lookAt({0, 1, 4}, {0, 0, 0}, 0.7), film, 64);
  };
  EXPECT_LT(mrse(picture(shapeOf(meshes::icosphere(5))), picture(Sphere{1.0})), 1e-3);
}

TEST_F(Meshes, turned_stretched_and_mirrored_instances_look_like_the_ellipsoid) {
  const MeshShape ball = shapeOf(meshes::icosphere(5));
  for (const dvec3 scale : {dvec3(0.5, 1.5, 1.0), dvec3(-0.5, 1.5, 1.0), dvec3(0.5, -1.5, -1.0)}) {
    const auto picture = [&](Shape shape) {
      Scene scene = plainScene(2);
      add(scene, at({0.3, 0, 0}, {1, 1, 0}, 0.8, scale), shape, lambert(glm::vec3(0.8f)));
      addLight(scene, at({3, 4, 5}), PointLight{}, 100.0f);
      return render(scene, lookAt({0, 1, 4}, {0, 0, 0}, 0.7), film, 64);
    };
    EXPECT_LT(mrse(picture(ball), picture(Sphere{1.0})), 1e-3);
  }
}

TEST_F(Meshes, many_instances_are_all_there_and_all_pickable) {
  Scene scene = plainScene(1);
  const MeshShape ball = shapeOf(meshes::icosphere(2));
  std::vector<Id> ids;
  for (int i = 0; i < 64; ++i)
    ids.push_back(add(scene, at({2.5 * (i % 8) - 8.75, 2.5 * (i / 8) - 8.75, 0}), ball, emitter(1.0f)));
  const CameraView view = lookAt({0, 0, 40}, {0, 0, 0}, 2.0 * std::atan(0.25));
  renderer().setScene(scene, view, {128, 128});
  for (int i = 0; i < 64; ++i) {
    const int x = int(64.0 + 6.4 * (2.5 * (i % 8) - 8.75)), y = int(64.0 - 6.4 * (2.5 * (i / 8) - 8.75));
    const auto picked = renderer().pick(x, y);
    ASSERT_TRUE(picked) << i;
    EXPECT_EQ(picked->object, ids[std::size_t(i)]);
    EXPECT_NEAR(glm::length(picked->position - dvec3(2.5 * (i % 8) - 8.75, 2.5 * (i / 8) - 8.75, 0)), 1.0,
                0.05);
  }
  EXPECT_FALSE(renderer().pick(1, 1));
}

TEST_F(Meshes, row14_a_scene_far_from_the_origin_looks_the_same) {
  Scene scene = plainScene(3);
  add(scene, at({0, 0, 0}, {1, 1, 0}, 0.8, {1, 0.7, 1.2}), shapeOf(meshes::icosphere(3)),
      lambert(glm::vec3(0.8f)));
  add(scene, at({0, -1, 0}), shapeOf(meshes::quad(6.0f)), lambert(glm::vec3(0.5f)));
  addLight(scene, at({3, 4, 5}), PointLight{}, 100.0f);
  const CameraView view = lookAt({0, 1, 4}, {0, 0, 0}, 0.7);
  const Image near = render(scene, view, {32, 32}, 16);
  for (const double distance : {1e5, 1e6}) {
    Scene farScene = scene;
    CameraView farView = view;
    translate(farScene, farView, dvec3(distance, -distance, 0.5 * distance));
    const double difference = mrse(render(farScene, farView, {32, 32}, 16), near);
    EXPECT_LT(difference, 1e-4) << distance;
    measured("MRSE against the scene at the origin", difference, 1e-4);
  }
}

/// A white square under a sun that stands above it, seen from `cameraSizes` times its size away: every sample
/// sees the square and sends one ray to the sun and one into the open, so one that meets the square again
/// shows.
Scene sunlitSquare(double size, double distance, const dvec3& turn) {
  Scene scene = plainScene(1);
  const Transform place = at({distance, -distance, 0.5 * distance}, turn, 0.8);
  add(scene, place, shapeOf(meshes::quad(float(0.5 * size))), emitter(1.0f, glm::vec3(0.5f)));
  Transform sun = place;
  sun.rotation = place.rotation * facing({0, -1, 0});
  addLight(scene, sun, DirectionalLight{}, 10.0f);
  return scene;
}

TEST_F(Meshes, row11_no_ray_that_leaves_a_mesh_meets_the_place_it_left) {
  for (const auto& [size, distance] :
       {std::pair(1.0, 0.0), {1.0, 1e4}, {0.01, 1e4}, {100.0, 1e6}, {1e7, 1e7}})
    for (const double cameraSizes : {3.0, 1000.0}) {
      const Scene scene = sunlitSquare(size, distance, {1, 2, 3});
      const glm::dmat4 world = worldFromObject(scene, scene.objects[0].id);
      const dvec3 centre(world[3]), up = glm::normalize(dvec3(world[1])),
                                    side = glm::normalize(dvec3(world[0]));
      const CameraView view =
          lookAt(centre + cameraSizes * size * glm::normalize(up + 0.5 * side), centre, 0.5 / cameraSizes);
      const Image image = render(scene, view, {128, 128}, 8);
      // Emitted and reflected; a path that meets the square again would add its glow.
      const float expected = float(1.0 + 10.0 * 0.5 / pi);
      std::size_t wrong = 0;
      for (const float value : image.pixels) wrong += std::abs(value - expected) > 1e-4f * expected;
      EXPECT_EQ(wrong, 0u) << "size " << size << " at " << distance << " from " << cameraSizes << " sizes";
      measured("pixels that met the square again", double(wrong), 0);
    }
}

TEST_F(Meshes, row16_the_loops_of_a_deep_mesh_end_within_the_budget) {
  Scene scene = plainScene(8);
  add(scene, at({0, 0, 0}), shapeOf(meshes::soup(100000, 0.05f, 2)), lambert(glm::vec3(0.9f)));
  addLight(scene, at({3, 4, 5}), PointLight{}, 100.0f);
  addLight(scene, at({-3, 4, 5}), PointLight{}, 100.0f);
  const CameraView view = lookAt({0, 0, 0}, {0, 0, -1}, 1.2);
  // A loop that was cut off would be cut elsewhere when every sample has a dispatch of its own.
  const Image together = render(scene, view, {32, 32}, 4);
  renderer().setScene(scene, view, {32, 32});
  renderer().setSampleRange(0, 1);
  for (std::uint64_t end = 1; end <= 4; ++end) {
    renderer().extendSamples(end);
    while (renderer().trace(200.0)) {
    }
  }
  EXPECT_EQ(renderer().radiance(), together);
  measured("pictures that differ", !(renderer().radiance() == together), 0);
}

TEST_F(Meshes, row41_a_single_instance_looks_the_same_without_the_hierarchy_above_it) {
  Scene scene = plainScene(4);
  add(scene, at({0, 0, 0}, {1, 1, 0}, 0.8), shapeOf(meshes::soup(3000, 0.3f, 4)),
      plastic(0.4f, {0.8f, 0.5f, 0.3f}));
  add(scene, at({0, -1.5, 0}), Plane{}, lambert(glm::vec3(0.5f)));
  addLight(scene, at({3, 4, 5}), PointLight{}, 100.0f);
  const CameraView view = lookAt({0, 1, 4}, {0, 0, 0}, 0.7);
  const Image generic = render(scene, view, {32, 32}, 8);
  renderer().allowSpecialization(true);
  renderer().waitForSpecialization();
  const Image special = render(scene, view, {32, 32}, 8);
  EXPECT_TRUE(renderer().stats().variant.specialized);
  expectSamePicture(special, generic);
}

TEST_F(Meshes, a_mesh_that_is_empty_or_flat_to_nothing_is_not_there) {
  Scene scene = plainScene(1);
  Mesh lines = meshes::quad(1.0f);
  lines.triangles = {{0, 0, 1}, {0, 1, 1}};
  add(scene, at({0, 0, 0}), shapeOf(lines), emitter(1.0f));
  add(scene, at({0, 0, 0}), shapeOf(Mesh{}), emitter(1.0f));
  add(scene, at({0, 0, 0}, {0, 1, 0}, 0, {1, 0, 1}), shapeOf(meshes::quad(1.0f)), emitter(1.0f));
  EXPECT_EQ(meanOf(render(scene, lookAt({0, 1, 4}, {0, 0, 0}, 0.7), film, 4)).value, 0.0);
}

}  // namespace
}  // namespace steradian
