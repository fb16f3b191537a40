// SPDX-License-Identifier: MIT
// The layers beside the radiance: against closed forms, picking, and the film.
#include <set>

#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

class AovTest : public RendererTest {
 protected:
  Image aov(Aov kind, int samples = 16) {
    const std::vector<AovLayer> layers = renderer().aovs({{kind}, samples});
    EXPECT_EQ(layers.size(), 1u);
    EXPECT_EQ(layers[0].name, nameOf(kind));
    EXPECT_EQ(int(layers[0].channels.size()), layers[0].pixels.channels);
    return layers[0].pixels;
  }
};

TEST_F(AovTest, a_sphere_has_its_normals_depth_and_coverage) {
  Scene scene = plainScene(0);
  const dvec3 centre(0.5, 0.2, -6.0), eye(0.3, 0.1, 0.4);
  add(scene, at(centre), Sphere{1.5}, lambert({0.2f, 0.4f, 0.8f}));
  const int size = 32;
  const double fovY = 1.0;
  const CameraView view = lookAt(eye, {0, 0, -6}, fovY);
  renderer().setScene(scene, view, {size, size});
  const Image normal = aov(Aov::normal), depth = aov(Aov::depth), albedo = aov(Aov::albedo),
              coverage = aov(Aov::coverage, 64);
  int inside = 0;
  double area = 0.0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      area += *coverage.at(x, y);
      // The rectangle of directions that the box filter covers: exact at its middle up to its curvature.
      const double scale = 2.0 * std::tan(0.5 * fovY) / size;
      const dvec3 local(scale * (x + 0.5 - size / 2.0), scale * (size / 2.0 - y - 0.5), -1.0);
      const dvec3 d = glm::normalize(dvec3(view.worldFromCamera * glm::dvec4(local, 0.0)));
      const double along = glm::dot(centre - eye, d);
      const double off = glm::length(centre - eye - d * along);
      if (off > 1.7) {
        ASSERT_EQ(*coverage.at(x, y), 0.0f);
        ASSERT_TRUE(std::isinf(*depth.at(x, y)));
        ASSERT_EQ(albedo.at(x, y)[2], 0.0f);
        ASSERT_EQ(normal.at(x, y)[0], 0.0f);
      }
      if (off > 1.2) continue;
      ++inside;
      const double t = along - std::sqrt(1.5 * 1.5 - off * off);
      const dvec3 expected = (eye + d * t - centre) / 1.5;
      const float* n = normal.at(x, y);
      ASSERT_EQ(*coverage.at(x, y), 1.0f);
      ASSERT_NEAR(*depth.at(x, y), t, 0.02);
      ASSERT_LT(glm::length(dvec3(n[0], n[1], n[2]) - expected), 0.02);
      ASSERT_NEAR(albedo.at(x, y)[0], 0.2f, 1e-6);
      ASSERT_NEAR(albedo.at(x, y)[2], 0.8f, 1e-6);
    }
  EXPECT_GT(inside, 50);
  // The sphere's outline is an ellipse; here its area in pixels by the solid angle's exact image.
  const dvec3 axis = glm::normalize(dvec3(0, 0, -6) - eye), to = centre - eye;
  const double distance = glm::length(to), sine = 1.5 / distance;
  const double cosine = glm::dot(axis, to) / distance, scale = 2.0 * std::tan(0.5 * fovY) / size;
  // A cone of half angle a, its axis at angle b to the view, cuts the plane at distance 1 in an ellipse of
  // semi-axes sin a cos a / (cos^2 b - sin^2 a) and sin a / sqrt(cos^2 b - sin^2 a).
  const double q = cosine * cosine - sine * sine;
  const double ellipse = pi * sine * std::sqrt(1 - sine * sine) / q * sine / std::sqrt(q);
  EXPECT_NEAR(area * scale * scale, ellipse, 0.005 * ellipse);
}

TEST_F(AovTest, ids_are_those_that_picking_finds) {
  Scene scene = room(1);
  for (bool parallel : {false, true}) {
    CameraView view = roomView();
    if (parallel) view.lens.projection = Projection::orthographic, view.lens.orthographicHeight = 3.0;
    renderer().setScene(scene, view, {12, 12});
    const Image ids = aov(Aov::id);
    std::set<float> different(ids.pixels.begin(), ids.pixels.end());
    EXPECT_GE(different.size(), 3u);
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x) {
        const auto picked = renderer().pick(x, y);
        ASSERT_EQ(*ids.at(x, y), picked ? float(unsigned(picked->object)) : 0.0f);
      }
  }
}

TEST_F(AovTest, samples_and_variance_are_those_of_the_film) {
  Scene scene = room(3);
  scene.render.errorMeter = true;
  const Extent film{24, 24};
  render(scene, roomView(), film, 33);
  const Image samples = aov(Aov::samples), variance = aov(Aov::variance);
  for (const float n : samples.pixels) ASSERT_EQ(n, 33.0f);
  double sum = 0.0;
  for (const float v : variance.pixels) sum += v / double(variance.pixels.size());
  const double rmse = renderer().measureError().rmse;
  EXPECT_NEAR(std::sqrt(sum), rmse, 1e-4 * rmse);
  renderer().setSampleRange(0, 1);
  while (renderer().trace(50.0)) {
  }
  EXPECT_TRUE(std::isinf(aov(Aov::variance).pixels[0])) << "one sample says nothing";
  scene.render.errorMeter = false;
  render(scene, roomView(), film, 4);
  EXPECT_THROW(renderer().aovs({{Aov::variance}}), Error);
  EXPECT_EQ(aov(Aov::samples).pixels[0], 4.0f);
}

TEST_F(AovTest, layers_use_the_lens_and_the_filter_of_the_picture) {
  Scene scene = plainScene(0);
  add(scene, at({0, 0, -4}), Sphere{0.5}, emitter(1.0f));
  CameraView view = lookAt({0, 0, 0}, {0, 0, -1}, 0.5);
  view.lens.fNumber = 0.3;
  view.lens.focusDistance = 2.0;
  for (const PixelFilter filter : {PixelFilter::box, PixelFilter::blackmanHarris}) {
    scene.render.filter = filter;
    scene.render.errorMeter = false;
    const Image picture = render(scene, view, {16, 16}, 32);
    const Image coverage = aov(Aov::coverage, 32);
    // The lamp has radiance 1: the same rays give the same share.
    for (std::size_t i = 0; i < coverage.pixels.size(); ++i)
      ASSERT_NEAR(coverage.pixels[i], picture.pixels[i * 3], 1e-6);
  }
}

TEST_F(AovTest, an_empty_scene_covers_nothing) {
  renderer().setScene(plainScene(0), lookAt({0, 0, 0}, {0, 0, -1}, 0.5), {8, 8});
  for (const float v : aov(Aov::coverage).pixels) ASSERT_EQ(v, 0.0f);
  for (const float v : aov(Aov::id).pixels) ASSERT_EQ(v, 0.0f);
  EXPECT_TRUE(renderer().aovs({{}}).empty());
}

}  // namespace
}  // namespace steradian
