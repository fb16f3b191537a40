// SPDX-License-Identifier: MIT
// Single rays through meshes on the device: no leaks, and the nearest of all triangles as a double brute
// force finds it.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "renderer/ray_caster.hpp"
#include "tests/measured.hpp"
#include "tests/renderer/meshes.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

class MeshRays : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    device_ = openDevice({});
    RecordProperty("device", describe(*device_).name);
  }
  static void TearDownTestSuite() {
    EXPECT_EQ(validationMessages(*device_), 0);
    device_.reset();
  }
  void SetUp() override { random_.seed(8); }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  dvec3 direction() {
    const double z = uniform(-1, 1), phi = uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  static CastRay ray(const dvec3& o, const dvec3& d) {
    return {glm::vec3(o), 1e30f, glm::vec3(glm::normalize(d))};
  }
  /// From the float that the origin becomes to a point.
  static CastRay rayTo(const dvec3& o, const dvec3& target) { return ray(o, target - dvec3(glm::vec3(o))); }

  static RayCaster casterOf(const Scene& scene, bool whileWhile = true) {
    return RayCaster(device_, packScene(scene, CameraView{}, {8, 8}), whileWhile);
  }
  static std::size_t missed(const std::vector<CastHit>& hits) {
    return std::size_t(std::ranges::count(hits, gpu::NO_PRIMITIVE, &CastHit::primitive));
  }
  static void expectAllHit(const std::vector<CastHit>& hits, const std::string& what) {
    EXPECT_EQ(missed(hits), 0u) << what;
    measured("rays of " + std::to_string(hits.size()) + " that pass through", double(missed(hits)), 0.0);
  }

  static inline std::shared_ptr<gpu::Device> device_;
  std::mt19937_64 random_;
};

Scene sceneOf(const Mesh& mesh, const Transform& place = {}) {
  Scene scene;
  add(scene, place, MeshShape{sharedMesh(mesh)}, Material{});
  return scene;
}

/// A ball whose vertices are moved about at random, still closed.
Mesh jitteredBall(int levels) {
  Mesh mesh = meshes::icosphere(levels);
  std::mt19937 random(5);
  for (glm::vec3& p : mesh.positions) p *= 0.8f + 0.4f * float(random()) * 0x1p-32f;
  return mesh;
}

TEST_F(MeshRays, row08_no_ray_leaves_a_closed_mesh_through_an_edge_or_a_vertex) {
  const Mesh mesh = jitteredBall(4);
  for (const bool whileWhile : {true, false})
    for (const double distance : {0.0, 1e5, 1e6}) {
      const dvec3 place(distance, -distance, 0.5 * distance);
      std::vector<CastRay> edges, vertices;
      for (int i = 0; i < 100000; ++i) {
        const dvec3 o = place + 0.2 * direction();
        const glm::uvec3& t = mesh.triangles[std::size_t(uniform(0, double(mesh.triangles.size())))];
        const dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]);
        edges.push_back(rayTo(o, place + glm::mix(a, b, uniform(0, 1))));
        vertices.push_back(rayTo(o, place + a));
      }
      RayCaster caster = casterOf(sceneOf(mesh, at(place)), whileWhile);
      const std::string far = " at " + std::to_string(distance);
      expectAllHit(caster.cast(edges, false).hits, "edges" + far);
      expectAllHit(caster.cast(vertices, false).hits, "vertices" + far);
      expectAllHit(caster.cast(vertices, true).hits, "shadow rays" + far);
    }
}

TEST_F(MeshRays, row08_rays_from_far_away_do_not_pass_through_a_small_closed_mesh) {
  const Mesh mesh = jitteredBall(3);
  for (const double distance : {30.0, 1000.0}) {
    std::vector<CastRay> rays;
    for (int i = 0; i < 100000; ++i) {
      const dvec3 o = distance * direction();
      rays.push_back(rayTo(o, 0.5 * uniform(0, 1) * direction()));
    }
    RayCaster caster = casterOf(sceneOf(mesh));
    expectAllHit(caster.cast(rays, false).hits, std::to_string(distance));
  }
}

TEST_F(MeshRays, row10_slivers_are_hit_or_missed_but_never_at_no_distance) {
  std::vector<CastRay> rays;
  Mesh mesh;
  for (int i = 0; i < 1000; ++i) {
    const dvec3 a = direction(), along = direction();
    const unsigned first = unsigned(mesh.positions.size());
    for (const dvec3& p : {a, a + along, a + 0.5 * along + 1e-6 * direction()})
      mesh.positions.emplace_back(p);
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    for (int k = 0; k < 20; ++k) rays.push_back(rayTo(3.0 * direction(), a + uniform(0, 1) * along));
  }
  RayCaster caster = casterOf(sceneOf(mesh));
  int nowhere = 0;
  for (const CastHit& hit : caster.cast(rays, false).hits) {
    EXPECT_TRUE(std::isfinite(hit.t));
    EXPECT_GT(hit.t, 0.0f);
    nowhere += !(hit.t > 0.0f && std::isfinite(hit.t));
  }
  measured("answers of no distance", nowhere, 0);
}

