// SPDX-License-Identifier: MIT
// How far a path moves off a mesh before it goes on: far enough never to meet the place again, and no
// farther.
#include "renderer/reference/device_paths.hpp"
#include "tests/renderer/meshes.hpp"
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian::reference {
namespace {

using scenes::dvec3;

// Rows of a record (shaders/path_record.glsl): the first vertex' point, and where the second one's ray
// starts.
constexpr std::size_t pointRow = 2 + 7, nextOrigin = 2 + 14 + 17 * 5;

class MeshGap : public RendererTest {};

TEST_F(MeshGap, row11_a_new_ray_starts_within_a_millionth_of_its_place_or_of_the_mesh) {
  constexpr Extent film{16, 16};
  for (const double distance : {0.0, 1e4, 1e7})
    for (const double cameraSizes : {3.0, 1000.0}) {
      Scene scene = scenes::plainScene(2);
      scenes::add(scene, scenes::at({distance, -distance, distance}, {1, 2, 3}, 0.8),
                  MeshShape{sharedMesh(meshes::quad(0.5f))}, scenes::lambert(glm::vec3(0.5f)));
      const glm::dmat4 world = worldFromObject(scene, scene.objects[0].id);
      const dvec3 centre(world[3]), towards = glm::normalize(dvec3(world[1]) + 0.5 * dvec3(world[0]));
      const CameraView view = scenes::lookAt(centre + cameraSizes * towards, centre, 0.5 / cameraSizes);
      const TracedScene traced = tracedScene(packScene(scene, view, film), *device_);
      int moved = 0;
      for (const PathRecord& path : recordPaths(*device_, traced, {0, 0, film.width, film.height}, 0, 1)) {
        ASSERT_GE(path.rows[0].x, 2.0f) << "the path ends on the square";
        const glm::vec3 p(path.rows[pointRow]), o(path.rows[nextOrigin]);
        const float allowed = 1e-6f * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), 1.0f});
        const glm::vec3 gap = glm::abs(o - p);
        EXPECT_LE(std::max({gap.x, gap.y, gap.z}), allowed) << distance << " " << cameraSizes;
        measured("gap / largest coordinate of the point or the mesh",
                 1e-6 * double(std::max({gap.x, gap.y, gap.z}) / allowed), 1e-6);
        moved += o != p;
      }
      EXPECT_EQ(moved, film.width * film.height);
    }
}

}  // namespace
}  // namespace steradian::reference
