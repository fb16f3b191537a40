// SPDX-License-Identifier: MIT
// Glowing meshes as lights: their triangles are filled evenly by solid angle, and with the density that is
// stated.
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

/// Van Oosterom & Strackee (1983).
double solidAngleOf(dvec3 a, dvec3 b, dvec3 c) {
  a = glm::normalize(a), b = glm::normalize(b), c = glm::normalize(c);
  return 2 * std::atan2(std::fabs(glm::dot(a, glm::cross(b, c))),
                        1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

/// A triangle as p sees it. Triangles are chosen by their areas in the mesh, before it is stretched.
struct Triangle {
  dvec3 corner, edge1, edge2;  // the corner from p
  double before, share;

  dvec3 normal() const { return glm::normalize(glm::cross(edge1, edge2)); }
  double area() const { return 0.5 * glm::length(glm::cross(edge1, edge2)); }
  double solidAngle() const { return solidAngleOf(corner, corner + edge1, corner + edge2); }
  bool sampledByArea() const { return solidAngle() < 1e-4; }
  /// Density per solid angle of those that are sampled by area.
  double areaPdf(const dvec3& wi) const {
    const double cosine = std::fabs(glm::dot(wi, normal())),
                 distance = std::fabs(glm::dot(corner, normal())) / cosine;
    return distance * distance / (cosine * area());
  }
  double pdf(const dvec3& wi) const { return share * (sampledByArea() ? areaPdf(wi) : 1 / solidAngle()); }
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
    triangles.push_back({dvec3(world * glm::dvec4(a, 1)) - lamp.p, axes * edge1, axes * edge2, total, twice});
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

/// A triangle on the unit square so that equal solid angles (or equal areas) cover equal areas: by the great
/// circle (or the line) through the third corner, then by the way along it. The shader turns around the first
/// corner.
glm::dvec2 unrolled(const Triangle& t, const dvec3& point, const dvec3& weights) {
  const double rest = std::max(1 - weights.z, 1e-12);
  if (t.sampledByArea()) return glm::dvec2(rest * rest, weights.y / rest);
  const dvec3 third = t.corner + t.edge2, end = t.corner + t.edge1 * (weights.y / rest);
  const auto gap = [&](const dvec3& at) {  // 1 - cosine of the angle from the third corner
    const dvec3 chord = glm::normalize(at) - glm::normalize(third);
    return 0.5 * glm::dot(chord, chord);
  };
  return {gap(point) / gap(end), solidAngleOf(third, t.corner, end) / t.solidAngle()};
}

/// The triangles side by side on the unit square. Counts points that lie beside their triangle.
dvec3 unrolled(const std::vector<Triangle>& triangles, const MeshSample& s, int& beside) {
  const Triangle& t = triangles[s.triangle];
  const dvec3 point = s.wi * (s.distance / 0.99998);  // shadow rays end before the point
  const dvec3 weights = t.weightsOf(point);
  beside += std::fabs(glm::dot(point - t.corner, t.normal())) > 1e-6 * (s.distance + 1) ||
            std::min({weights.x, weights.y, weights.z}) < -1e-3;
  const glm::dvec2 at = unrolled(t, point, weights);
  return {t.before + t.share * at.x, at.y, 0};
}

TEST_F(MeshLightSamples, row24_meshes_are_filled_evenly) {
  for (const MeshLamp& lamp : meshLamps()) {
    std::vector<Triangle> triangles = trianglesOf(lamp);
    const std::vector<MeshSample> samples = draw(lamp);
    int beside = 0;
    const auto onSquare = [&](const MeshSample& s) { return unrolled(triangles, s, beside); };
    expectEven(histogramP(samples, onSquare, evenShare), sidak, lamp.name);
    EXPECT_EQ(beside, 0) << lamp.name;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      triangles[i].share = 1.0 / double(triangles.size());
      triangles[i].before = double(i) * triangles[i].share;
    }
    EXPECT_LT(histogramP(samples, onSquare, evenShare), sidak) << "not each triangle alike: must bite";
  }
}

TEST_F(MeshLightSamples, row25_the_density_stated_is_one_over_the_solid_angle_or_that_of_the_area) {
  bool seenByArea = false, seenByAngle = false;
  for (const MeshLamp& lamp : meshLamps()) {
    const std::vector<Triangle> triangles = trianglesOf(lamp);
    std::vector<double> sums(triangles.size(), 0.0), counts(triangles.size(), 0.0);
    double worst = 0, worstLight = 0, integral = 0;
    for (const MeshSample& s : draw(lamp)) {
      const Triangle& t = triangles[s.triangle];
      (t.sampledByArea() ? seenByArea : seenByAngle) = true;
      sums[s.triangle] += s.pdf / t.pdf(s.wi) * t.share, counts[s.triangle] += 1;
      worstLight = std::max(worstLight, std::fabs(s.illuminance * s.pdf / nit - 1));
      if (std::fabs(glm::dot(s.wi, t.normal())) < 0.01)
        continue;  // of which a float's direction has few digits
      for (const double pdf : {s.pdf, s.askedPdf}) worst = std::max(worst, std::fabs(pdf / t.pdf(s.wi) - 1));
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      ASSERT_GT(counts[i], 0.0) << lamp.name << ": triangle " << i << " was never drawn";
      integral += sums[i] / counts[i];
    }
    EXPECT_LE(worst, 1e-4) << lamp.name;
    EXPECT_LE(worstLight, 1e-5) << lamp.name;
    EXPECT_NEAR(integral, 1.0, 1e-4) << lamp.name;
    measured("relative error of a mesh light's density", worst, 1e-4);
    measured("error of its integral over the mesh", std::fabs(integral - 1), 1e-4);
  }
  EXPECT_TRUE(seenByArea && seenByAngle);
}

}  // namespace
}  // namespace steradian::kernel
