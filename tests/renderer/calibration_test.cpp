// SPDX-License-Identifier: MIT
// The meter is calibrated: over many kinds of scenes and sample counts its figure is the error that a long
// reference reveals. Prints the table of estimate / truth.
#include <cstdio>
#include <cstdlib>

#include "renderer/relative_error.hpp"
#include "tests/renderer/feature_scenes.hpp"
#include "tests/renderer/renderer_fixture.hpp"

namespace steradian {
namespace {

using namespace scenes;

constexpr Extent film{24, 24};
constexpr int seeds = 12;

Scene hardEdges() {
  Scene scene = plainScene(0);
  for (int i = 0; i < 24; ++i)
    add(scene,
        at({std::cos(i * 1.1) * (0.2 + 0.03 * i), std::sin(i * 1.9) * (0.2 + 0.03 * i), -3.0 - 0.1 * i}),
        Sphere{0.15}, emitter(float(1 + i % 4)));
  scene.render.filter = PixelFilter::blackmanHarris;
  return scene;
}

std::vector<FeatureScene> cases() {
  std::vector<FeatureScene> all = featureScenes();
  all.push_back({"furnished room", room(4), roomView()});
  all.push_back({"hard edges", hardEdges(), lookAt({0, 0, 0}, {0, 0, -1}, 0.6)});
  return all;
}

/// Mean squares over pixels and channels, absolute and over light^2 + kRelativeFloor.
struct Squares {
  double absolute = 0.0, relative = 0.0;

  void add(Squares more) { absolute += more.absolute, relative += more.relative; }
};

Squares squaresOf(const ErrorEstimate& error) {
  return {error.rmse * error.rmse, error.relRmse * error.relRmse};
}

class CalibrationTest : public RendererTest {
 protected:
  void SetUp() override { renderer().allowSpecialization(true); }

  /// A long picture and its own error.
  struct Reference {
    Image image;
    Squares own;
  };
  Reference reference(FeatureScene c) {
    c.scene.render.seed = 1000;
    renderer().setScene(c.scene, c.view, film);
    renderer().waitForSpecialization();
    const Image image = render(c.scene, c.view, film, referenceSamples());
    return {image, squaresOf(renderer().measureError())};
  }

  /// A CPU gets a shorter one unless asked for more; its own error is taken off either way.
  static std::uint64_t referenceSamples() {
    const char* asked = std::getenv("STERADIAN_REFERENCE_SAMPLES");
    return asked ? std::strtoull(asked, nullptr, 10) : onCpu() ? 4'096 : 65'536;
  }

  /// The relative figure may say too much, never too little: where things smaller than a pixel shine, the
  /// halves that met them and those that did not look like fireflies to it.
  static void expectTrue(Squares ratio, bool finerThanPixels) {
    EXPECT_NEAR(ratio.absolute, 1.0, 0.1);
    measured("distance of estimate / truth from 1", std::abs(ratio.absolute - 1.0), 0.1);
    EXPECT_GT(ratio.relative, 0.9);
    if (finerThanPixels) return;
    EXPECT_LT(ratio.relative, 1.15);
    measured("distance of relative estimate / truth from 1", std::abs(ratio.relative - 1.0), 0.15);
  }
  static bool finerThanPixels(const std::string& scene) {
    return scene == "many lamps" || scene == "hard edges";
  }

  static Squares found(const Image& image, const Reference& reference) {
    Squares sum;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const double truth = reference.image.pixels[i], square = std::pow(image.pixels[i] - truth, 2);
      sum.add({square, square / (truth * truth + kRelativeFloor)});
    }
    const double values = double(image.pixels.size());
    return {sum.absolute / values - reference.own.absolute, sum.relative / values - reference.own.relative};
  }

  /// Estimate / truth at one sample count, both averaged (as squares) over some seeds.
  Squares calibration(FeatureScene c, int samples, const Reference& reference) {
    Squares estimated, true_;
    for (int seed = 1; seed <= seeds; ++seed) {
      c.scene.render.seed = std::uint32_t(seed);
      const Image image = render(c.scene, c.view, film, std::uint64_t(samples));
      estimated.add(squaresOf(renderer().measureError()));
      true_.add(found(image, reference));
    }
    return {std::sqrt(estimated.absolute / true_.absolute), std::sqrt(estimated.relative / true_.relative)};
  }
};

TEST_F(CalibrationTest, row38_the_meter_tells_the_true_error_in_every_kind_of_scene) {
  std::printf("estimate / truth at samples per pixel\n%-24s %20s   %20s\n%-24s", "", "RMSE       ",
              "relative RMSE   ", "scene");
  std::printf(" %6d %6d %6d   %6d %6d %6d\n", 16, 64, 256, 16, 64, 256);
  for (const FeatureScene& c : cases()) {
    const Reference truth = reference(c);
    Squares ratios[3];
    for (int i = 0; i < 3; ++i) {
      ratios[i] = calibration(c, 16 << (2 * i), truth);
      SCOPED_TRACE(std::string(c.name) + " at " + std::to_string(16 << (2 * i)) + " samples");
      expectTrue(ratios[i], finerThanPixels(c.name));
    }
    const auto& [few, more, many] = ratios;
    std::printf("%-24s %6.3f %6.3f %6.3f   %6.3f %6.3f %6.3f\n", c.name, few.absolute, more.absolute,
                many.absolute, few.relative, more.relative, many.relative);
  }
}

TEST_F(CalibrationTest, the_device_and_the_host_agree_about_the_relative_error) {
  const FeatureScene c = featureScenes().front();
  render(c.scene, c.view, {29, 17}, 16);
  const auto [a, b] = renderer().halves();
  std::vector<double> means, variances;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    means.push_back(0.5 * (double(a.pixels[i]) + b.pixels[i]));
    variances.push_back(std::pow(0.5 * (double(a.pixels[i]) - b.pixels[i]), 2));
  }
  const double onHost = std::sqrt(meanRelativeSquare({29, 17}, means, variances));
  EXPECT_GT(onHost, 0.0);
  EXPECT_NEAR(renderer().measureError().relRmse / onHost, 1.0, 1e-4);
}

}  // namespace
}  // namespace steradian
