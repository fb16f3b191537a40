// SPDX-License-Identifier: MIT
// The choice among many lights: probabilities that sum to one, reach every light, and pay.
#include <algorithm>
#include <cstdint>
#include <iostream>

#include "tests/shaders/light_samples.hpp"

namespace steradian::kernel {
namespace {

void append(Rows& rows, const Rows& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

/// Lights of every kind: suns first, then the rest in any order, some of them dark.
Rows manyLights(Random& random, int count, int suns) {
  Rows rows;
  for (int i = 0; i < count; ++i) {
    const vec3 centre(random.direction() * random.decades(-1, 3));
    const float power = random.uniform() < 0.05 ? 0.0f : float(random.decades(-4, 4));
    const double size = random.decades(-2, 1);
    const vec3 u(random.direction() * size), v(random.direction() * size);
    if (i < suns) {
      append(rows, directionalLight(vec3(random.direction()), power, 0.01));
    } else if (i % 5 == 0) {
      append(rows, sphereLight(centre, power, float(size)));
    } else if (i % 5 == 1) {
      append(rows, flatLight(i % 2 ? gpu::LIGHT_RECT : gpu::LIGHT_DISK, centre, power, u, v));
    } else if (i % 50 == 2) {
      append(rows, directionalLight(vec3(random.direction()), power));
    } else {
      append(rows, pointLight(centre, power));
    }
  }
  return rows;
}

class LightTree : public KernelTest {
 protected:
  /// Probabilities of all lights at a point.
  static std::vector<double> probabilities(const Rows& scene, const vec3& p) {
    Rows questions;
    for (std::size_t i = 0; i < scene.size() / gpu::LIGHT_ROWS; ++i) questions.emplace_back(p, float(i));
    std::vector<double> all;
    for (const glm::vec4& a : run(lights, lightTask(3, 1, 1, scene, 0), questions))
      all.push_back(double(a.x));
    return all;
  }
};

TEST_F(LightTree, probabilities_sum_to_one_and_leave_no_light_out) {
  Random random(1);
  for (const int count : {1, 2, 3, 7, 37, 1000}) {
    const Rows scene = manyLights(random, count, count / 8);
    const std::size_t some = std::size_t(random.uniform() * count);
    for (const vec3& p :
         {vec3(0), vec3(scene[some * gpu::LIGHT_ROWS]), vec3(1e6f, 2e6f, -3e6f), vec3(30, -20, 5)}) {
      const std::vector<double> all = probabilities(scene, p);
      double sum = 0;
      for (const double probability : all) sum += probability;
      EXPECT_NEAR(sum, 1, 1e-5) << count << " lights";
      EXPECT_GT(*std::min_element(all.begin(), all.end()), 0) << count << " lights";
    }
  }
}

TEST_F(LightTree, lights_are_chosen_as_often_as_their_probability_says) {
  Random random(2);
  const Rows scene = manyLights(random, 61, 2);
  const vec3 p(2, 1, -3);
  Rows questions;
  constexpr int draws = 1 << 20;
  for (int i = 0; i < draws; ++i) questions.emplace_back(p, float((i + 0.5) / draws));
  const Rows answers = run(lights, lightTask(2, 1, 1, scene), questions);
  const std::vector<double> expected = probabilities(scene, p);
  std::vector<double> seen(expected.size(), 0.0);
  for (const glm::vec4& a : answers) {
    ASSERT_EQ(a.y, a.z) << "the trail of light " << a.x << " gives another probability";
    seen[std::size_t(a.x)] += 1.0 / draws;
  }
  // Evenly spread numbers, so that only rounding is left.
  for (std::size_t i = 0; i < seen.size(); ++i)
    EXPECT_NEAR(seen[i], expected[i], 4e-6 + 1e-3 * expected[i]) << "light " << i;
}

TEST_F(LightTree, the_last_number_below_one_and_zero_choose_lights_too) {
  Random random(3);
  const Rows scene = manyLights(random, 1000, 1);
  const Rows answers =
      run(lights, lightTask(2, 1, 1, scene), {glm::vec4(1, 2, 3, 0), glm::vec4(1, 2, 3, 1.0f - 0x1p-24f)});
  for (const glm::vec4& a : answers) {
    EXPECT_GE(a.x, 0.0f);
    EXPECT_LT(a.x, 1000.0f);
    EXPECT_GT(a.y, 0.0f);
  }
}

/// Variance of one light sample of the irradiance at p, that a choice of these probabilities leaves.
double variance(const std::vector<double>& irradiances, const std::vector<double>& choice) {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < irradiances.size(); ++i) {
    sum += irradiances[i];
    squares += irradiances[i] * irradiances[i] / choice[i];
  }
  return squares - sum * sum;
}

TEST_F(LightTree, a_thousand_lamps_are_sampled_with_a_fraction_of_the_variance_of_uniform_choice) {
  Random random(4);
  Rows scene;
  for (int i = 0; i < 1000; ++i)
    append(scene,
           pointLight(vec3(dvec3(random.uniform(-50, 50), random.uniform(2, 4), random.uniform(-50, 50))),
                      float(random.decades(0, 1))));
  double tree = 0, uniform = 0;
  for (int i = 0; i < 64; ++i) {
    const vec3 p(dvec3(random.uniform(-50, 50), 0, random.uniform(-50, 50)));
    std::vector<double> irradiances;
    for (std::size_t k = 0; k < scene.size(); k += gpu::LIGHT_ROWS) {
      const dvec3 f = xyz(scene[k]) - dvec3(p);
      irradiances.push_back(double(scene[k + 1].x) * f.y / std::pow(glm::dot(f, f), 1.5));
    }
    tree += variance(irradiances, probabilities(scene, p));
    uniform += variance(irradiances, std::vector<double>(1000, 1e-3));
  }
  RecordProperty("variance_ratio", std::to_string(uniform / tree));
  std::cout << "variance of uniform choice / of the tree at 1,000 lamps: " << uniform / tree << "\n";
  EXPECT_GT(uniform / tree, 20.0);
}

}  // namespace
}  // namespace steradian::kernel
