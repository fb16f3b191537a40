// SPDX-License-Identifier: MIT
// The sky: what it shows in each direction, against the layout of the image by other formulas than the GLSL,
// and directions drawn from it, against their density.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/gtc/quaternion.hpp>

#include "renderer/gpu_environment.hpp"
#include "shaders/gpu_types.h"
#include "tests/shaders/environment_kernel.hpp"
#include "tests/shaders/kernel.hpp"
#include "tests/shaders/oracle.hpp"

namespace steradian::kernel {
namespace {

constexpr std::size_t samples = 1000000;
constexpr std::size_t sampleRows = 3;  // wi, pdf | illuminance, pdf of wi | radiance of wi

struct Sky {
  Light light;
  glm::dmat4 world{1.0};
  const Image* image() const { return std::get<EnvironmentLight>(light.kind).image.get(); }
};

class EnvironmentKernel : public KernelTest {
 protected:
  static Rows ask(std::uint32_t operation, const Sky& sky, const Rows& questions) {
    gpu::TraceParams params{};
    params.flags = gpu::TRACE_ENVIRONMENT;
    Task task{
        .operation = operation, .push = pushBytes(params), .scene = environmentRows(&sky.light, sky.world)};
    task.tables.resize(gpu::ENERGY_ROWS);
    if (sky.image()) {
      const Rows tables = environmentTables(*sky.image());
      task.tables.insert(task.tables.end(), tables.begin(), tables.end());
    }
    if (operation == 2) task.rowsIn = 0, task.rowsOut = sampleRows, task.invocations = samples;
    return run(environment, task, questions);
  }
  static Rows lookUp(const Sky& sky, const Rows& directions) { return ask(1, sky, directions); }
  static Rows draw(const Sky& sky) { return ask(2, sky, {}); }
};

Sky gradientSky(glm::vec3 zenith, glm::vec3 horizon, glm::vec3 ground) {
  return {Light{EnvironmentLight{horizon, ground}, zenith, 2.0f}};
}

/// Texels over six decades, a few black ones, all different.
Sky imageSky(int width, int height) {
  auto image = std::make_shared<Image>(Image{width, height, 3, {}});
  Random random(11);
  for (int i = 0; i < width * height; ++i) {
    const double value = i % 7 == 3 ? 0.0 : random.decades(-3.0, 3.0);
    for (const double tint : {1.0, 0.7, 0.2}) image->pixels.push_back(float(value * tint));
  }
  EnvironmentLight light;
  light.image = std::move(image);
  return {Light{light, {1.0f, 0.5f, 0.25f}, 3.0f},
          glm::mat4_cast(glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, -3))))};
}

/// Direction at `across` and `down` (0..1 from the left and the top) of the map, in the world.
glm::dvec3 directionAt(const Sky& sky, double across, double down) {
  const double azimuth = 2 * M_PI * (across - 0.5), polar = M_PI * down;
  const glm::dvec3 local(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                         -std::sin(polar) * std::cos(azimuth));
  return glm::dmat3(sky.world) * local;
}

struct Place {
  double across, down;
};
Place placeOf(const Sky& sky, const glm::dvec3& world) {
  const glm::dvec3 d = glm::transpose(glm::dmat3(sky.world)) * world;
  return {0.5 + std::atan2(d.x, -d.z) / (2 * M_PI), std::atan2(std::hypot(d.x, d.z), d.y) / M_PI};
}

double luminanceOf(const glm::dvec3& c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}
double bandHeight(int row, int rows) {
  return std::cos(M_PI * row / rows) - std::cos(M_PI * (row + 1) / rows);
}

/// Density of a texel per solid angle: its luminance over the integral of all.
std::vector<double> texelDensities(const Image& image) {
  std::vector<double> density;
  double total = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float* t = image.at(x, y);
      density.push_back(luminanceOf({t[0], t[1], t[2]}));
      total += density.back() * bandHeight(y, image.height) * 2 * M_PI / image.width;
    }
  for (double& d : density) d /= total;
  return density;
}

// 101 x 202 bins of equal solid angle over the sky's own axes.
constexpr int rings = 101, sectors = 202;
using Expected = std::vector<double>;  // share of each bin

