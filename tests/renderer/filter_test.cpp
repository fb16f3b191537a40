// SPDX-License-Identifier: MIT
// How a sharp edge spreads over pixels tells the pixel filter's integral.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

/// Blackman-Harris window (Harris 1978), 4 pixels wide, not normalized.
double window(double x) {
  const double turn = 2.0 * pi * (x + 2.0) / 4.0;
  return 0.35875 - 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) - 0.01168 * std::cos(3 * turn);
}

double windowIntegral(double from, double to) {
  const int steps = 4000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) sum += window(from + (to - from) * (i + 0.5) / steps);
  return sum * (to - from) / steps;
}

/// Share of a pixel's filter that lies right of an edge `distance` pixels right of its centre.
double blackmanHarrisShare(double distance) {
  if (distance >= 2.0) return 0.0;
  if (distance <= -2.0) return 1.0;
  return windowIntegral(distance, 2.0) / windowIntegral(-2.0, 2.0);
}

constexpr int size = 16;

class FilterTest : public RendererTest {
 protected:
  /// The mean of each column; everything right of the film's middle, moved by `shift` pixels, shines with 1
  /// nit.
  std::vector<double> edgeProfile(PixelFilter filter, double shift) {
    Scene scene = plainScene(0);
    scene.render.filter = filter;
    const double pixel = 2.0 * std::tan(0.5) / size;  // at distance 1
    add(scene, at({10.0 + shift * pixel, 0, -1}, {1, 0, 0}, pi / 2), Rect{{20, 20}}, emitter(1.0f));
    const Image image = render(scene, lookAt({0, 0, 0}, {0, 0, -1}, 1.0), {size, size}, 256);
    std::vector<double> columns(size);
    for (int i = 0; i < size * size; ++i) columns[i % size] += *image.at(i % size, i / size) / size;
    return columns;
  }
};

TEST_F(FilterTest, BoxIsOnePixelWide) {
  for (const bool special : {false, true}) {
    renderer().allowSpecialization(special);
    const std::vector<double> columns = edgeProfile(PixelFilter::box, 0.25);
    for (int x = 0; x < size; ++x)
      EXPECT_NEAR(columns[x], x < size / 2 ? 0.0 : x == size / 2 ? 0.75 : 1.0, 0.002) << x;
  }
}

TEST_F(FilterTest, BlackmanHarrisSpreadsOverFourPixels) {
  for (const double shift : {0.0, 0.3}) {
    const std::vector<double> columns = edgeProfile(PixelFilter::blackmanHarris, shift);
    for (int x = 0; x < size; ++x)
      EXPECT_NEAR(columns[x], blackmanHarrisShare(size / 2 + shift - (x + 0.5)), 0.004) << x;
  }
}

}  // namespace
}  // namespace steradian
