// SPDX-License-Identifier: MIT
// Spheres: small and far, planet-sized, from inside, along the rim, and never hit by their own rays.
#include <cmath>
#include <cstdint>
#include <functional>

#include "tests/shaders/oracle.hpp"
#include "tests/shaders/scene_rows.hpp"

namespace steradian::kernel {
namespace {

const Task sphereTask{.operation = 0, .rowsIn = 5};
const Task largeSphereTask{.operation = 1, .rowsIn = 5};

class Spheres : public KernelTest {};

void pushSphere(Rows& rows, glm::dvec3 o, glm::dvec3 d, glm::vec4 row0, glm::vec4 row1 = {},
                bool self = false) {
  rows.insert(rows.end(),
              {glm::vec4(glm::vec3(o), self), glm::vec4(glm::vec3(d), 0), row0, row1, glm::vec4(0)});
}

struct Quality {
  double wrong = 0.0;        // false hits and false misses, share of all rays
  double normalDegrees = 0;  // mean error
};

/// Rays through a disc of 1.2 radii around a unit sphere that is `distance` away.
Quality farSphere(double distance, const std::function<Rows(const Task&, const Rows&)>& run) {
  Random random(1);
  const glm::vec3 centre(random.direction() * distance);
  const oracle::Vec exactCentre(centre);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(centre)),
                   side = glm::normalize(cross(axis, {0.3, 0.5, 0.8}));
  Rows rays;
  for (int i = 0; i < 1 << 18; ++i) {
    const double r = 1.2 * std::sqrt(random.uniform()), phi = random.uniform(0, 2 * M_PI);
    const glm::vec3 o(glm::dvec3(random.uniform(), random.uniform(), random.uniform()));
    const glm::dvec3 target =
        glm::dvec3(centre) + r * (std::cos(phi) * side + std::sin(phi) * cross(axis, side));
    rays.emplace_back(o, 0);
    rays.emplace_back(glm::vec3(glm::normalize(target - glm::dvec3(o))), 0);
  }
  const Rows answers = run(sceneTask(0, &gpu::TraceParams::sphereCount, {glm::vec4(centre, 1)}), rays);
  Quality quality;
  int both = 0;
  for (std::size_t i = 0; i < rays.size() / 2; ++i) {
    const oracle::Vec o(xyz(rays[2 * i])), d(xyz(rays[2 * i + 1]));
    const auto t = oracle::nearest(oracle::sphere(o, d, exactCentre, 1));
    const bool hit = !missed(answers[3 * i].x);
    quality.wrong += t.has_value() != hit;
    if (!t || !hit) continue;
    const oracle::Vec normal = glm::normalize(o + d * *t - exactCentre), seen(xyz(answers[3 * i + 2]));
    quality.normalDegrees += 180.0 / M_PI * double(glm::length(glm::cross(normal, glm::normalize(seen))));
    ++both;
  }
  quality.wrong /= double(rays.size() / 2);
  quality.normalDegrees /= both;
  return quality;
}

TEST_F(Spheres, row01_small_far_spheres_keep_their_outline_and_normals) {
  for (const double distance : {1e2, 1e3, 4e3, 1e4}) {
    const Quality quality =
        farSphere(distance, [](const Task& task, const Rows& rays) { return run(sceneKernel, task, rays); });
    EXPECT_LE(quality.wrong, 2e-4) << "at " << distance;
    EXPECT_LE(quality.normalDegrees, 0.05) << "at " << distance;
    measured("share of false hits and misses", quality.wrong, 2e-4);
    measured("mean error of the normals, degrees", quality.normalDegrees, 0.05);
  }
}

TEST_F(Spheres, row02_radii_other_than_one) {
  Rows rays;
  for (const float radius : {0.5f, 2.0f}) pushSphere(rays, {0, 0, 5}, {0, 0, -1}, {0, 0, 0, radius});
  const Rows answers = run(shapes, sphereTask, rays);
  EXPECT_NEAR(answers[0].x, 4.5, 4.5e-6);
  EXPECT_NEAR(answers[1].x, 3.0, 3e-6);
  measured("relative error of t", std::fabs(double(answers[0].x) / 4.5 - 1), 1e-6);
  measured("relative error of t", std::fabs(double(answers[1].x) / 3.0 - 1), 1e-6);
}

struct Planet {
  glm::dvec3 centre;
  double radius;
  glm::vec4 high, low;
};

/// The ground 1.7 m below the origin, as the host stores it.
Planet planet(double radius) {
  Planet p{{0.3, -radius - 1.7, -0.2}, radius, {}, {}};
  p.high = glm::vec4(glm::vec3(p.centre), float(radius));
  p.low = glm::vec4(glm::vec3(p.centre - xyz(p.high)), float(radius - double(p.high.w)));
  return p;
}

TEST_F(Spheres, row03_planet_sized_spheres_carry_an_eye_at_1_7_metres) {
  for (const double radius : {1e5, 1e6, 1e7}) {
    const Planet ground = planet(radius);
    Random random(3);
    Rows rays;
    for (int i = 0; i < 1 << 16; ++i) {
      const double down = random.uniform(5, 60) * M_PI / 180, turn = random.uniform(0, 2 * M_PI);
      const glm::dvec3 d(std::cos(down) * std::cos(turn), -std::sin(down), std::cos(down) * std::sin(turn));
      rays.insert(rays.end(), {glm::vec4(0), glm::vec4(glm::vec3(d), 0)});
    }
    const Task task = sceneTask(0, &gpu::TraceParams::largeSphereCount, {ground.high, ground.low});
    const Rows answers = run(sceneKernel, task, rays);
    double worst = 0, worstHeight = 0;
    for (std::size_t i = 0; i < rays.size() / 2; ++i) {
      const oracle::Vec d(xyz(rays[2 * i + 1]));
      const auto t = oracle::nearest(oracle::sphere({0, 0, 0}, d, ground.centre, ground.radius));
      ASSERT_TRUE(t && answers[3 * i].y == 0.0f);
      worst = std::max(worst, std::fabs(double(answers[3 * i].x / *t - 1)));
      const oracle::Vec p(xyz(answers[3 * i + 1]));
      worstHeight = std::max(
          worstHeight, std::fabs(double(glm::length(p - oracle::Vec(ground.centre)) - oracle::Real(radius))));
    }
    EXPECT_LE(worst, 1e-6) << "R = " << radius;
    EXPECT_LE(worstHeight, ulp(20.0)) << "put back onto the surface, R = " << radius;
    measured("relative error of t", worst, 1e-6);
    measured("height of the hit above the ground, metres", worstHeight, ulp(20.0));
  }
}

TEST_F(Spheres, row04_from_inside_the_far_side_is_hit) {
  Random random(4);
  Rows rays;
  for (int i = 0; i < 1 << 16; ++i) {
    const double radius = random.decades(-2, 4);
    const glm::dvec3 centre(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const glm::dvec3 o = centre + random.direction() * radius * random.uniform(0, 0.99);
    pushSphere(rays, o, random.direction(), {glm::vec3(centre), float(radius)});
  }
  const Rows answers = run(shapes, sphereTask, rays);
  double worst = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const glm::vec4 s = rays[5 * i + 2];
    const auto t = oracle::nearest(
        oracle::sphere(oracle::Vec(xyz(rays[5 * i])), oracle::Vec(xyz(rays[5 * i + 1])), xyz(s), s.w));
    if (!t) continue;  // rounding put the eye outside
    ASSERT_NEAR(answers[i].x / double(*t), 1.0, 1e-5) << i;
    worst = std::max(worst, std::fabs(answers[i].x / double(*t) - 1.0));
  }
  measured("relative error of t", worst, 1e-5);
}

TEST_F(Spheres, row04_rays_along_the_rim_end_on_the_sphere_and_never_in_nan) {
  Random random(41);
  Rows rays;
  for (int i = 0; i < 1 << 16; ++i) {
    const double impact = i % 2 ? 0.999999 : 1.0 + random.uniform(-2e-6, 2e-6);
    const glm::dvec3 d = random.direction(), side = glm::normalize(cross(d, random.direction()));
    pushSphere(rays, side * impact - d * 5.0, d, {0, 0, 0, 1});
  }
  const Rows answers = run(shapes, sphereTask, rays);
  double worstHeight = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    ASSERT_FALSE(std::isnan(answers[i].x));
    if (missed(answers[i].x)) continue;
    const glm::dvec3 p = xyz(rays[5 * i]) + xyz(rays[5 * i + 1]) * double(answers[i].x);
    worstHeight = std::max(worstHeight, std::fabs(length(p) - 1.0));
  }
  EXPECT_LE(worstHeight, 1e-5);
  measured("height of the hit above the sphere, radii", worstHeight, 1e-5);
}