Expected expectedOf(const Image& image) {
  const std::vector<double> density = texelDensities(image);
  Expected shares(rings * sectors, 0.0);
  const auto common = [](double a0, double a1, double b0, double b1) {
    return std::max(0.0, std::min(a1, b1) - std::max(a0, b0));
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int y = 0; y < image.height; ++y) {
      const double top = std::cos(M_PI * y / image.height), bottom = top - bandHeight(y, image.height);
      const double height = common(1 - 2.0 * (ring + 1) / rings, 1 - 2.0 * ring / rings, bottom, top);
      if (height <= 0.0) continue;
      for (int sector = 0; sector < sectors; ++sector)
        for (int x = sector * image.width / sectors; x < image.width; ++x) {
          const double width = common(double(sector) / sectors, double(sector + 1) / sectors,
                                      double(x) / image.width, double(x + 1) / image.width);
          if (width <= 0.0) break;
          shares[std::size_t(ring * sectors + sector)] +=
              density[std::size_t(y * image.width + x)] * height * width * 2 * M_PI;
        }
    }
  return shares;
}

/// Of a density that depends on the height alone and is linear within a ring (but for the middle one).
Expected expectedOf(const std::function<double(double)>& densityAtHeight) {
  Expected shares(rings * sectors);
  constexpr int steps = 100;
  for (int ring = 0; ring < rings; ++ring) {
    double mean = 0.0;
    for (int i = 0; i < steps; ++i)
      mean += densityAtHeight(1 - 2.0 * (ring + (i + 0.5) / steps) / rings) / steps;
    std::fill_n(&shares[std::size_t(ring * sectors)], sectors, mean * 4 * M_PI / (rings * sectors));
  }
  return shares;
}

/// p-value that the directions were drawn with these shares; bins that expect fewer than 5 are pooled.
double chiSquare(const Sky& sky, const Rows& drawn, const Expected& shares) {
  std::vector<double> seen(shares.size(), 0.0);
  for (std::size_t i = 0; i < drawn.size(); i += sampleRows) {
    const Place place = placeOf(sky, xyz(drawn[i]));
    const int ring = std::clamp(int(0.5 * (1 - std::cos(M_PI * place.down)) * rings), 0, rings - 1);
    const int sector = std::clamp(int(place.across * sectors), 0, sectors - 1);
    seen[std::size_t(ring * sectors + sector)] += 1;
  }
  double statistic = 0, pooledSeen = 0, pooledExpected = 0;
  int bins = 0;
  const auto addBin = [&](double count, double expected) {
    statistic += (count - expected) * (count - expected) / expected;
    ++bins;
  };
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double expected = shares[i] * samples;
    if (expected >= 5)
      addBin(seen[i], expected);
    else
      pooledSeen += seen[i], pooledExpected += expected;
  }
  if (pooledExpected >= 5) addBin(pooledSeen, pooledExpected);
  return oracle::chiSquareP(statistic, bins - 1);
}

TEST_F(EnvironmentKernel, row17_angles_are_within_four_units_of_a_quarter_turn) {
  Random random(3);
  Rows questions = {{1, 0, 0, 0}, {-1, 0, 0, 0}, {0, 1, 0, 0}, {0, -1, 0, 0}, {0, 0, 0, 0}, {1, 1, 0, 0}};
  for (int i = 0; i < 100000; ++i) {
    const double turn = 2 * M_PI * random.uniform(), length = random.decades(-6.0, 6.0);
    questions.emplace_back(length * std::cos(turn), length * std::sin(turn), 0, 0);
  }
  for (const double tiny : {1e-12, 1e-7, 1e-4}) questions.emplace_back(1.0, tiny, 0, 0);
  const Rows answers = run(environment, {.operation = 0}, questions);
  double worst = 0;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const double expected = std::atan2(double(questions[i].y), double(questions[i].x)) / (2 * M_PI);
    const double unit = ulp(std::max(0.25, std::abs(expected)));
    ASSERT_NEAR(answers[i].x, expected, 4 * unit) << questions[i].x << " " << questions[i].y;
    worst = std::max(worst, std::abs(double(answers[i].x) - expected) / unit);
  }
  measured("error of the arc tangent, ULP of a quarter turn", worst, 4);
  EXPECT_NEAR(answers.back().x, 1e-4 / (2 * M_PI), 1e-10) << "small angles keep their digits";
}

