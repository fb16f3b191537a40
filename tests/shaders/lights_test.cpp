// SPDX-License-Identifier: MIT
// Lights of non-zero size: solid angles, irradiances, and densities that say what the samples do.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <iostream>
#include <numbers>

#include "tests/shaders/light_samples.hpp"

namespace steradian::kernel {
namespace {

/// Lights, each looked at from a point of its own with some numbers.
struct Batch {
  Rows scene, questions;
  std::vector<vec3> points;

  void add(const Rows& light, const vec3& p, Random& random, int samples = 1) {
    scene.insert(scene.end(), light.begin(), light.end());
    for (int i = 0; i < samples; ++i) {
      questions.emplace_back(p, float(points.size()));
      questions.emplace_back(random.uniform(), random.uniform(), 0, 0);
    }
    points.push_back(p);
  }
  Rows light(std::size_t i) const {
    const auto first = scene.begin() + std::ptrdiff_t(i * gpu::LIGHT_ROWS);
    return Rows(first, first + std::ptrdiff_t(gpu::LIGHT_ROWS));
  }
};

const double sphereDistances[] = {1.0001, 1.01, 1.5, 2, 10, 100, 1e3, 4e3, 1e4, 1e5};

TEST_F(Lights, row28_a_sphere_is_sampled_over_exactly_the_solid_angle_that_it_fills) {
  Random random(28);
  for (const double ratio : sphereDistances) {
    Batch batch;
    for (int i = 0; i < 100; ++i) {
      const float radius = float(random.decades(-2, 2));
      const vec3 p(random.direction() * double(radius));
      batch.add(sphereLight(p + vec3(random.direction() * ratio * double(radius)), 3, radius), p, random);
    }
    const auto samples = ask(batch.scene, batch.questions);
    double worst = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Sample& s = samples[i];
      const Rows light = batch.light(i);
      const Vec f = Vec(xyz(light[0])) - Vec(batch.points[i]);
      const Real s2 = Real(light[1].w) * light[1].w / glm::dot(f, f);
      const Real solidAngle = 2 * pi * s2 / (1 + std::sqrt(1 - s2));
      worst = std::max(worst, std::fabs(double(s.pdf * solidAngle - 1)));
      EXPECT_NEAR(s.pdf / s.askedPdf, 1.0, 1e-6);  // a GPU may contract one of the two
      EXPECT_EQ(s.primitive, testPrimitive);
      EXPECT_NEAR(s.illuminance * s.pdf, 3, 1e-6);
    }
    EXPECT_LE(worst, 1e-5) << "distance / radius " << ratio;
    measured("error of density x solid angle", worst, 1e-5);
  }
}

TEST_F(Lights, row28_its_irradiance_falls_with_the_square_of_the_distance) {
  for (const double ratio : sphereDistances) {
    const vec3 p(0.3f, -0.2f, 0.5f), centre = p + vec3(dvec3(2, 3, 6) / 7.0 * ratio);
    const dvec3 axis = glm::normalize(dvec3(centre) - dvec3(p));
    const double d2 = glm::dot(dvec3(centre) - dvec3(p), dvec3(centre) - dvec3(p));
    const auto samples = draw(sphereLight(centre, 1, 1), p, 1 << 18);
    const Estimate e =
        estimate(samples, [&](const Sample& s) { return s.illuminance * glm::dot(s.wi, axis); });
    EXPECT_NEAR(e.mean, M_PI / d2, 3 * e.sigma + 1e-6 * M_PI / d2) << ratio;
    measured("relative error of the irradiance", std::fabs(e.mean * d2 / M_PI - 1),
             3 * e.sigma * d2 / M_PI + 1e-6);
    for (const Sample& s : samples) {
      const double miss = glm::length(dvec3(p) + s.wi * s.distance - dvec3(centre)) - 1.0;
      ASSERT_NEAR(miss, 0, 4e-7 * ratio + 1e-5) << ratio;
      ASSERT_LE(s.distance, std::sqrt(d2) * (1 + 1e-6)) << "the near side";
    }
  }
}

TEST_F(Lights, row28_from_inside_a_sphere_all_directions_are_sampled) {
  const vec3 centre(5, 6, 7), p = centre + vec3(0.3f, -1.2f, 0.4f);
  const auto samples = draw(sphereLight(centre, 1, 2), p, 1 << 18);
  const Estimate up =
      estimate(samples, [](const Sample& s) { return s.illuminance * std::max(s.wi.y, 0.0); });
  EXPECT_NEAR(up.mean, M_PI, 3 * up.sigma);
  measured("relative error of the irradiance", std::fabs(up.mean / M_PI - 1), 3 * up.sigma / M_PI);
  for (const Sample& s : samples) {
    ASSERT_NEAR(glm::length(dvec3(p) + s.wi * s.distance - dvec3(centre)), 2.0, 1e-5);
    ASSERT_FLOAT_EQ(float(s.pdf), float(0.25 / M_PI));
    ASSERT_EQ(s.pdf, s.askedPdf);
  }
  EXPECT_TRUE(std::isfinite(draw(sphereLight(centre, 1, 2), centre, 1)[0].wi.x)) << "at the centre";
}

TEST_F(Lights, row28_a_point_on_the_sphere_itself_is_never_lit_from_outside) {
  Random random(281);
  Batch batch;
  std::vector<dvec3> normals;
  constexpr int each = 64;
  for (int i = 0; i < 200; ++i) {
    const float radius = float(random.decades(-1, 3));
    const vec3 centre(random.direction() * random.decades(-1, 3));
    normals.push_back(random.direction());
    batch.add(sphereLight(centre, 1, radius), vec3(dvec3(centre) + normals.back() * double(radius)), random,
              each);
  }
  const auto samples = ask(batch.scene, batch.questions);
  double worst = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_LE(glm::dot(samples[i].wi, normals[i / each]), 0.01) << "radius " << batch.light(i / each)[1].w;
    worst = std::max(worst, glm::dot(samples[i].wi, normals[i / each]));
  }
  measured("largest cosine to the normal", worst, 0.01);
}

