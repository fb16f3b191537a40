// SPDX-License-Identifier: MIT
// Glowing meshes as lights: their triangles are filled evenly, and with the density that is stated.
#include "renderer/gpu_scene.hpp"
#include "shaders/kernel_mesh_light.comp.h"
#include "tests/renderer/scenes.hpp"
#include "tests/renderer/textures.hpp"
#include "tests/shaders/histogram.hpp"

namespace steradian::kernel {
namespace {

using namespace scenes;

const Kernel meshLight{kernel_mesh_light_spirv, "mesh light"};
constexpr float nit = 3.0f;

struct MeshLamp {
  const char* name;
  Mesh mesh;
  Transform place;
  dvec3 p;  // that it shines on
};

/// A ball of triangles of very different sizes.
Mesh lantern() {
  Mesh ball = meshes::icosphere(1);
  for (glm::vec3& p : ball.positions) p.x = p.x > 0.0f ? p.x * p.x : p.x;
  return ball;
}
/// Of one scale but mirrored, near and around p; stretched; few triangles that overlap.
std::vector<MeshLamp> meshLamps() {
  return {{"mirrored", lantern(), at({0.3, 1, -2}, {1, 1, 0}, 0.8, dvec3(0.5, -0.5, 0.5)), {0.1, 0.2, 0.3}},
          {"stretched", lantern(), at({0.2, 0.1, -1}, {1, 1, 0}, 0.8, dvec3(3, -6, 1.5)), {0.1, 0.2, 0.3}},
          {"soup", meshes::soup(5, 0.8f, 24), at({-2, 1, 3}, {0, 1, 0}, 0.4, dvec3(0.7)), {0.1, -0.8, 0.3}}};
}

/// A triangle in the world. Triangles are chosen by their areas in the mesh, before it is stretched.
struct Triangle {
  dvec3 corner, edge1, edge2;
  double before, share;