/// Rays at one sphere from inside (even numbers) and from outside (odd ones), aimed everywhere.
Rows raysAround(const glm::dvec3& centre, double radius, int count) {
  Random random(5);
  Rows rays;
  for (int i = 0; i < count; ++i) {
    const double from = i % 2 ? random.uniform(1.5, 5) : random.uniform(0, 0.9);
    const glm::vec3 o(centre + random.direction() * radius * from);
    const glm::dvec3 target = centre + random.direction() * radius * random.uniform(0, 1);
    rays.insert(rays.end(),
                {glm::vec4(o, 0), glm::vec4(glm::vec3(glm::normalize(target - glm::dvec3(o))), 0)});
  }
  return rays;
}

/// The host stores spheres from 100 m on as double-floats.
Task bounceTask(const glm::dvec3& centre, double radius) {
  const glm::vec4 high{glm::vec3(centre), float(radius)};
  const glm::vec4 low{glm::vec3(centre - xyz(high)), float(radius - double(high.w))};
  if (radius >= 100.0) return sceneTask(1, &gpu::TraceParams::largeSphereCount, {high, low});
  return sceneTask(1, &gpu::TraceParams::sphereCount, {high});
}

TEST_F(Spheres, row05_no_sphere_hits_itself_and_no_inside_ray_escapes) {
  constexpr int count = 100000;
  int hits = 0;
  for (const double radius : {1e-3, 1e-1, 1e1, 1e3, 1e6})
    for (const double far : {0.0, 1.0, 1e4, 1e6}) {
      const glm::dvec3 centre = Random(std::uint64_t(far) + 1).direction() * far;
      int selfHits = 0, leaks = 0;
      for (const glm::vec4 answer :
           run(sceneKernel, bounceTask(centre, radius), raysAround(centre, radius, count))) {
        if (missed(answer.x)) continue;
        ++hits;
        selfHits += answer.z == 0.0f && !missed(answer.y);
        leaks += answer.z == 1.0f && missed(answer.y);
      }
      EXPECT_EQ(selfHits, 0) << "R = " << radius << ", centre at " << far;
      EXPECT_EQ(leaks, 0) << "R = " << radius << ", centre at " << far;
      measured("self hits and leaks of 100,000 rays", selfHits + leaks, 0);
    }
  EXPECT_GT(hits, 10 * count);
}

TEST_F(Spheres, row05_the_ground_does_not_hit_itself) {
  for (const double radius : {1e5, 1e6, 1e7}) {
    const Planet ground = planet(radius);
    Random random(51);
    Rows rays;
    for (int i = 0; i < 100000; ++i) {
      const double down = random.decades(-1, 1.9) * M_PI / 180, turn = random.uniform(0, 2 * M_PI);
      const glm::dvec3 d(std::cos(down) * std::cos(turn), -std::sin(down), std::cos(down) * std::sin(turn));
      rays.insert(rays.end(), {glm::vec4(0), glm::vec4(glm::vec3(d), 0)});
    }
    const Task task = sceneTask(1, &gpu::TraceParams::largeSphereCount, {ground.high, ground.low});
    int selfHits = 0;
    for (const glm::vec4 answer : run(sceneKernel, task, rays))
      selfHits += !missed(answer.x) && !missed(answer.y);
    EXPECT_EQ(selfHits, 0) << "R = " << radius;
    measured("self hits of 100,000 rays", selfHits, 0);
  }
}

}  // namespace
}  // namespace steradian::kernel
