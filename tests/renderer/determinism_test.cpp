// SPDX-License-Identifier: MIT
// The same samples give the same bytes, however the work is cut into dispatches.
#include <algorithm>

#include "renderer/film_sums.hpp"
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

class DeterminismTest : public RendererTest {
 protected:
  Image renderInBatches(const Scene& scene, Extent film, std::uint64_t samples, double budgetMs) {
    renderer().setScene(scene, roomView(), film);
    renderer().setSampleRange(0, samples);
    while (renderer().trace(budgetMs)) {
    }
    expectClean();
    EXPECT_EQ(renderer().stats().samples, samples);
    return renderer().radiance();
  }
  static void expectSameBytes(const Image& picture, const Image& expected) {
    EXPECT_TRUE(picture == expected);
    measured("pictures that differ", !(picture == expected), 0);
  }
};

TEST_F(DeterminismTest, row16_any_batch_budget_gives_the_same_bytes) {
  const Scene scene = room(6);
  const Extent film{40, 56};
  const Image whole = renderInBatches(scene, film, 48, 1e6);
  for (const double budget : {1e-3, 0.05, 0.7, 5.0, 200.0}) {
    SCOPED_TRACE(budget);
    expectSameBytes(renderInBatches(scene, film, 48, budget), whole);
  }
}

TEST_F(DeterminismTest, pause_and_resume_give_the_same_bytes) {
  const Scene scene = room(6);
  const Extent film{40, 56};
  const Image whole = renderInBatches(scene, film, 48, 1e6);
  renderer().setSampleRange(0, 48);
  int pauses = 0, betweenRows = 0;
  while (renderer().trace(1e-3)) {
    if (++pauses % 5 != 0) continue;
    // What a window does while it is paused: it shows, measures, reads what is under the mouse, saves.
    betweenRows += renderer().midPass();
    renderer().setScene(scene, roomView(), film);
    renderer().displayed();
    renderer().measureError();
    renderer().measureTails();
    renderer().pick(20, 28);
    renderer().filmSums();
  }
  EXPECT_GE(pauses, 20);
  EXPECT_GT(betweenRows, 0) << "no pause fell into a pass over the film";
  expectSameBytes(renderer().radiance(), whole);
}

TEST_F(DeterminismTest, a_still_that_goes_on_later_gives_the_same_bytes) {
  const Scene scene = room(6);
  const Extent film{40, 56};
  const Image whole = renderInBatches(scene, film, 48, 1e6);
  renderer().setSampleRange(0, 5);
  for (const std::uint64_t end : {13, 32, 48}) {
    while (renderer().trace(0.7)) {
    }
    renderer().extendSamples(end);
  }
  while (renderer().trace(0.7)) {
  }
  EXPECT_EQ(renderer().stats().samples, 48u);
  expectSameBytes(renderer().radiance(), whole);
}

TEST_F(DeterminismTest, row16_samples_that_fill_the_loop_budget_equal_single_dispatches) {
  Scene scene = room(64);
  scene.render.russianRoulette = true;
  for (int i = 0; i < 24; ++i) {
    const dvec3 p(-2.5 + 0.2 * i, 0.3 + 0.1 * (i % 7), -2.0 + 0.15 * (i % 11));
    if (i % 2)
      add(scene, at(p), Sphere{0.2}, lambert(glm::vec3(1.0f)));
    else
      add(scene, at(p), Box{{0.2, 0.2, 0.2}}, metal(0.05f));
  }
  const Image many = renderInBatches(scene, {24, 24}, 32, 1e6);
  expectSameBytes(renderInBatches(scene, {24, 24}, 32, 1e-3), many);
}

TEST_F(DeterminismTest, SceneSetAgainGivesTheSameBytesAndAnotherSeedDoesNot) {
  Scene scene = room(3);
  const Image first = renderInBatches(scene, {32, 32}, 8, 200.0);
  EXPECT_TRUE(renderInBatches(scene, {32, 32}, 8, 200.0) == first);
  scene.render.seed = 1;
  const Image other = renderInBatches(scene, {32, 32}, 8, 200.0);
  EXPECT_FALSE(other == first);
  EXPECT_NEAR(meanOf(other).value, meanOf(first).value, 0.05 * meanOf(first).value);
}