TEST_F(Lights, row29_a_rect_is_sampled_over_exactly_the_solid_angle_that_it_fills) {
  Random random(29);
  for (const double size : {10.0, 1.0, 0.1, 0.02}) {
    Batch batch;
    for (int i = 0; i < 400; ++i) {
      const dvec3 n = random.direction(), x = across(n, random.direction()), y = glm::cross(n, x);
      const double scale = random.decades(-2, 2);
      const vec3 p(random.direction() * scale), u(x * (0.5 * size * scale)),
          v(y * (0.5 * size * scale * random.uniform(0.3, 1)));
      const dvec3 aside = x * random.uniform(-1, 1) + y * random.uniform(-1, 1);
      batch.add(flatLight(gpu::LIGHT_RECT, p - vec3((n + aside) * scale), 3, u, v), p, random);
    }
    const auto samples = ask(batch.scene, batch.questions);
    double worst = 0;
    int bySolidAngle = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Real solidAngle = SeenRect(batch.light(i), Vec(batch.points[i])).solidAngle();
      if (solidAngle < 1.01e-4 || solidAngle > 6.19) continue;
      ++bySolidAngle;
      worst = std::max(worst, std::fabs(double(samples[i].pdf * solidAngle - 1)));
      EXPECT_NEAR(samples[i].askedPdf, samples[i].pdf, 1e-6 * samples[i].pdf);
      EXPECT_NEAR(samples[i].illuminance * samples[i].pdf, 3, 1e-6);
    }
    EXPECT_GE(bySolidAngle, 100) << size;
    EXPECT_LE(worst, 2e-4) << "size / distance " << size;
    measured("relative error of the solid angle", worst, 2e-4);
    std::cout << "size / distance " << size << ": worst relative error of the solid angle " << worst << "\n";
  }
}

TEST_F(Lights, row29_small_and_wide_and_sheared_rects_fill_the_same_solid_angle_by_area) {
  const vec3 p(0.1f, 0.2f, 0.3f);
  for (const double size : {30.0, 1e-2, 1e-3, 1e-4}) {
    const Rows light = flatLight(gpu::LIGHT_RECT, p + vec3(0.2f, -0.1f, -1), 1, vec3(float(size), 0, 0),
                                 vec3(0, float(0.7 * size), 0));
    const auto samples = draw(light, p, 1 << 16);
    const Estimate e = estimate(samples, [](const Sample& s) { return 1.0 / s.pdf; });
    const double solidAngle = double(SeenRect(light, Vec(p)).solidAngle());
    EXPECT_NEAR(e.mean, solidAngle, 3 * e.sigma + 2e-4 * solidAngle) << size;
    measured("relative error of the solid angle", std::fabs(e.mean / solidAngle - 1),
             3 * e.sigma / solidAngle + 2e-4);
  }
  // Two rects that share an edge, sheared against each other, cover one rect together.
  const Rows left =
      flatLight(gpu::LIGHT_RECT, vec3(-0.25f, 0, -1), 1, vec3(0.25f, 0, 0), vec3(0.25f, 0.5f, 0));
  const Rows right = flatLight(gpu::LIGHT_RECT, vec3(-0.25f, 0, -1), 1, vec3(0.25f, 0, 0), vec3(0, 0.5f, 0));
  const Estimate sheared =
      estimate(draw(left, vec3(0), 1 << 16), [](const Sample& s) { return 1.0 / s.pdf; });
  const Real cells = 2000;
  Real expected = 0;  // by the midpoint rule over rows of the parallelogram
  for (Real y = -0.5L + 0.5L / cells; y < 0.5L; y += 1 / cells)
    for (Real x = -0.5L + 0.5L * y + 0.0025L; x < 0.5L * y; x += 0.005L)
      expected += 0.005L / cells * std::pow(1 + x * x + y * y, -1.5L);
  EXPECT_NEAR(sheared.mean, double(expected), 3 * sheared.sigma);
  EXPECT_NEAR(draw(right, vec3(0), 1)[0].pdf * double(SeenRect(right, Vec(0)).solidAngle()), 1, 1e-5);
}

