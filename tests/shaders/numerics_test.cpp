// SPDX-License-Identifier: MIT
// The arithmetic that everything else stands on: exact sums, frames, sines.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "shaders/kernel_numerics.comp.h"
#include "tests/shaders/kernel.hpp"

namespace steradian::kernel {
namespace {

const Kernel numerics{kernel_numerics_spirv, "numerics"};

class Numerics : public KernelTest {};

Rows randomPairs(double low, double high) {
  Random random(18);
  Rows rows;
  for (int i = 0; i < 1 << 16; ++i) {
    const double sign = random.uniform() < 0.5 ? -1.0 : 1.0;
    rows.emplace_back(random.decades(low, high), sign * random.decades(low, high), 0, 0);
  }
  return rows;
}

TEST_F(Numerics, row18_sums_and_products_of_two_floats_are_exact) {
  const Rows pairs = randomPairs(-6, 6);
  const Rows answers = run(numerics, {.operation = 0}, pairs);
  int wrongSums = 0, wrongProducts = 0, carries = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    using Exact = long double;  // 64 bits of mantissa hold both results
    const Exact a = pairs[i].x, b = pairs[i].y;
    wrongSums += Exact(answers[i].x) + Exact(answers[i].y) != a + b;
    wrongProducts += Exact(answers[i].z) + Exact(answers[i].w) != a * b;
    carries += answers[i].y != 0.0f && answers[i].w != 0.0f;
  }
  EXPECT_EQ(wrongSums, 0);
  EXPECT_EQ(wrongProducts, 0);
  measured("inexact sums and products of 65,536 pairs", wrongSums + wrongProducts, 0);
  EXPECT_GT(carries, 10000) << "low parts were optimized away";
}

TEST_F(Numerics, row18_double_floats_keep_46_bits) {
  Random random(181);
  Rows rows;
  for (int i = 0; i < 1 << 14; ++i) {
    const float a = float(random.decades(-3, 6)), b = float(random.decades(-3, 6));
    rows.emplace_back(a, a * random.uniform(-3e-8, 3e-8), b, b * random.uniform(-3e-8, 3e-8));
  }
  const Rows answers = run(numerics, {.operation = 3}, rows);
  double worst = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double a = double(rows[i].x) + double(rows[i].y), b = double(rows[i].z) + double(rows[i].w);
    ASSERT_NEAR(double(answers[i].x) + double(answers[i].y), a + b, (a + b) * 0x1p-45);
    ASSERT_NEAR(double(answers[i].z) + double(answers[i].w), a * a, a * a * 0x1p-45);
    worst = std::max({worst, std::fabs((double(answers[i].x) + double(answers[i].y)) / (a + b) - 1),
                      std::fabs((double(answers[i].z) + double(answers[i].w)) / (a * a) - 1)});
  }
  measured("relative error of double-floats", worst, 0x1p-45);
}

TEST_F(Numerics, frames_are_orthonormal_around_every_direction) {
  Random random(219);
  Rows normals = {{0, 0, 1, 0}, {0, 0, -1, 0}, {1e-8, 0, -1, 0}, {0, 1e-4, -1, 0}, {1, 0, -0.0, 0}};
  for (int i = 0; i < 1 << 16; ++i) {
    glm::dvec3 n = random.direction();
    if (i % 2) n = glm::normalize(glm::dvec3(n.x * 1e-3, n.y * 1e-3, -1.0));
    normals.emplace_back(glm::vec3(n), 0);
  }
  const Rows answers = run(numerics, {.operation = 2, .rowsOut = 3}, normals);
  double worst = 0.0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const glm::dvec3 t = xyz(answers[3 * i]), b = xyz(answers[3 * i + 1]), n = xyz(normals[i]);
    worst = std::max({worst, std::fabs(dot(t, t) - 1), std::fabs(dot(b, b) - 1), std::fabs(dot(t, b)),
                      std::fabs(dot(t, n)), std::fabs(dot(b, n))});
    worst = std::max(worst, length(xyz(answers[3 * i + 2]) - glm::dvec3(0.6, 0.0, 0.8)));
  }
  EXPECT_LT(worst, 1e-6);
}

TEST_F(Numerics, white_has_luminance_one) {
  const Rows answers = run(numerics, {.operation = 5}, {{0, 0, 0, 0}});
  EXPECT_EQ(answers[0].x, 3.0f);
  EXPECT_NEAR(answers[0].y, 1.0f, 1e-6);
}

TEST_F(Numerics, row17_sine_and_cosine_of_an_azimuth_are_as_good_as_vulkan_promises) {
  Rows rows;
  for (int i = 0; i < 1 << 16; ++i) rows.emplace_back(i / 65536.0f, 0, 0, 0);
  const Rows answers = run(numerics, {.operation = 4}, rows);
  const double promised = 0x1p-11;
  double worst = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double angle = 2.0 * M_PI * double(rows[i].x);
    ASSERT_NEAR(answers[i].x, std::sin(angle), promised);
    ASSERT_NEAR(answers[i].y, std::cos(angle), promised);
    worst = std::max({worst, std::fabs(double(answers[i].x) - std::sin(angle)),
                      std::fabs(double(answers[i].y) - std::cos(angle))});
  }
  measured("error of sine and cosine", worst, promised);
}

TEST_F(Numerics, row17_no_inverse_trigonometry_and_no_pow_in_the_path_tracer) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(STERADIAN_SHADER_SOURCES)) {
    if (entry.path().extension() != ".glsl" && entry.path().extension() != ".comp") continue;
    if (entry.path().stem() == "display") continue;  // behind the tracer, once per pixel: sRGB is a power
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const std::string source = text.str();
    ++files;
    for (const char* call : {"acos(", "asin(", "atan(", " pow(", "(pow("}) {
      EXPECT_EQ(source.find(call), std::string::npos) << call << " in " << entry.path();
      measured("forbidden calls in a file", source.find(call) != std::string::npos, 0);
    }
  }
  EXPECT_GT(files, 10);
}

}  // namespace
}  // namespace steradian::kernel
