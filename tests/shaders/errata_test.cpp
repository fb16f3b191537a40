// SPDX-License-Identifier: MIT
// Formulas that the printed sources of this renderer get wrong, each checked to be right here: one assertion
// for the correct value, one that the printed formula would not have given it.
#include <cmath>
#include <cstdint>

#include "tests/shaders/bsdf_rows.hpp"
#include "tests/shaders/scene_rows.hpp"

namespace steradian::kernel {
namespace {

class Errata : public KernelTest {
 protected:
  void TearDown() override { measured("failed assertions on an erratum", HasFailure(), 0); }

  static double hitShape(std::uint32_t operation, glm::vec3 o, glm::vec3 d, glm::vec4 shape,
                         bool self = false) {
    const Rows rows = {glm::vec4(o, self), glm::vec4(d, 0), shape, {}, {}};
    return double(run(shapes, {.operation = operation, .rowsIn = 5}, rows)[0].x);
  }
  static double hitSphere(glm::vec3 o, glm::vec3 d, float radius) {
    return hitShape(0, o, d, glm::vec4(0, 0, 0, radius));
  }
  static glm::vec4 evaluate(const Material& material, glm::dvec3 wo, glm::dvec3 wi, float chance = 0.5f) {
    Rows rows;
    pushBsdf(rows, material, glm::vec3(wo), glm::vec3(wi), chance);
    return run(bsdf, {.operation = 0, .rowsIn = bsdfRows}, rows)[0];
  }
  static glm::vec4 distribution(glm::dvec3 h, double alpha, double cosO, double cosI) {
    const Rows rows = {glm::vec4(glm::vec3(h), alpha), glm::vec4(cosO, cosI, 0, 0)};
    return run(bsdf, {.operation = 4, .rowsIn = 2}, rows)[0];
  }
  static glm::vec4 fresnel(double cosine, double eta, double f0 = 0.04) {
    return run(bsdf, {.operation = 5}, {glm::vec4(cosine, eta, f0, 1)})[0];
  }
};

TEST_F(Errata, row42_1_the_radius_is_squared) {
  EXPECT_NEAR(hitSphere({0, 0, 5}, {0, 0, -1}, 2), 3.0, 1e-6);
  EXPECT_GT(std::fabs(5 - std::sqrt(8.0) - 3.0), 0.5) << "printed: o.o - r";
}

TEST_F(Errata, row42_2_the_half_chord_is_not_doubled) {
  EXPECT_NEAR(hitSphere({0, 0, 5}, {0, 0, -1}, 1), 4.0, 1e-6);
  EXPECT_EQ(5.0 - std::sqrt(4.0 * 25.0 - 4.0 * 24.0), 3.0)
      << "printed discriminant with half the denominator";
}

TEST_F(Errata, row42_3_directions_of_the_camera_have_unit_length) {
  const Task task = [] {
    Task t = sceneTask(3, &gpu::TraceParams::sphereCount, {glm::vec4(0, 0, -5, 1)});
    t.rowsIn = 1;
    return t;
  }();
  Rows pixels;
  for (int x = 0; x < 64; ++x) pixels.emplace_back(x, 63 - x, 0.25f, 0.75f);
  for (const glm::vec4 d : run(sceneKernel, task, pixels)) EXPECT_NEAR(length(xyz(d)), 1.0, 3e-7);
}

TEST_F(Errata, row42_4_planes_lie_in_front) {
  EXPECT_NEAR(hitShape(2, {0, 1, 0}, {0, -1, 0}, {0, 1, 0, 0}), 1.0, 1e-6);
  const double printed = (1.0 - 0.0) / -1.0;  // (o - c).n / (d.n)
  EXPECT_EQ(printed, -1.0);
}

TEST_F(Errata, row42_5_from_inside_a_sphere_its_far_side_is_seen) {
  EXPECT_NEAR(hitSphere({0, 0, 0.5f}, {0, 0, -1}, 1), 1.5, 1e-6);
  EXPECT_LT(0.5 - 1.0, 0.0) << "the near root that the printed test discards is behind";
}

TEST_F(Errata, row42_6_a_ray_from_the_plane_and_a_ray_along_it_are_two_cases_that_both_miss) {
  EXPECT_TRUE(missed(float(hitShape(2, {3, 1e-7f, 0}, {0.6f, -0.8f, 0}, {0, 1, 0, 0}, true))))
      << "its own ray";
  EXPECT_FALSE(missed(float(hitShape(2, {3, 1e-7f, 0}, {0.6f, -0.8f, 0}, {0, 1, 0, 0})))) << "another's ray";
  EXPECT_TRUE(missed(float(hitShape(2, {3, 1, 0}, {1, 0, 0}, {0, 1, 0, 0})))) << "parallel";
}

TEST_F(Errata, row42_7_schlick_has_a_fifth_power) {
  EXPECT_NEAR(fresnel(0.5, 1.5).y, 0.07, 1e-6);
  EXPECT_NEAR(0.04 + 0.96 * 0.5, 0.52, 1e-9) << "printed";
}

TEST_F(Errata, row42_7_the_angle_is_that_to_the_half_vector) {
  // Retro-reflection at 60 degrees: h = wo = wi, so F stays at its value head-on.
  Material white = gltf(glm::vec3(0.0f), 0.0f, 0.5f);
  white.lobes = glossyBit;
  const glm::dvec3 w = direction(0.5, 0.0);
  const oracle::Vec v{glm::dvec3(glm::vec3(w))};
  const oracle::Real dg = oracle::ggxD(v, 0.5L) * oracle::g2(v, v, 0.5L) / (4 * v.z);
  EXPECT_NEAR(evaluate(white, w, w, 1.0f).x / double(dg), 0.04, 1e-6);
  EXPECT_GT(oracle::schlick(0.04L, 1, 0.5L), 0.069L) << "with n.l";
}

TEST_F(Errata, row42_8_fresnel_weighs_the_specular_lobe_once) {
  Material glass = gltf(glm::vec3(0.0f), 0.0f, 0.25f);
  const glm::dvec3 n(0, 0, 1);
  const oracle::Vec v(n);
  const oracle::Real dg = oracle::ggxD(v, 0.25L) / 4;
  EXPECT_NEAR(evaluate(glass, n, n).x / double(dg), 0.04, 1e-6) << "0.0016 if multiplied by the share again";
  const Material diffuse = lobes(gltf(glm::vec3(0.6f), 0.0f, 1.0f), diffuseBit);
  EXPECT_NEAR(evaluate(diffuse, n, n).x, 0.6 * (1 - 0.04) / M_PI, 1e-6) << "kd = (1 - F)(1 - metallic)";
  EXPECT_EQ(evaluate(lobes(gltf(glm::vec3(0.6f), 1.0f, 1.0f), diffuseBit), n, n).x, 0.0f) << "metals";
}

TEST_F(Errata, row42_9_reflection_leaves_the_surface) {
  Material mirror = lobes(gltf(glm::vec3(1.0f), 1.0f, 0.0f), mirrorBit);
  for (const double cosine : {1.0, 0.5, 0.1}) {
    Rows rows;
    pushBsdf(rows, mirror, glm::vec3(direction(cosine, 0.4)), {0.5f, 0.5f, 0}, 1.0f);
    const glm::dvec3 out = xyz(run(bsdf, {.operation = 1, .rowsIn = bsdfRows, .rowsOut = 3}, rows)[0]);
    EXPECT_LT(length(out - direction(cosine, 0.4 + M_PI)), 1e-6);
  }
  const glm::dvec3 l = direction(0.5, 0), n(0, 0, 1);
  EXPECT_GT(length(n * dot(l, n) - 2.0 * l), 1.7) << "printed: not even of unit length";
}

TEST_F(Errata, row42_10_alpha_is_the_roughness_squared) {
  const double roughness = 0.1;
  EXPECT_NEAR(distribution({0, 0, 1}, roughness * roughness, 1, 1).x, 3183.1, 0.5);
  EXPECT_NEAR(distribution({0, 0, 1}, roughness, 1, 1).x, 31.83, 0.01) << "printed: alpha is the roughness";
}

TEST_F(Errata, row42_11_masking_is_smith_s_of_the_same_alpha) {
  const double alpha = 0.01, mu = 0.05, k = (0.1 + 1) * (0.1 + 1) / 8;
  const oracle::Vec v(direction(mu, 0));
  const double printed = mu / (mu * (1 - k) + k);
  EXPECT_NEAR(distribution({0, 0, 1}, alpha, mu, mu).y, double(oracle::g1(v, 0.01L)), 1e-5);
  EXPECT_LT(printed, 0.5 * double(oracle::g1(v, 0.01L)));
}

TEST_F(Errata, row42_12_only_smith_s_own_lambda_loses_nothing_at_low_roughness) {
  const std::vector<Facet> nodes = facets(0.01, 128, 64);
  double exact = 0, printed = 0;
  const glm::dvec3 wo = direction(0.5, 0);
  const double k = 0.01 / 2;
  Rows rows;
  for (const Facet& f : nodes)
    rows.insert(rows.end(), {glm::vec4(glm::vec3(f.m), 0.01), glm::vec4(0.5, reflected(wo, f.m).z, 0, 0)});
  const Rows answers = run(bsdf, {.operation = 4, .rowsIn = 2}, rows);
  const auto schlickG = [&](double mu) { return mu / (mu * (1 - k) + k); };
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double mu = reflected(wo, nodes[i].m).z;
    if (mu <= 0) continue;
    const double rest = double(answers[i].x) * std::max(0.0, dot(wo, nodes[i].m)) / 0.5 * nodes[i].solidAngle;
    exact += rest * double(answers[i].z);
    printed += rest * schlickG(0.5) * schlickG(mu);
  }
  EXPECT_GT(exact, 0.9995);
  EXPECT_LT(printed, 0.995);
}

TEST_F(Errata, row42_13_reflected_directions_carry_their_jacobian) {
  const glm::dvec3 wo = direction(0.6, 0), m = direction(0.9, 1.0);
  const oracle::Vec o{glm::dvec3(glm::vec3(wo))};
  const double facetPdf = double(oracle::visiblePdf(o, m, 0.3L));
  Material white;
  white.alpha = 0.3f;
  const double pdf = double(evaluate(white, wo, reflected(wo, m), 1.0f).w);
  EXPECT_NEAR(pdf * 4 * dot(wo, m) / facetPdf, 1.0, 1e-4);
  EXPECT_GT(std::fabs(pdf / facetPdf - 1.0), 0.2) << "without the Jacobian";
}

TEST_F(Errata, row42_14_nothing_is_divided_by_the_cosine) {
  const glm::vec4 value = evaluate(gltf(glm::vec3(0.5f), 0.2f, 0.3f), {0, 0, 1}, {1, 0, 0});
  for (int c = 0; c < 4; ++c) EXPECT_EQ(value[c], 0.0f) << "at the horizon";
}

TEST_F(Errata, row42_15_radiance_is_per_projected_area) {
  const Material chalk = lobes(gltf(glm::vec3(1.0f), 0.0f, 1.0f, 0.0f), diffuseBit);
  Material lambert = chalk;
  lambert.dielectricF90 = 0.0f;
  for (const double cosine : {1.0, 0.5, 0.1})
    EXPECT_NEAR(evaluate(lambert, {0, 0, 1}, direction(cosine, 0)).x, cosine / M_PI, 1e-6);
}

TEST_F(Errata, row42_16_fresnel_is_reflected_by_incident) {
  // Where half is reflected and half refracted, F is 0.5; reflected by refracted would be 1.
  double low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (oracle::fresnel(middle, 1.5L) > 0.5L ? low : high) = middle;
  }
  EXPECT_NEAR(fresnel(low, 1.5).x, 0.5, 1e-5);
}