TEST_F(Lights, row29_unit_rect_at_unit_height_gives_its_known_irradiance) {
  const Rows light = flatLight(gpu::LIGHT_RECT, vec3(0, 0, -1), 1, vec3(0.5f, 0, 0), vec3(0, 0.5f, 0));
  const auto samples = draw(light, vec3(0), 1 << 18);
  EXPECT_NEAR(1 / samples[0].pdf, 0.8054316832, 1e-5);
  const Estimate e = estimate(samples, [](const Sample& s) { return -s.wi.z * s.illuminance; });
  EXPECT_NEAR(e.mean, 0.7522746885, 3 * e.sigma);
  measured("error of the solid angle", std::fabs(1 / samples[0].pdf - 0.8054316832), 1e-5);
  measured("relative error of E / L", std::fabs(e.mean / 0.7522746885 - 1), 3 * e.sigma / 0.7522746885);
  EXPECT_LT(e.sigma, 2e-4);
  for (const Sample& s : samples) ASSERT_NEAR(-s.wi.z * s.distance, 1, 1e-6) << "it ends on the rect";
}

TEST_F(Lights, row29_a_disk_gives_its_known_irradiance_and_an_ellipse_its_area) {
  const Rows disk = flatLight(gpu::LIGHT_DISK, vec3(0, 0, -2), 1, vec3(1, 0, 0), vec3(0, 1, 0));
  const Estimate e =
      estimate(draw(disk, vec3(0), 1 << 18), [](const Sample& s) { return -s.wi.z * s.illuminance; });
  EXPECT_NEAR(e.mean, M_PI / 5, 3 * e.sigma);
  measured("relative error of E / L", std::fabs(e.mean * 5 / M_PI - 1), 15 * e.sigma / M_PI);
  const Rows ellipse = flatLight(gpu::LIGHT_DISK, vec3(0, 0, -1e3f), 1, vec3(2, 0, 0), vec3(1, 0.5f, 0));
  const Sample far = draw(ellipse, vec3(0), 1)[0];
  EXPECT_NEAR(1e6 / far.pdf, M_PI, 1e-4) << "conjugate semi-axes";
}

Rows randomLight(Random& random) {
  const vec3 centre(random.direction() * random.decades(-1, 1));
  const dvec3 n = random.direction(), x = across(n, random.direction()), y = glm::cross(n, x);
  const double size = random.decades(-2, 1);
  const vec3 u(x * size), v((y + x * (random.uniform() < 0.3 ? 0.5 : 0.0)) * size * random.uniform(0.2, 1));
  switch (int(random.uniform(0, 4))) {
    case 0:
      return sphereLight(centre, 2, float(size));
    case 1:
      return flatLight(gpu::LIGHT_RECT, centre, 2, u, v, true);
    case 2:
      return flatLight(gpu::LIGHT_DISK, centre, 2, u, v, true);
    default:
      return directionalLight(vec3(n), 2, random.decades(-3, -0.2));
  }
}