TEST_F(MeshRays, row12_rays_along_the_sides_of_boxes_hit_and_a_box_of_a_tenth_of_a_micrometre_stops_them) {
  // Boxes of a flat grid end where its lines are, and have no height at all.
  RayCaster plate = casterOf(sceneOf(meshes::terrain(64, [](float, float) { return 0.0f; })));
  std::vector<CastRay> down;
  for (int x = -31; x <= 31; ++x)
    for (int z = -31; z <= 31; ++z)
      for (const double side : {1.0, -1.0})
        down.push_back(ray({x / 32.0, 2.0 * side, z / 32.0}, {0, -side, 0}));
  expectAllHit(plate.cast(down, false).hits, "plate");

  Mesh thin = meshes::icosphere(2);
  for (glm::vec3& p : thin.positions) p.y *= 0.5e-7f;
  RayCaster disc = casterOf(sceneOf(thin));
  std::vector<CastRay> rays;
  for (int i = 0; i < 1 << 16; ++i) {
    const dvec3 target(uniform(-0.6, 0.6), 0, uniform(-0.6, 0.6));
    rays.push_back(rayTo(target + direction() * uniform(1, 5), target));
  }
  expectAllHit(disc.cast(rays, false).hits, "disc");
}

struct Nearest {
  double t = std::numeric_limits<double>::infinity();
  dvec3 normal{0.0};  // of the mesh, any length
};

/// Moller & Trumbore in double over all triangles.
Nearest nearest(const Mesh& mesh, const dvec3& o, const dvec3& d) {
  Nearest best;
  for (const glm::uvec3& t : mesh.triangles) {
    const dvec3 a(mesh.positions[t.x]), e1 = dvec3(mesh.positions[t.y]) - a,
                                        e2 = dvec3(mesh.positions[t.z]) - a;
    const dvec3 p = glm::cross(d, e2), s = o - a, q = glm::cross(s, e1);
    const double inverse = 1.0 / glm::dot(e1, p), u = glm::dot(s, p) * inverse, v = glm::dot(d, q) * inverse;
    const double distance = glm::dot(e2, q) * inverse;
    if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < best.t)
      best = {distance, glm::cross(e1, e2)};
  }
  return best;
}

/// How far rounding of the ray in the mesh's frame moves the distance: a plane that is grazed moves it most.
double allowed(const Nearest& hit, const glm::dmat3& meshFromWorld, const dvec3& o, const dvec3& d) {
  const glm::dmat3 size(glm::abs(meshFromWorld[0]), glm::abs(meshFromWorld[1]), glm::abs(meshFromWorld[2]));
  const dvec3 rounding = 5e-7 * (size * (glm::abs(o) + hit.t * glm::abs(d)) + 1.0);
  return glm::dot(glm::abs(hit.normal), rounding) / std::abs(glm::dot(hit.normal, meshFromWorld * d));
}

TEST_F(MeshRays, the_nearest_hit_is_that_of_a_brute_force_in_double) {
  const Mesh mesh = meshes::soup(2000, 0.2f, 9);
  for (const dvec3 scale : {dvec3(1), dvec3(0.01, 3, -1)}) {
    const Transform place = at({0.3, -0.2, 0.4}, {1, 2, 3}, 1.1, scale);
    const glm::dmat4 world = matrixOf(place), inverse = glm::inverse(world);
    std::vector<CastRay> rays;
    for (int i = 0; i < 4000; ++i)
      rays.push_back(
          rayTo(dvec3(world * glm::dvec4(1.5 * direction(), 1)),
                dvec3(world * glm::dvec4(uniform(-0.9, 0.9), uniform(-0.9, 0.9), uniform(-0.9, 0.9), 1))));
    RayCaster caster = casterOf(sceneOf(mesh, place));
    const auto hits = caster.cast(rays, false).hits;
    const auto shadows = caster.cast(rays, true).hits;
    int differing = 0, blockedOtherwise = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const dvec3 o(rays[i].o), d(rays[i].d);
      const Nearest expected =
          nearest(mesh, dvec3(inverse * glm::dvec4(o, 1)), dvec3(inverse * glm::dvec4(d, 0)));
      const bool hit = hits[i].primitive != gpu::NO_PRIMITIVE;
      if (hit != std::isfinite(expected.t) ||
          (hit && std::abs(hits[i].t - expected.t) > allowed(expected, glm::dmat3(inverse), o, d)))
        ++differing;
      blockedOtherwise += hit != (shadows[i].primitive != gpu::NO_PRIMITIVE);
    }
    EXPECT_LE(differing, 4) << "rays that pass an edge within rounding";
    EXPECT_LE(blockedOtherwise, 1);
  }
}

TEST_F(MeshRays, instances_that_overlap_are_met_in_the_order_of_their_distance) {
  Scene scene;
  const MeshShape ball{sharedMesh(meshes::icosphere(3))};
  std::vector<dvec3> centres;
  for (int i = 0; i < 300; ++i) {
    centres.emplace_back(uniform(-10, 10), uniform(-10, 10), uniform(-10, 10));
    add(scene, at(centres.back()), ball, Material{});
  }
  std::vector<CastRay> rays;
  for (int i = 0; i < 20000; ++i) rays.push_back(ray(dvec3(uniform(-1, 1)) * 0.1, direction()));
  RayCaster caster = casterOf(scene);
  const auto hits = caster.cast(rays, false).hits;
  int differing = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    double best = std::numeric_limits<double>::infinity();
    for (const dvec3& c : centres) {  // the balls are within 1 % of spheres
      const dvec3 f = c - dvec3(rays[i].o);
      const double b = glm::dot(f, dvec3(rays[i].d)), h = 1.0 - (glm::dot(f, f) - b * b);
      if (h > 0 && b - std::sqrt(h) > 0)
        best = std::min(best, b - std::sqrt(h));
      else if (h > 0 && b + std::sqrt(h) > 0)
        best = std::min(best, b + std::sqrt(h));
    }
    const bool hit = hits[i].primitive != gpu::NO_PRIMITIVE;
    differing += hit != std::isfinite(best) || (hit && std::abs(hits[i].t - best) > 0.1);
  }
  EXPECT_LT(differing, 300) << "but for rays that graze a ball";
}

}  // namespace
}  // namespace steradian