  dvec3 normal() const { return glm::normalize(glm::cross(edge1, edge2)); }
  double area() const { return 0.5 * glm::length(glm::cross(edge1, edge2)); }
  /// The weights of the three corners.
  dvec3 weightsOf(const dvec3& point) const {
    const dvec3 n = glm::cross(edge1, edge2), q = point - corner;
    const double b1 = glm::dot(glm::cross(q, edge2), n) / glm::dot(n, n),
                 b2 = glm::dot(glm::cross(edge1, q), n) / glm::dot(n, n);
    return {1 - b1 - b2, b1, b2};
  }
};

std::vector<Triangle> trianglesOf(const MeshLamp& lamp) {
  const glm::dmat4 world = matrixOf(lamp.place);
  const glm::dmat3 axes(world);
  std::vector<Triangle> triangles;
  double total = 0;
  for (const glm::uvec3& t : lamp.mesh.triangles) {
    const dvec3 a(lamp.mesh.positions[t.x]), edge1 = dvec3(lamp.mesh.positions[t.y]) - a,
                                             edge2 = dvec3(lamp.mesh.positions[t.z]) - a;
    const double twice = glm::length(glm::cross(edge1, edge2));
    triangles.push_back({dvec3(world * glm::dvec4(a, 1)), axes * edge1, axes * edge2, total, twice});
    total += twice;
  }
  for (Triangle& t : triangles) t.before /= total, t.share /= total;
  return triangles;
}

struct MeshSample {
  dvec3 wi;
  double distance, illuminance, pdf, askedPdf;
  std::size_t triangle;
};

class MeshLightSamples : public KernelTest {
 protected:
  static std::vector<MeshSample> draw(const MeshLamp& lamp) {
    Scene scene = plainScene(1);
    add(scene, lamp.place, textures::shape(lamp.mesh), emitter(nit));
    const GpuScene packed = packScene(scene, lookAt({0, 0, 0}, {0, 0, -1}, 1.0), {8, 8});
    EXPECT_EQ(packed.params.lightCount, 1u);
    Task task{.rowsIn = 0,
              .rowsOut = 2,
              .invocations = manySamples,
              .push = pushBytes(packed.params),
              .scene = packed.rows};
    for (const auto* part :
         {&packed.meshes[0]->nodes, &packed.meshes[0]->triangles, &packed.vertices[0]->rows})
      task.mesh.insert(task.mesh.end(), part->begin(), part->end());
    for (std::uint32_t i = 0; i < gpu::FEATURE_COUNT; ++i)
      task.constants.emplace_back(i, (packed.features >> i) & 1u);
    task.constants.emplace_back(gpu::CONSTANT_MESH_LIGHTS, 1u);
    const Rows a = run(meshLight, task, {glm::vec4(glm::vec3(lamp.p - packed.origin), 0)});
    std::vector<MeshSample> samples;
    for (std::size_t i = 0; i < a.size(); i += 2)
      samples.push_back({xyz(a[i]), a[i].w, a[i + 1].x, a[i + 1].y, a[i + 1].z, std::size_t(a[i + 1].w)});
    return samples;
  }
};

/// The mesh unrolled onto the unit square, keeping areas: triangle after triangle, each by lines towards its
/// third corner. Counts points that lie beside their triangle.
dvec3 unrolled(const MeshLamp& lamp, const std::vector<Triangle>& triangles, const MeshSample& s,
               int& beside) {
  const Triangle& t = triangles[s.triangle];
  const dvec3 point = lamp.p + s.wi * (s.distance / 0.99998);  // shadow rays end before the point
  const dvec3 weights = t.weightsOf(point);
  beside += std::fabs(glm::dot(point - t.corner, t.normal())) > 1e-6 * (s.distance + 1) ||
            std::min({weights.x, weights.y, weights.z}) < -1e-3;
  const double rest = std::max(1 - weights.z, 1e-12);
  return {t.before + t.share * rest * rest, weights.y / rest, 0};
}

TEST_F(MeshLightSamples, row24_meshes_are_filled_evenly_by_area) {
  for (const MeshLamp& lamp : meshLamps()) {
    std::vector<Triangle> triangles = trianglesOf(lamp);
    const std::vector<MeshSample> samples = draw(lamp);
    int beside = 0;
    const auto onSquare = [&](const MeshSample& s) { return unrolled(lamp, triangles, s, beside); };
    expectEven(histogramP(samples, onSquare, evenShare), sidak, lamp.name);
    EXPECT_EQ(beside, 0) << lamp.name;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      triangles[i].share = 1.0 / double(triangles.size());
      triangles[i].before = double(i) * triangles[i].share;
    }
    EXPECT_LT(histogramP(samples, onSquare, evenShare), sidak) << "not each triangle alike: must bite";
  }
}

TEST_F(MeshLightSamples, row25_the_density_stated_is_that_of_the_areas_seen_from_the_point) {
  for (const MeshLamp& lamp : meshLamps()) {
    const std::vector<Triangle> triangles = trianglesOf(lamp);
    std::vector<double> sums(triangles.size(), 0.0), counts(triangles.size(), 0.0);
    double worst = 0, worstLight = 0;
    for (const MeshSample& s : draw(lamp)) {
      const Triangle& t = triangles[s.triangle];
      const double cosine = std::fabs(glm::dot(s.wi, t.normal()));
      const double distance = std::fabs(glm::dot(t.corner - lamp.p, t.normal())) / cosine;
      const double byArea = cosine / (distance * distance), expected = t.share / t.area();
      sums[s.triangle] += s.pdf * byArea, counts[s.triangle] += 1;
      worstLight = std::max(worstLight, std::fabs(s.illuminance * s.pdf / nit - 1));
      if (cosine < 0.01) continue;  // of which a float's direction has few digits
      for (const double pdf : {s.pdf, s.askedPdf})
        worst = std::max(worst, std::fabs(pdf * byArea / expected - 1));
    }
    double integral = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      ASSERT_GT(counts[i], 0.0) << lamp.name << ": triangle " << i << " was never drawn";
      integral += sums[i] / counts[i] * triangles[i].area();
    }
    EXPECT_LE(worst, 1e-4) << lamp.name;
    EXPECT_LE(worstLight, 1e-5) << lamp.name;
    EXPECT_NEAR(integral, 1.0, 1e-4) << lamp.name;
    measured("relative error of the density by area", worst, 1e-4);
    measured("error of its integral over the mesh", std::fabs(integral - 1), 1e-4);
  }
}

}  // namespace
}  // namespace steradian::kernel
