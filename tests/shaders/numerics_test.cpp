// SPDX-License-Identifier: MIT
// The arithmetic that everything else stands on: exact sums, compensated film, frames, sines.
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

struct Film {
  glm::dvec3 exact{0.0};
  Rows state = Rows(3, glm::vec4(0.0f));  // sum, carry, (begin, -, -, plain sum)
};

/// The film's sums after `count` more samples, beside the exact ones; at most 25,000 additions per dispatch.
template <class Run>
void accumulate(Film& film, std::uint32_t count, Run run) {
  const std::uint32_t begin = std::uint32_t(film.state[2].x);
  for (std::uint32_t n = begin; n < begin + count; ++n)
    film.exact += glm::dvec3(double(0.1f), n % 100 == 99 ? 1e4 : 0.5, double(n & 1023u) / 1024.0);
  const Rows after = run(film.state, pushBytes(count));
  film.state = {after[0], after[1], glm::vec4(begin + count, 0, 0, after[0].w)};
  film.state[0].w = 0.0f;
}

TEST_F(Numerics, row18_sixty_thousand_additions_keep_seven_digits) {
  Film film;
  accumulate(film, 60000, [](const Rows& rows, std::vector<std::byte> push) {
    return run(numerics, {.operation = 1, .rowsIn = 3, .rowsOut = 2, .push = std::move(push)}, rows);
  });
  EXPECT_NEAR(film.state[0].x / film.exact.x, 1.0, 1e-7);
  measured("relative error of the sum", std::fabs(film.state[0].x / film.exact.x - 1.0), 1e-7);
  EXPECT_GT(std::fabs(film.state[2].w / film.exact.x - 1.0), 1e-4) << "the plain sum should drift";
}

TEST_F(Numerics, row36_a_million_samples_accumulate_to_six_digits) {
  Film film;
  for (int block = 0; block < 40; ++block)
    accumulate(film, 25000, [](const Rows& rows, std::vector<std::byte> push) {
      return run(numerics, {.operation = 1, .rowsIn = 3, .rowsOut = 2, .push = std::move(push)}, rows);
    });
  ASSERT_EQ(film.state[2].x, 1e6f);
  EXPECT_NEAR(film.state[0].x / film.exact.x, 1.0, 1e-6);
  EXPECT_NEAR(film.state[0].y / film.exact.y, 1.0, 1e-6);
  EXPECT_NEAR(film.state[0].z / film.exact.z, 1.0, 1e-6);
  for (int c = 0; c < 3; ++c)
    measured("relative error of the sum", std::fabs(film.state[0][c] / film.exact[c] - 1.0), 1e-6);
  EXPECT_GT(std::fabs(film.state[2].w / film.exact.x - 1.0), 1e-3) << "the plain sum should drift";
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

TEST_F(Numerics, infinities_and_nan_are_seen_by_their_bits) {
  const Rows rows = {
      {1, 0, 0, 0}, {INFINITY, 0, 0, 0}, {-INFINITY, 0, 0, 0}, {NAN, 0, 0, 0}, {3e38, 0, 0, 0}};
  const Rows answers = run(numerics, {.operation = 5}, rows);
  const float finite[] = {1, 0, 0, 0, 1};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(answers[i].x, finite[i]) << i;
    EXPECT_EQ(answers[i].y, finite[i]) << i;
  }
  EXPECT_EQ(answers[0].z, 3.0f);
  EXPECT_NEAR(answers[0].w, 1.0f, 1e-6);
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