TEST_F(EnvironmentKernel, the_gradient_is_linear_in_the_height) {
  Sky sky = gradientSky({1, 0.5f, 0.25f}, {0.5f, 0.6f, 0.7f}, {0.1f, 0.2f, 0.3f});
  sky.world = glm::mat4_cast(glm::angleAxis(1.1, glm::normalize(glm::dvec3(3, 1, 2))));
  Random random(5);
  Rows directions;
  for (int i = 0; i < 10000; ++i) directions.emplace_back(glm::vec3(random.direction()), 0);
  const Rows answers = lookUp(sky, directions);
  const glm::dvec3 zenith = glm::dvec3(1, 0.5, 0.25) * 2.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double y = glm::dot(glm::dvec3(sky.world[1]), xyz(directions[i]));
    const glm::dvec3 other = y > 0 ? zenith : zenith * glm::dvec3(0.1, 0.2, 0.3);
    const glm::dvec3 expected = glm::mix(zenith * glm::dvec3(0.5, 0.6, 0.7), other, std::abs(y));
    ASSERT_LT(glm::length(xyz(answers[i]) - expected), 2e-6);
  }
}

TEST_F(EnvironmentKernel, the_image_has_its_centre_along_minus_z_and_its_top_above) {
  auto image = std::make_shared<Image>(Image{8, 4, 3, std::vector<float>(8 * 4 * 3)});
  for (int i = 0; i < 32; ++i) image->pixels[std::size_t(i) * 3] = float(i + 1);
  Sky sky{Light{EnvironmentLight{}, glm::vec3(1), 1.0f}};
  std::get<EnvironmentLight>(sky.light.kind).image = image;
  const double turn = 1e-3;  // beside the border between columns 3 and 4
  const Rows answers = lookUp(sky, {{std::sin(-turn), 0.01, -std::cos(turn), 0},
                                    {std::sin(turn), 0.01, -std::cos(turn), 0},
                                    {1, 0.01, turn, 0},
                                    {1, -0.01, turn, 0},
                                    {turn, 1, -1e-6, 0},
                                    {turn, -1, -1e-6, 0},
                                    {0, 1, 0, 0}});
  const auto texel = [&](std::size_t i) { return int(answers[i].x) - 1; };
  EXPECT_EQ(texel(0), 8 + 3);
  EXPECT_EQ(texel(1), 8 + 4);
  EXPECT_EQ(texel(2), 8 + 6) << "+X is to the right";
  EXPECT_EQ(texel(3), 16 + 6);
  EXPECT_EQ(texel(4), 5);
  EXPECT_EQ(texel(5), 24 + 5);
  EXPECT_LT(texel(6), 8) << "the pole itself lies in the top row";
}

TEST_F(EnvironmentKernel, every_texel_is_found_also_at_the_poles) {
  for (const auto& [width, height] :
       {std::array{37, 19}, std::array{64, 2048}, std::array{1, 1}, std::array{4096, 2}}) {
    const Sky sky = imageSky(width, height);
    const std::vector<double> density = texelDensities(*sky.image());
    Rows directions;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        directions.emplace_back(glm::vec3(directionAt(sky, (x + 0.5) / width, (y + 0.5) / height)), 0);
    const Rows answers = lookUp(sky, directions);
    double integral = 0.0;
    int wrong = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const float* texel = &sky.image()->pixels[i * 3];
      const glm::dvec3 expected = glm::dvec3(texel[0], texel[1], texel[2]) * glm::dvec3(3, 1.5, 0.75);
      wrong += glm::length(xyz(answers[i]) - expected) > 1e-6 * glm::length(expected) ? 1 : 0;
      const int row = int(i) / width;
      integral += double(answers[i].w) * bandHeight(row, height) * 2 * M_PI / width;
      EXPECT_NEAR(answers[i].w, density[i], 2e-6 * density[i]);
    }
    // A float direction is within 1e-7; a texel around a pole of 2048 rows is 4e-5 wide.
    EXPECT_LE(wrong, int(answers.size()) / 10000) << width << " x " << height;
    EXPECT_NEAR(integral, 1.0, 1e-3) << "row 25";
    if (wrong == 0) {
      EXPECT_NEAR(integral, 1.0, 1e-6);
    }
  }
}

