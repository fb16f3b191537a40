// SPDX-License-Identifier: MIT
// Sums without rounding.
#include "editor/part/exact_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

using namespace steradian;

namespace {

std::vector<float> randomFloats(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<float> out;
  while (out.size() < count) {
    const std::uint32_t bits = random();
    float v;
    std::memcpy(&v, &bits, 4);
    if (std::isfinite(v) && std::abs(v) < 1e30f) out.push_back(v);
  }
  return out;
}

std::vector<float> floatsOf(ExactSum sum) {
  std::vector<float> floats;
  for (float taken; (taken = takeFloat(sum)) != 0.0f;) floats.push_back(taken);
  return floats;
}

}  // namespace

TEST(ExactSum, does_not_depend_on_the_order_even_over_the_whole_range_of_floats) {
  std::vector<float> terms = randomFloats(300, 1);
  std::vector<float> expected;
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    ExactSum sum;
    for (const float t : terms) sum.add(t);
    if (i == 0) expected = floatsOf(sum);
    ASSERT_EQ(floatsOf(sum), expected);
    std::shuffle(terms.begin(), terms.end(), random);
  }
  EXPECT_LE(expected.size(), 13u);
}

TEST(ExactSum, keeps_what_doubles_lose) {
  ExactSum sum;
  for (const double t : {1e300, 1.0, 1e-300, -1e300, -1.0}) sum.add(t);
  EXPECT_EQ(sum.rounded(), 1e-300);
}

TEST(ExactSum, rounds_ties_to_even_unless_something_lies_below) {
  ExactSum tie;
  tie.add(1.0);
  tie.add(0x1p-53);
  EXPECT_EQ(tie.rounded(), 1.0);
  tie.add(0x1p-200);
  EXPECT_EQ(tie.rounded(), 1.0 + 0x1p-52);
  tie.add(-0x1p-199);
  EXPECT_EQ(tie.rounded(), 1.0);
}

TEST(ExactSum, agrees_with_quadruple_precision) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    ExactSum sum;
    __float128 exact = 0;  // 113 bits hold these terms' sum
    for (int i = 0; i < 40; ++i) {
      const double term = std::ldexp(double(int(random() >> 8)) - 0x1p23, -int(random() % 60));
      sum.add(term);
      exact += term;
    }
    EXPECT_EQ(sum.rounded(), double(exact));
  }
}

TEST(ExactSum, its_floats_say_it_exactly_and_in_one_way) {
  ExactSum a, b;
  for (const float v : {0.1f, 3e10f, -7e-20f}) a.add(v);
  for (const float v : floatsOf(a)) b.add(v);
  EXPECT_EQ(floatsOf(a), floatsOf(b));
  ExactSum nothing;
  EXPECT_EQ(takeFloat(nothing), 0.0f);
}