TEST_F(Errata, row42_17_d_is_a_density_and_may_exceed_one) {
  EXPECT_NEAR(distribution({0, 0, 1}, 0.01, 1, 1).x, 1 / (M_PI * 1e-4), 0.5);
}

TEST_F(Errata, row42_18_no_light_passes_through_backfaces) {
  const Material metal = gltf(glm::vec3(1.0f), 1.0f, 0.5f);
  for (const double below : {-1e-6, -0.3, -1.0})
    EXPECT_EQ(evaluate(metal, direction(0.4, 0), direction(-below, 1) * glm::dvec3(1, 1, -1)),
              glm::vec4(0.0f));
}

TEST_F(Errata, row42_21_light_falls_off_with_the_square_of_the_distance) {
  Task task = sceneTask(2, &gpu::TraceParams::sphereCount, {glm::vec4(0, 0, -5, 1)});
  // A point light of 10 cd; a spot whose edge lies between cosines 0.8 and 0.9; a directional light of 3 lx.
  const float scale = 1 / (0.9f - 0.8f);
  const Rows lights = {{0, 2, 0, float(gpu::LIGHT_POINT)},
                       {10, 10, 10, 0},
                       {},
                       {},
                       {0, 2, 0, float(gpu::LIGHT_SPOT)},
                       {10, 10, 10, scale},
                       {0, -1, 0, -0.8f * scale},
                       {},
                       {0, 1, 0, float(gpu::LIGHT_DIRECTIONAL)},
                       {3, 3, 3, 0},
                       {},
                       {}};
  task.scene.insert(task.scene.end(), lights.begin(), lights.end());
  task.rowsIn = 1, task.rowsOut = 2;
  const double tangent = std::sqrt(1 - 0.85 * 0.85) / 0.85;
  const Rows points = {{0, 0, 0, 0}, {0, -2, 0, 0}, {0, 1, 0, 1}, {float(tangent), 1, 0, 1},
                       {3, 2, 0, 1}, {9, 9, 9, 2}};
  const Rows answers = run(sceneKernel, task, points);
  EXPECT_NEAR(answers[1].x, 10.0 / 4, 1e-5);
  EXPECT_NEAR(answers[3].x, 10.0 / 16, 1e-5);
  EXPECT_NEAR(answers[2].w, 4.0, 4e-6) << "distance of the second point";
  EXPECT_NEAR(answers[5].x, 10.0, 1e-4) << "on the spot's axis";
  EXPECT_NEAR(answers[7].x, 10.0 * 0.85 * 0.85 * 0.25, 1e-3) << "half way through the spot's edge";
  EXPECT_EQ(answers[9].x, 0.0f) << "beside the spot";
  EXPECT_EQ(answers[11].x, 3.0f) << "directional";
  EXPECT_TRUE(missed(answers[10].w)) << "infinitely far";
}

}  // namespace
}  // namespace steradian::kernel