TEST_F(EnvironmentKernel, row25_a_drawn_direction_has_the_density_it_was_drawn_with) {
  for (const Sky& sky :
       {imageSky(64, 33), imageSky(2048, 1024), gradientSky({1, 1, 1}, {0.2f, 0.3f, 0.1f}, {0, 0, 0}),
        gradientSky({0, 0, 0.1f}, {1, 1, 4}, {1, 2, 1})}) {
    const Rows drawn = draw(sky);
    std::size_t parted = 0;
    double worst = 0;
    for (std::size_t i = 0; i < drawn.size(); i += sampleRows) {
      const double pdf = drawn[i].w, again = drawn[i + 1].w;
      ASSERT_TRUE(std::isfinite(drawn[i + 1].x));
      ASSERT_NEAR(glm::length(xyz(drawn[i])), 1.0, 1e-6);
      if (std::abs(pdf - again) > 1e-4 * pdf) {
        ++parted;
        continue;
      }
      const glm::dvec3 radiance = xyz(drawn[i + 1]) * pdf;
      ASSERT_LE(glm::length(radiance - xyz(drawn[i + 2])), 1e-4 * glm::length(radiance));
      worst = std::max(worst, std::abs(pdf - again) / pdf);
    }
    measured("relative difference of the two densities", worst, 1e-4);
    // Only on the borders of texels, which rounding blurs by about 1e-7 of a turn.
    const double borders = sky.image() ? 3e-7 * (sky.image()->width + 2.0 * sky.image()->height) : 0.0;
    EXPECT_LE(double(parted), borders * samples);
    measured("share of samples beside a border of texels", double(parted) / samples, borders);
  }
}

constexpr double significance = 0.001;  // 0.01 over ten tests (Sidak)

TEST_F(EnvironmentKernel, row24_directions_follow_the_image) {
  for (const auto& [width, height] : {std::array{16, 8}, std::array{37, 19}, std::array{300, 151}}) {
    const Sky sky = imageSky(width, height);
    const Rows drawn = draw(sky);
    const Expected expected = expectedOf(*sky.image());
    const double p = chiSquare(sky, drawn, expected);
    EXPECT_GT(p, significance) << width << " x " << height;
    measuredAtLeast("least p of chi-square", p, significance);
    Sky turned = sky;
    turned.world = glm::rotate(sky.world, 0.01, glm::dvec3(0, 1, 0));
    EXPECT_LT(chiSquare(turned, drawn, expected), significance) << "the test must bite";
  }
}

TEST_F(EnvironmentKernel, row24_directions_follow_the_gradient) {
  const glm::vec3 colors[][3] = {{glm::vec3(1), glm::vec3(0.3f), glm::vec3(0.2f)},
                                 {glm::vec3(1), glm::vec3(0), glm::vec3(0)},
                                 {glm::vec3(0.1f), glm::vec3(10), glm::vec3(3)}};
  for (const auto& [zenith, horizon, ground] : colors) {
    const Sky sky = gradientSky(zenith, horizon, ground);
    // Grey: the luminance is the value. The mean over a half sphere lies halfway.
    const double z = 2 * zenith.x, h = z * horizon.x, g = z * ground.x, total = M_PI * (2 * h + z + g);
    const auto density = [&](double y) {
      return ((y > 0 ? z : g) * std::abs(y) + h * (1 - std::abs(y))) / total;
    };
    const double p = chiSquare(sky, draw(sky), expectedOf(density));
    EXPECT_GT(p, significance);
    measuredAtLeast("least p of chi-square", p, significance);
  }
}

TEST_F(EnvironmentKernel, an_even_gradient_is_left_to_the_paths) {
  for (const Sky& sky : {gradientSky({1, 1, 1}, {1, 1, 1}, {1, 1, 1}),
                         gradientSky({1, 2, 3}, {0.5f, 0.5f, 0.5f}, {0.4f, 0.4f, 0.4f})}) {
    const Rows drawn = draw(sky);
    for (std::size_t i = 0; i < drawn.size(); i += sampleRows) {
      ASSERT_EQ(drawn[i + 1], glm::vec4(0));
      ASSERT_EQ(drawn[i].w, 0.0f);
      ASSERT_GT(drawn[i + 2].x, 0.0f) << "but seen";
    }
  }
}

TEST_F(EnvironmentKernel, a_black_sky_sends_nothing) {
  Sky image = imageSky(16, 8);
  std::get<EnvironmentLight>(image.light.kind).image =
      std::make_shared<Image>(Image{4, 2, 3, std::vector<float>(24)});
  for (const Sky& sky : {image, gradientSky({0, 0, 0}, {1, 1, 1}, {1, 1, 1})}) {
    const Rows drawn = draw(sky);
    for (std::size_t i = 0; i < drawn.size(); i += sampleRows) {
      ASSERT_EQ(drawn[i + 1], glm::vec4(0));
      ASSERT_EQ(drawn[i].w, 0.0f);
    }
  }
}

}  // namespace
}  // namespace steradian::kernel
