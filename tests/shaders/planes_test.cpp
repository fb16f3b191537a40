// SPDX-License-Identifier: MIT
// Infinite planes: sign, far points, the horizon.
#include <cmath>
#include <cstdint>

#include "tests/shaders/oracle.hpp"
#include "tests/shaders/scene_rows.hpp"

namespace steradian::kernel {
namespace {

const Task planeTask{.operation = 2, .rowsIn = 5};

class Planes : public KernelTest {};

void pushPlane(Rows& rows, glm::dvec3 o, glm::dvec3 d, glm::vec4 plane, bool self = false) {
  rows.insert(rows.end(), {glm::vec4(glm::vec3(o), self), glm::vec4(glm::vec3(d), 0), plane, {}, {}});
}

TEST_F(Planes, row06_the_floor_is_below_and_not_behind) {
  Rows rays;
  pushPlane(rays, {0, 1, 0}, {0, -1, 0}, {0, 1, 0, 0});
  pushPlane(rays, {0, 1, 0}, {0, 1, 0}, {0, 1, 0, 0});
  pushPlane(rays, {0, -2, 0}, {0, 1, 0}, {0, 1, 0, 0});
  pushPlane(rays, {0, 1, 0}, {1, 0, 0}, {0, 1, 0, 0});
  pushPlane(rays, {0, 0, 0}, {1, 0, 0}, {0, 1, 0, 0});
  const Rows answers = run(shapes, planeTask, rays);
  EXPECT_FLOAT_EQ(answers[0].x, 1.0f);
  EXPECT_TRUE(missed(answers[1].x)) << "away from it";
  EXPECT_FLOAT_EQ(answers[2].x, 2.0f) << "planes have two sides";
  EXPECT_TRUE(missed(answers[3].x)) << "parallel";
  EXPECT_TRUE(missed(answers[4].x)) << "parallel and inside";
  measured("relative error of t", std::fabs(double(answers[0].x) - 1), 4 * ulp(1.0));
}

TEST_F(Planes, row06_planes_a_million_metres_away_keep_six_digits) {
  Random random(6);
  Rows rays;
  std::vector<oracle::Real> truth;
  while (truth.size() < 1 << 16) {
    const glm::vec3 n(random.direction()), d(random.direction());
    const glm::dvec3 point = random.direction() * 1e6;
    const oracle::Real offset = glm::dot(oracle::Vec(n), oracle::Vec(point)),
                       slope = glm::dot(oracle::Vec(n), oracle::Vec(d));
    if (std::fabs(slope) < 0.1 || offset / slope < 1e5) continue;
    truth.push_back(offset / slope);
    pushPlane(rays, {0, 0, 0}, glm::dvec3(d), {n, float(offset)});
  }
  const Rows answers = run(shapes, planeTask, rays);
  double worst = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ASSERT_NEAR(double(answers[i].x / truth[i]), 1.0, 1e-6) << i;
    worst = std::max(worst, std::fabs(double(answers[i].x / truth[i]) - 1));
  }
  measured("relative error of t", worst, 1e-6);
}

TEST_F(Planes, row07_the_floor_reaches_the_horizon) {
  Rows rays;
  Random random(7);
  for (int i = 0; i < 1 << 16; ++i) {
    const double down = random.decades(-3, 0) * M_PI / 180, turn = random.uniform(0, 2 * M_PI);
    rays.emplace_back(0, 0, 0, 0);
    rays.emplace_back(std::cos(down) * std::cos(turn), -std::sin(down), std::cos(down) * std::sin(turn), 0);
  }
  const glm::vec4 floor(0, 1, 0, -1.7f);
  const Rows answers = run(sceneKernel, sceneTask(0, &gpu::TraceParams::planeCount, {floor}), rays);
  double worst = 0, worstHeight = 0;
  for (std::size_t i = 0; i < rays.size() / 2; ++i) {
    const double truth = double(floor.w) / double(rays[2 * i + 1].y);
    ASSERT_NEAR(answers[3 * i].x / truth, 1.0, 1e-6);
    ASSERT_NEAR(answers[3 * i + 1].y, floor.w, ulp(1.7)) << "put back onto the plane";
    worst = std::max(worst, std::fabs(answers[3 * i].x / truth - 1));
    worstHeight = std::max(worstHeight, std::fabs(double(answers[3 * i + 1].y) - double(floor.w)));
  }
  measured("relative error of t", worst, 1e-6);
  measured("height of the hit above the plane, metres", worstHeight, ulp(1.7));
}

}  // namespace
}  // namespace steradian::kernel
