// SPDX-License-Identifier: MIT
// The film's fixed-point sums against integers of 128 bits.
#include <algorithm>
#include <cmath>

#include "shaders/gpu_types.h"
#include "shaders/kernel_film.comp.h"
#include "tests/shaders/kernel.hpp"

namespace steradian::kernel {
namespace {

const Kernel film{kernel_film_spirv, "film"};
constexpr std::size_t sumRows = 6;

__extension__ using Quanta = __int128;  // 2^-60 of the film's unit

/// What a film keeps of a value: 60 bits behind the point.
Quanta quantaOf(float units) {
  return Quanta(std::ldexp(double(units), 2 * gpu::FILM_DIGIT_BITS));
}

Quanta quantaOf(const glm::vec4* sum, int channel) {
  Quanta total = 0;
  for (int digit = 2; digit >= 0; --digit)
    total = total * gpu::FILM_BASE + Quanta(sum[2 * digit][channel]) * 32768 +
            Quanta(sum[2 * digit + 1][channel]);
  return total;
}

struct Additions {
  std::uint32_t additions, begin = 0;
};

class FilmSumKernel : public KernelTest {
 protected:
  /// Adds the values to a sum.
  static Rows added(Rows sum, const Rows& values) {
    sum.insert(sum.end(), values.begin(), values.end());
    return run(film,
               {.rowsIn = sum.size(),
                .rowsOut = sumRows,
                .push = pushBytes(Additions{std::uint32_t(values.size())})},
               sum);
  }
  static bool sameDigits(const Rows& a, const Rows& b) {
    return std::ranges::equal(a, b, [](glm::vec4 x, glm::vec4 y) { return xyz(x) == xyz(y); });
  }
  static inline const Rows nothing = Rows(sumRows, glm::vec4(0.0f));
};

/// 17 to -18 decades of a unit, of both signs.
Rows farApart(std::size_t count) {
  Random random(36);
  const auto value = [&] { return float((random.uniform() < 0.4 ? -1 : 1) * random.decades(-18.5, 5)); };
  Rows values;
  for (std::size_t i = 0; i < count; ++i) values.emplace_back(value(), value(), value(), 0);
  return values;
}

TEST_F(FilmSumKernel, row36_sums_are_those_of_integers) {
  const Rows values = farApart(5000);
  const Rows sum = added(nothing, values);
  int wrong = 0;
  for (int c = 0; c < 3; ++c) {
    Quanta exact = 0;
    for (const glm::vec4& value : values) exact += quantaOf(value[c]);
    wrong += quantaOf(sum.data(), c) != exact;
  }
  EXPECT_EQ(wrong, 0);
  measured("sums that are not exact", wrong, 0);
  EXPECT_EQ(sum[0].w, 0.0f) << "values were dropped";
}

TEST_F(FilmSumKernel, row36_sums_do_not_depend_on_order_and_grouping) {
  Rows values = farApart(5000);
  const Rows sum = added(nothing, values);
  const Rows grouped = added(added(nothing, Rows(values.begin(), values.begin() + 1234)),
                             Rows(values.begin() + 1234, values.end()));
  EXPECT_TRUE(sameDigits(grouped, sum));
  std::ranges::shuffle(values, std::mt19937(36));
  const Rows shuffled = added(nothing, values);
  EXPECT_TRUE(sameDigits(shuffled, sum));
  measured("sums that differ", !sameDigits(grouped, sum) + !sameDigits(shuffled, sum), 0);
}

TEST_F(FilmSumKernel, row36_a_million_samples_accumulate_exactly) {
  constexpr std::uint32_t block = 25000, samples = 1'000'000;
  Rows sum = nothing;
  for (std::uint32_t begin = 0; begin < samples; begin += block)
    sum = run(
        film,
        {.operation = 1, .rowsIn = sumRows, .rowsOut = sumRows, .push = pushBytes(Additions{block, begin})},
        sum);
  Quanta exact[3] = {};
  for (std::uint32_t n = 0; n < samples; ++n) {
    const float values[] = {0.1f, n % 100 == 99 ? 1e4f : 0.5f, float(n & 1023u) / 1024.0f};
    for (int c = 0; c < 3; ++c) exact[c] += quantaOf(values[c]);
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_TRUE(quantaOf(sum.data(), c) == exact[c]);
    measured("error of the sum, quanta", double(quantaOf(sum.data(), c) - exact[c]), 0);
  }
}

TEST_F(FilmSumKernel,
       row36_what_is_no_number_is_dropped_and_counted_and_what_is_too_bright_ends_at_the_limit) {
  const float tooLarge = float(gpu::FILM_BASE), largest = std::nextafter(tooLarge, 0.0f);
  const Rows sum = added(nothing, {{1, 2, 3, 0},
                                   {NAN, 0, 0, 0},
                                   {0, INFINITY, 0, 0},
                                   {0, 0, -INFINITY, 0},
                                   {0, 0, 1e-30f, 0},
                                   {1e30f, -tooLarge, 0, 0}});
  EXPECT_EQ(sum[0].w, 3.0f);
  measured("samples wrongly kept or dropped", std::fabs(sum[0].w - 3.0), 0);
  EXPECT_EQ(sum[1].w, 1.0f) << "the sum is full";
  EXPECT_TRUE(quantaOf(sum.data(), 0) == quantaOf(1.0f) + quantaOf(largest));
  EXPECT_TRUE(quantaOf(sum.data(), 1) == quantaOf(2.0f) - quantaOf(largest));
  EXPECT_TRUE(quantaOf(sum.data(), 2) == quantaOf(3.0f));
}

TEST_F(FilmSumKernel, row36_sums_that_do_not_fit_end_at_the_limit_and_say_so) {
  const float largest = std::nextafter(float(gpu::FILM_BASE), 0.0f);
  for (const float value : {largest, -largest}) {
    Rows sum = added(nothing, Rows(1, {0, 0.9f * value, 0, 0}));
    EXPECT_EQ(sum[1].w, 0.0f);
    for (int more = 0; more < 3; ++more) sum = added(sum, Rows(5, {0, value, 0, 0}));
    EXPECT_EQ(sum[1].w, 1.0f);
    measured("sums that hide that they are full", 1.0 - sum[1].w, 0);
    EXPECT_TRUE(quantaOf(sum.data(), 1) >> 60 == (value > 0 ? 1 : -1) * Quanta(gpu::FILM_BASE));
  }
}

TEST_F(FilmSumKernel, row36_floats_keep_their_digits_however_small_the_sum) {
  const Rows values = farApart(5000);
  double worst = 0.0;
  Rows each;
  for (const glm::vec4& value : values) {
    each.insert(each.end(), nothing.begin(), nothing.end());
    each.push_back(value);
  }
  const Rows sums =
      run(film, {.rowsIn = sumRows + 1, .rowsOut = sumRows, .push = pushBytes(Additions{1})}, each);
  const Rows answers = run(film, {.operation = 2, .rowsIn = sumRows, .push = pushBytes(Additions{0})}, sums);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double exact = std::ldexp(double(quantaOf(&sums[i * sumRows], c)), -60);
      if (exact != 0.0) worst = std::max(worst, std::fabs(answers[i][c] / exact - 1.0));
    }
  EXPECT_LT(worst, 0x1p-22);
  measured("relative error of the float", worst, 0x1p-22);
}

}  // namespace
}  // namespace steradian::kernel