TEST_F(Lights, row25_a_sample_carries_the_density_that_is_stated_for_its_direction) {
  Random random(25);
  Batch batch;
  constexpr int each = 64;
  for (int i = 0; i < 800; ++i)
    batch.add(randomLight(random), vec3(random.direction() * random.decades(-1, 1)), random, each);
  const auto samples = ask(batch.scene, batch.questions);
  double worst = 0;
  int checked = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    const Rows light = batch.light(i / each);
    const bool flat = light[0].w == float(gpu::LIGHT_RECT) || light[0].w == float(gpu::LIGHT_DISK);
    const dvec3 n = flat ? glm::normalize(glm::cross(xyz(light[2]), xyz(light[3]))) : dvec3(0);
    if (flat && std::fabs(glm::dot(s.wi, n)) < 5e-3) continue;  // the plane's distance along wi is rounded
    worst = std::max(worst, std::fabs(s.askedPdf / s.pdf - 1));
    const bool sun = light[0].w == float(gpu::LIGHT_DIRECTIONAL);
    ASSERT_NEAR(s.illuminance * s.pdf, sun ? s.sunRadiance : 2.0, 2e-4 * s.illuminance * s.pdf);
    ++checked;
  }
  EXPECT_LE(worst, 1e-4);
  measured("relative difference of the two densities", worst, 1e-4);
  EXPECT_GT(checked, 40'000);
}

TEST_F(Lights, flat_lights_shine_to_their_front_only_unless_told_otherwise) {
  for (const std::uint32_t kind : {gpu::LIGHT_RECT, gpu::LIGHT_DISK})
    for (const bool bothSides : {false, true}) {
      const Rows light =
          flatLight(kind, vec3(0, 2, 0), 1, vec3(0, 0, 0.5f), vec3(0.5f, 0, 0), bothSides);  // front: +Y
      for (const Sample& s : draw(light, vec3(0.2f, 0.5f, 0.1f), 256)) {
        EXPECT_EQ(s.illuminance > 0, bothSides);
        EXPECT_EQ(s.pdf > 0, bothSides);
        EXPECT_EQ(s.askedPdf > 0, bothSides);
      }
      for (const Sample& s : draw(light, vec3(0.2f, 3.5f, 0.1f), 256)) EXPECT_GT(s.illuminance, 0);
    }
}

TEST_F(Lights, a_point_in_the_plane_of_a_flat_light_gets_nothing_infinite_from_it) {
  for (const std::uint32_t kind : {gpu::LIGHT_RECT, gpu::LIGHT_DISK})
    for (const vec3& p : {vec3(0.1f, 1, 0.2f), vec3(5, 1, 0), vec3(0, 1, 0)}) {
      const Rows light = flatLight(kind, vec3(0, 1, 0), 1, vec3(0, 0, 0.5f), vec3(0.5f, 0, 0), true);
      for (const Sample& s : draw(light, p, 4096)) {
        ASSERT_TRUE(std::isfinite(s.illuminance) && std::isfinite(s.wi.x) && std::isfinite(s.distance));
        ASSERT_LT(s.illuminance, 1e-6);
      }
    }
}

TEST_F(Lights, a_sun_has_the_radiance_of_its_disc_and_a_sharp_edge) {
  for (const double half : {0.00465, 0.05, 0.78}) {
    const dvec3 axis = glm::normalize(dvec3(0.3, 0.8, -0.4)), side = across(axis, dvec3(1, 0, 0));
    const Rows sun = directionalLight(vec3(axis), 100, half);
    Rows questions;
    for (const double share : {0.0, 0.5, 0.999, 1.001, 2.0}) {
      questions.emplace_back(0, 0, 0, 0);
      questions.emplace_back(vec3(axis * std::cos(share * half) + side * std::sin(share * half)), 0);
    }
    const Rows answers = run(lights, lightTask(4, 2, 1, sun), questions);
    const double radiance = 100 / (M_PI * std::pow(std::sin(half), 2));
    for (int i = 0; i < 5; ++i)
      EXPECT_NEAR(answers[std::size_t(i)].y, i < 3 ? radiance : 0.0, 1e-5 * radiance) << half << " " << i;
    EXPECT_NEAR(answers[0].x, 1 / (4 * M_PI * std::pow(std::sin(0.5 * half), 2)),
                1e-5 * double(answers[0].x));
    const Estimate e = estimate(draw(sun, vec3(9, 9, 9), 1 << 14),
                                [&](const Sample& s) { return s.illuminance * glm::dot(s.wi, axis); });
    EXPECT_NEAR(e.mean, 100, 3 * e.sigma + 1e-4);
    for (const Sample& s : draw(sun, vec3(0), 64)) EXPECT_GE(s.distance, 1e30);
  }
  const Sample parallel = draw(directionalLight(vec3(0, 1, 0), 5), vec3(1, 2, 3), 1)[0];
  EXPECT_EQ(parallel.pdf, 0);
  EXPECT_EQ(parallel.illuminance, 5);
  EXPECT_EQ(parallel.wi, dvec3(0, 1, 0));
}

}  // namespace
}  // namespace steradian::kernel
