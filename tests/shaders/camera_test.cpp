// SPDX-License-Identifier: MIT
// Camera rays: the pinhole, the thin lens against the lens formula, and parallel projection.
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "shaders/gpu_types.h"
#include "tests/shaders/environment_kernel.hpp"
#include "tests/shaders/kernel.hpp"

namespace steradian::kernel {
namespace {

constexpr std::uint32_t width = 64, height = 48;

struct Lens {
  float radius = 0.0f, focus = 3.0f;
  bool parallel = false;
  float pixelScale = 0.01f;
  glm::dmat3 world{glm::mat3_cast(glm::angleAxis(0.8, glm::normalize(glm::dvec3(1, -2, 0.5))))};
};

struct SeenRay {
  glm::dvec3 o, d;
};

class CameraKernel : public KernelTest {
 protected:
  /// Questions: x, y in pixels, lens u, v.
  static Rows ask(const Lens& lens, const Rows& questions) {
    gpu::TraceParams params{};
    params.width = width;
    params.height = height;
    params.pixelScale = lens.pixelScale;
    const Rows rows = {{glm::vec3(lens.world[0]), lens.radius},
                       {glm::vec3(lens.world[1]), lens.focus},
                       {glm::vec3(-lens.world[2]), lens.parallel ? 1.0f : 0.0f}};
    return run(environment, {.operation = 3, .rowsOut = 2, .push = pushBytes(params), .scene = rows},
               questions);
  }
  static std::vector<SeenRay> rays(const Lens& lens, const Rows& questions) {
    const Rows answers = ask(lens, questions);
    std::vector<SeenRay> seen;
    const glm::dmat3 inverse = glm::transpose(lens.world);
    for (std::size_t i = 0; i < answers.size(); i += 2)
      seen.push_back({inverse * xyz(answers[i]), inverse * xyz(answers[i + 1])});
    return seen;  // in camera space
  }
  static Rows randomQuestions(std::size_t count) {
    Random random(2);
    Rows questions;
    for (std::size_t i = 0; i < count; ++i)
      questions.emplace_back(random.uniform(0, width), random.uniform(0, height), random.uniform(),
                             random.uniform());
    return questions;
  }
};

glm::dvec3 atDepth(const SeenRay& ray, double depth) {
  return ray.o + ray.d * ((-depth - ray.o.z) / ray.d.z);
}

TEST_F(CameraKernel, a_closed_lens_gives_the_pinhole_to_the_bit) {
  const Rows questions = randomQuestions(10000);
  Rows middle = questions;
  for (glm::vec4& q : middle) q.z = q.w = 0.0f;
  const Rows closed = ask({}, questions), pinhole = ask({}, middle);
  ASSERT_EQ(closed.size(), pinhole.size());
  for (std::size_t i = 0; i < closed.size(); ++i) ASSERT_EQ(closed[i], pinhole[i]);
  Lens open;
  open.radius = 0.1f;
  const Rows central = ask(open, middle);
  for (std::size_t i = 0; i < closed.size(); ++i) ASSERT_LT(glm::length(central[i] - pinhole[i]), 1e-7f);
}

TEST_F(CameraKernel, pinhole_rays_pass_through_their_pixels) {
  const Lens lens;
  const Rows questions = {{0, 0, 0, 0}, {32, 24, 0, 0}, {64, 48, 0, 0}, {10.5, 40.25, 0, 0}};
  const std::vector<SeenRay> seen = rays(lens, questions);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_LT(glm::length(seen[i].o), 1e-12);
    const glm::dvec3 there = atDepth(seen[i], 1.0);
    EXPECT_NEAR(there.x, (questions[i].x - 32) * 0.01, 1e-6);
    EXPECT_NEAR(there.y, (24 - questions[i].y) * 0.01, 1e-6);
  }
}

TEST_F(CameraKernel, all_rays_of_a_point_of_the_film_meet_in_the_plane_in_focus) {
  Lens lens;
  lens.radius = 0.2f;
  const Rows questions = randomQuestions(10000);
  const std::vector<SeenRay> seen = rays(lens, questions);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    ASSERT_NEAR(seen[i].o.z, 0.0, 1e-7) << "the lens is perpendicular to the axis";
    const glm::dvec3 there = atDepth(seen[i], lens.focus);
    ASSERT_NEAR(there.x, (questions[i].x - 32) * 0.01 * lens.focus, 3e-6);
    ASSERT_NEAR(there.y, (24 - questions[i].y) * 0.01 * lens.focus, 3e-6);
  }
}

// By similar triangles an opening of radius R, focused at F, covers a disc of radius R |D - F| / F at depth
// D; seen from the lens' middle, in units of the image at distance 1, R |D - F| / (F D): the circle of
// confusion.
TEST_F(CameraKernel, the_circle_of_confusion_follows_the_lens_formula) {
  Lens lens;
  lens.radius = 0.1f;
  Rows questions = randomQuestions(200000);
  for (glm::vec4& q : questions) q.x = 20.0f, q.y = 13.0f;
  const std::vector<SeenRay> seen = rays(lens, questions);
  for (const double depth : {1.0, 2.0, 30.0, 1e5}) {
    const glm::dvec3 middle(glm::dvec3(-0.12, 0.11, -1.0) * depth);
    const double expected = lens.radius * std::abs(depth - lens.focus) / lens.focus;
    double largest = 0.0, squares = 0.0;
    glm::dvec3 mean(0.0);
    for (const SeenRay& ray : seen) {
      const glm::dvec3 off = atDepth(ray, depth) - middle;
      largest = std::max(largest, glm::length(off));
      squares += glm::dot(off, off) / double(seen.size());
      mean += off / double(seen.size());
    }
    EXPECT_NEAR(largest, expected, 1e-4 * expected + 1e-7 * depth) << depth;
    // Even over the disc: mean square radius is half of the square, the mean is the middle.
    EXPECT_NEAR(squares, 0.5 * expected * expected, 0.005 * expected * expected) << depth;
    EXPECT_LT(glm::length(mean), 0.01 * expected) << depth;
  }
}

TEST_F(CameraKernel, parallel_rays_start_on_the_image_plane_in_metres) {
  Lens lens;
  lens.parallel = true;
  lens.pixelScale = 0.25f;
  const Rows questions = randomQuestions(1000);
  const std::vector<SeenRay> seen = rays(lens, questions);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    ASSERT_LT(glm::length(seen[i].d - glm::dvec3(0, 0, -1)), 2e-7);
    ASSERT_LT(
        glm::length(seen[i].o - glm::dvec3((questions[i].x - 32) * 0.25, (24 - questions[i].y) * 0.25, 0)),
        2e-6);
  }
}

}  // namespace
}  // namespace steradian::kernel
