// SPDX-License-Identifier: MIT
// What cameras show: sizes in parallel projection, and how sharp a thin lens is near and far.
#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

class CameraTest : public RendererTest {
 protected:
  /// Light of a picture and how far it lies from its centre: sum, and root mean square distance in pixels.
  struct Spot {
    double light = 0.0, spread = 0.0, x = 0.0, y = 0.0;
  };
  static Spot spotOf(const Image& image) {
    Spot spot;
    double squares = 0.0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const double v = image.at(x, y)[0];
        spot.light += v, spot.x += v * (x + 0.5), spot.y += v * (y + 0.5);
        squares += v * ((x + 0.5) * (x + 0.5) + (y + 0.5) * (y + 0.5));
      }
    spot.x /= spot.light, spot.y /= spot.light;
    spot.spread = std::sqrt(std::max(0.0, squares / spot.light - spot.x * spot.x - spot.y * spot.y));
    return spot;
  }
};

CameraView parallelView(const dvec3& eye, const dvec3& target, double height) {
  CameraView view = lookAt(eye, target, 0.7);
  view.lens.projection = Projection::orthographic;
  view.lens.orthographicHeight = height;
  return view;
}

/// fNumber for a lens of radius `metres`; the field of view decides its focal length.
CameraView lensView(const dvec3& eye, const dvec3& target, double fovY, double metres, double focus) {
  CameraView view = lookAt(eye, target, fovY);
  const double focalLength = 0.5 * kSensorHeightMetres / std::tan(0.5 * fovY);
  view.lens.fNumber = focalLength / (2.0 * metres);
  view.lens.focusDistance = focus;
  return view;
}

TEST_F(CameraTest, parallel_projection_keeps_sizes_at_every_depth) {
  for (const double depth : {2.0, 10.0, 1000.0}) {
    Scene scene = plainScene(0);
    add(scene, at({0, 0, -depth}), Sphere{1.0}, emitter(1.0f));
    const Image image = render(scene, parallelView({0, 0, 0}, {0, 0, -1}, 4.0), {64, 48}, 64);
    const double pixel = 4.0 / 48.0;
    // Area of the disc of radius 1 m.
    EXPECT_NEAR(spotOf(image).light * pixel * pixel, pi, 0.002 * pi) << depth;
    EXPECT_NEAR(spotOf(image).x, 32.0, 0.01);
    EXPECT_NEAR(spotOf(image).y, 24.0, 0.01);
  }
}

TEST_F(CameraTest, picking_works_in_parallel_projection) {
  Scene scene = plainScene(0);
  const Id id = add(scene, at({100.5, 0.75, -30}), Sphere{0.2}, Material{});
  renderer().setScene(scene, parallelView({100, 0, 5}, {100, 0, 0}, 3.0), {30, 30});
  const auto picked = renderer().pick(20, 7);  // +0.5 m to the right, +0.75 m up, 0.1 m per pixel
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->object, id);
  EXPECT_NEAR(picked->position.x, 100.55, 1e-5);
  EXPECT_NEAR(picked->position.y, 0.75, 1e-5);
  EXPECT_NEAR(picked->distance, 35.0 - std::sqrt(0.04 - 0.0025), 1e-5);
  EXPECT_FALSE(renderer().pick(15, 15));
}

TEST_F(CameraTest, a_point_out_of_focus_becomes_the_circle_of_confusion) {
  const double radius = 0.1, focus = 2.0, fovY = 0.15;
  const double pixel = 2.0 * std::tan(0.5 * fovY) / 32.0;
  for (const double depth : {1.0, 4.0, 100.0}) {
    SCOPED_TRACE(depth);
    Scene scene = plainScene(0);
    const double size = 1.5 * pixel * depth;  // a small lamp, 3 pixels wide
    add(scene, at({0, 0, -depth}), Sphere{size}, emitter(1.0f));
    const Image blurred = render(scene, lensView({0, 0, 0}, {0, 0, -1}, fovY, radius, focus), {32, 32}, 1024);
    const Image sharp = render(scene, lookAt({0, 0, 0}, {0, 0, -1}, fovY), {32, 32}, 256);
    const double circle = radius * std::abs(depth - focus) / (focus * depth) / pixel;  // its radius, pixels
    ASSERT_LT(circle, 12.0);
    const Spot spot = spotOf(blurred), point = spotOf(sharp);
    // Blur adds the square spread of an even disc, r^2 / 2, and keeps the light.
    EXPECT_NEAR(spot.light, point.light, 0.03 * point.light);
    EXPECT_NEAR(spot.spread * spot.spread - point.spread * point.spread, 0.5 * circle * circle,
                0.03 * 0.5 * circle * circle);
  }
}

TEST_F(CameraTest, the_plane_in_focus_is_as_sharp_as_through_a_pinhole) {
  const double fovY = 0.5, focus = 3.0;
  Scene scene = plainScene(0);
  // A lit rectangle in the plane in focus, away from the axis, edges along the borders of pixels.
  const double pixel = focus * 2.0 * std::tan(0.5 * fovY) / 32.0;
  const Transform place{{5 * pixel, 3 * pixel, -focus}, facing({0, -1, 0}), dvec3(1.0)};
  add(scene, place, Rect{{8 * pixel, 6 * pixel}}, emitter(1.0f));
  const Image open = render(scene, lensView({0, 0, 0}, {0, 0, -1}, fovY, 0.2, focus), {32, 32}, 64);
  const Image pinhole = render(scene, lookAt({0, 0, 0}, {0, 0, -1}, fovY), {32, 32}, 64);
  double worst = 0.0;
  for (std::size_t i = 0; i < open.pixels.size(); ++i)
    worst = std::max(worst, std::abs(double(open.pixels[i]) - pinhole.pixels[i]));
  EXPECT_LT(worst, 0.05);
  EXPECT_NEAR(spotOf(pinhole).light, 48.0, 0.5);
}

TEST_F(CameraTest, a_closed_lens_gives_the_pinhole_picture_to_the_byte) {
  Scene scene = room(3);
  CameraView closed = roomView();
  closed.lens.fNumber = 0.0;
  closed.lens.focusDistance = 1.7;
  EXPECT_TRUE(render(scene, closed, {16, 16}, 8) == render(scene, roomView(), {16, 16}, 8));
  closed.lens.fNumber = 0.05;
  EXPECT_FALSE(render(scene, closed, {16, 16}, 8) == render(scene, roomView(), {16, 16}, 8))
      << "the test must bite";
}

}  // namespace
}  // namespace steradian