TEST_F(DeterminismTest, SampleRangesMergeByTheirMeans) {
  for (const bool errorMeter : {true, false}) {
    Scene scene = room(4);
    scene.render.errorMeter = errorMeter;
    const Image all = render(scene, roomView(), {32, 32}, 64);
    const Image low = render(scene, roomView(), {32, 32}, 24);
    const Image high = render(scene, roomView(), {32, 32}, 64, 24);
    double worst = 0.0;
    for (std::size_t i = 0; i < all.pixels.size(); ++i) {
      const double merged = (24.0 * low.pixels[i] + 40.0 * high.pixels[i]) / 64.0;
      worst = std::max(worst, std::abs(merged - all.pixels[i]) / std::max(1e-3f, all.pixels[i]));
    }
    EXPECT_LT(worst, 1e-6);
  }
}

TEST_F(DeterminismTest, HalvesAverageToThePicture) {
  const Image image = render(room(4), roomView(), {32, 32}, 17);
  const auto [a, b] = renderer().halves();
  ASSERT_EQ(a.pixels.size(), image.pixels.size());
  EXPECT_FALSE(a == b);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)  // samples 0, 2 ... 16 and 1, 3 ... 15
    ASSERT_NEAR((9.0 * a.pixels[i] + 8.0 * b.pixels[i]) / 17.0, image.pixels[i],
                1e-6 * (1.0 + image.pixels[i]));
}

TEST_F(DeterminismTest, OnlyAChangeOfRadianceStartsOver) {
  Scene scene = room(2);
  render(scene, roomView(), {16, 16}, 8);
  const double unit = renderer().filmSums().unit;
  scene.objects[0].name = "renamed";
  scene.display.exposure = 2.0f;
  renderer().setScene(scene, roomView(), {16, 16});
  EXPECT_EQ(renderer().stats().samples, 8u);
  EXPECT_EQ(renderer().filmSums().unit, unit) << "what is there is counted in the unit that it began with";
  scene.materials[0].albedo.x = 0.1f;
  renderer().setScene(scene, roomView(), {16, 16});
  EXPECT_EQ(renderer().filmSums().unit, unit / 4);
  EXPECT_EQ(renderer().stats().samples, 0u);
}

TEST_F(DeterminismTest, EmptySampleRangeIsRefused) {
  EXPECT_THROW(renderer().setSampleRange(5, 5), Error);
  EXPECT_THROW(renderer().setSampleRange(7, 2), Error);
}

TEST_F(DeterminismTest, PreviewingShowsThePictureAtOnceWhenItFitsTheBudget) {
  renderer().setScene(room(2), roomView(), {16, 16});
  renderer().setSampleRange(0, 100);
  EXPECT_TRUE(renderer().tracePreviewing(1e6));
  EXPECT_GE(renderer().stats().samples, 1u);
  EXPECT_GT(meanOf(renderer().radiance()).value, 0.05);
}

TEST_F(DeterminismTest, CoarsePreviewLeavesNoTraceInTheSamples) {
  const Scene scene = room(2);
  const Image expected = renderInBatches(scene, {64, 64}, 4, 1e6);
  renderer().setSampleRange(0, 4);  // starts over
  EXPECT_TRUE(renderer().tracePreviewing(1e-3));
  EXPECT_EQ(renderer().stats().samples, 0u);  // only the coarse film holds samples
  while (renderer().tracePreviewing(5.0)) {
  }
  EXPECT_TRUE(renderer().radiance() == expected);
}

TEST_F(DeterminismTest, row16_scene_beyond_the_loop_budget_is_refused_and_the_old_one_stays) {
  if (!onCpu()) GTEST_SKIP() << "only drivers with a short loop counter refuse scenes of this size";
  const Image old = render(room(2), roomView(), {16, 16}, 4);
  Scene scene = plainScene(64);
  const Id m = add(scene, Material{});
  // Planes have no bounds, so every ray meets all of them.
  for (int i = 0; i < 600; ++i) add(scene, at({0, -double(i), 0}), Plane{}, m);
  try {
    renderer().setScene(scene, roomView(), {16, 16});
    FAIL() << "600 planes at 64 bounces were taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::badInput);
    EXPECT_NE(std::string(error.what()).find("600 shapes"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("Set the bounces to"), std::string::npos) << error.what();
  }
  expectSameBytes(renderer().radiance(), old);
  scene.render.maxBounces = 40;  // what the message advises must work
  EXPECT_GT(meanOf(render(scene, lookAt({5, 1, 5}, {5, 0, 0}, 1.0), {16, 16}, 2)).value, -1.0);
}

}  // namespace
}  // namespace steradian
