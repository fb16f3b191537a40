// SPDX-License-Identifier: MIT
// Fresnel: Schlick's curve, the exact one, total internal reflection.
#include <cmath>
#include <cstdint>

#include "tests/shaders/bsdf_rows.hpp"

namespace steradian::kernel {
namespace {

const Task fresnelTask{.operation = 5};  // (exact, Schlick, pow5, -)

class Fresnel : public KernelTest {
 protected:
  /// Curves over `count` cosines in the middle of equal steps.
  static Rows curve(int count, float eta, float f0) {
    Rows rows;
    for (int i = 0; i < count; ++i) rows.emplace_back((i + 0.5f) / float(count), eta, f0, 1.0f);
    return rows;
  }
  /// Mean over the hemisphere, weighted by the cosine.
  static double mean(const Rows& questions, const Rows& answers, int component) {
    double sum = 0;
    for (std::size_t i = 0; i < questions.size(); ++i)
      sum += 2.0 * double(questions[i].x) * double(answers[i][component]);
    return sum / double(questions.size());
  }
};

TEST_F(Fresnel, row27_exact_reflectance_agrees_with_fresnel_by_angles) {
  double worst = 0;
  for (const float eta : {1.33f, 1.5f, 2.42f, 1 / 1.33f, 1 / 1.5f}) {
    const Rows rows = curve(1 << 14, eta, 0.04f);
    const Rows answers = run(bsdf, fresnelTask, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const oracle::Real truth = oracle::fresnel(rows[i].x, eta);
      // At the critical angle the curve is vertical: there the float cosine decides.
      const oracle::Real sine2 = (1 - oracle::Real(rows[i].x) * rows[i].x) / (oracle::Real(eta) * eta);
      const double gate = std::fabs(double(sine2 - 1)) < 1e-3 ? 2e-2 : 1e-5;
      ASSERT_NEAR(double(answers[i].x), double(truth), gate) << "cosine " << rows[i].x << ", eta " << eta;
      if (gate == 1e-5) worst = std::max(worst, std::fabs(double(answers[i].x - truth)));
    }
  }
  measured("error of the reflectance", worst, 1e-5);
}

TEST_F(Fresnel, row27_means_over_the_hemisphere) {
  const double table[][2] = {{1.33, .065931}, {1.5, .091778}, {2.42, .212541}};
  for (const auto& [n, expected] : table) {
    const Rows rows = curve(1 << 14, float(n), 0.04f);
    const double seen = mean(rows, run(bsdf, fresnelTask, rows), 0);
    EXPECT_NEAR(seen, expected, 1e-5) << "n = " << n;
    measured("error of the mean", std::fabs(seen - expected), 1e-5);
  }
  const Rows inside = curve(1 << 16, float(1 / 1.5), 0.04f);
  const double leaving = mean(inside, run(bsdf, fresnelTask, inside), 0);
  EXPECT_NEAR(leaving, .596346, 2e-5) << "leaving glass";
  measured("error of the mean, leaving glass", std::fabs(leaving - .596346), 2e-5);
}

TEST_F(Fresnel, row27_total_internal_reflection_is_total) {
  const Rows rows = {{0.7f, 1 / 1.5f, 0, 1}, {0.1f, 1 / 1.5f, 0, 1}, {0.0f, 1.5f, 0, 1}, {1.0f, 1.0f, 0, 1}};
  const Rows answers = run(bsdf, fresnelTask, rows);
  EXPECT_EQ(answers[0].x, 1.0f);
  EXPECT_EQ(answers[1].x, 1.0f);
  measured("what total reflection lacks", std::fabs(1.0 - double(answers[0].x)), 0);
  EXPECT_NEAR(answers[2].x, 1.0f, 1e-6) << "grazing";
  EXPECT_NEAR(answers[3].x, 0.0f, 1e-12) << "no boundary";
}

TEST_F(Fresnel, row27_schlick_stays_within_its_known_distance) {
  const Rows rows = curve(1 << 14, 1.5f, 0.04f);
  const Rows answers = run(bsdf, fresnelTask, rows);
  double worst = 0, at = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(double(answers[i].y), double(oracle::schlick(0.04L, 1, rows[i].x)), 1e-6);
    const double difference = std::fabs(double(answers[i].x - answers[i].y));
    if (difference > worst) worst = difference, at = std::acos(double(rows[i].x)) * 180 / M_PI;
  }
  EXPECT_NEAR(worst, 0.0357, 1e-4);
  measured("error of the largest difference from Schlick", std::fabs(worst - 0.0357), 1e-4);
  EXPECT_NEAR(at, 85, 1);
  EXPECT_NEAR(mean(rows, answers, 1), 0.04 + 0.96 / 21, 1e-5);
}

TEST_F(Fresnel, row17_the_fifth_power_is_good_to_four_ulp) {
  const Rows rows = curve(1 << 14, 1.5f, 0.04f);
  const Rows answers = run(bsdf, fresnelTask, rows);
  double worst = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const long double truth = std::pow((long double)rows[i].x, 5.0L);
    ASSERT_NEAR(double(answers[i].z), double(truth), 4 * ulp(double(truth)));
    worst = std::max(worst, std::fabs(double(answers[i].z - truth)) / ulp(double(truth)));
  }
  measured("error of the fifth power, ULP", worst, 4);
}

}  // namespace
}  // namespace steradian::kernel
