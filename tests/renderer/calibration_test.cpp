// SPDX-License-Identifier: MIT
// The meter is calibrated: over many kinds of scenes and sample counts its figure is the error that a long
// reference reveals. Prints the table of estimate / truth.
#include <cstdio>
#include <cstdlib>

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

class CalibrationTest : public RendererTest {
 protected:
  void SetUp() override { renderer().allowSpecialization(true); }

  /// A long picture and its own mean square error.
  struct Reference {
    Image image;
    double meanSquare;
  };
  Reference reference(FeatureScene c) {
    c.scene.render.seed = 1000;
    renderer().setScene(c.scene, c.view, film);
    renderer().waitForSpecialization();
    const Image image = render(c.scene, c.view, film, referenceSamples());
    return {image, std::pow(renderer().measureError().rmse, 2)};
  }

  /// A CPU gets a shorter one unless asked for more; its own error is taken off either way.
  static std::uint64_t referenceSamples() {
    const char* asked = std::getenv("STERADIAN_REFERENCE_SAMPLES");
    return asked ? std::strtoull(asked, nullptr, 10) : onCpu() ? 4'096 : 65'536;
  }

  double meanSquare(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::pow(double(a.pixels[i]) - b.pixels[i], 2);
    return sum / double(a.pixels.size());
  }

  /// Estimate / truth in RMSE at one sample count, both averaged (as squares) over some seeds.
  double calibration(FeatureScene c, int samples, const Reference& reference) {
    double estimated = 0.0, found = 0.0;
    for (int seed = 1; seed <= seeds; ++seed) {
      c.scene.render.seed = std::uint32_t(seed);
      const Image image = render(c.scene, c.view, film, std::uint64_t(samples));
      estimated += std::pow(renderer().measureError().rmse, 2);
      found += meanSquare(image, reference.image) - reference.meanSquare;
    }
    return std::sqrt(estimated / found);
  }
};

TEST_F(CalibrationTest, row38_the_meter_tells_the_true_error_in_every_kind_of_scene) {
  std::printf("estimate / true RMSE at samples per pixel\n%-24s %6s %6s %6s\n", "scene", "16", "64", "256");
  for (const FeatureScene& c : cases()) {
    const Reference truth = reference(c);
    double ratios[3];
    for (int i = 0; i < 3; ++i) {
      ratios[i] = calibration(c, 16 << (2 * i), truth);
      EXPECT_NEAR(ratios[i], 1.0, 0.1) << c.name << " at " << (16 << (2 * i)) << " samples";
      measured("distance of estimate / truth from 1", std::abs(ratios[i] - 1.0), 0.1);
    }
    std::printf("%-24s %6.3f %6.3f %6.3f\n", c.name, ratios[0], ratios[1], ratios[2]);
  }
}

}  // namespace
}  // namespace steradian
