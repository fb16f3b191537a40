// SPDX-License-Identifier: MIT
// White metal in a uniform furnace. Energy compensation is off here, the material is single-scatter GGX,
// so a rough ball is darker than its surroundings by exactly the directional albedo, which is integrated here
// on its own: Walter et al. 2007 in tan^2 form over half vectors, double precision, no code shared with the
// shaders.
#include <array>
#include <functional>

#include "tests/renderer/renderer_fixture.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian {
namespace {

using namespace scenes;

double lambda(double cosine, double alpha) {
  const double tan2 = (1.0 - cosine * cosine) / (cosine * cosine);
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2) - 1.0);
}

/// Directional albedo with F = 1: integral over h of G2 D 4 (v.h) / (4 n.v n.l) n.l, where D dh is drawn by
/// its own inverse, tan^2 = alpha^2 u / (1 - u), so that the integrand left over is smooth.
double albedo(double mu, double alpha) {
  const int steps = 400, turns = 128;
  const dvec3 v(std::sqrt(1.0 - mu * mu), 0.0, mu);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps, tan2 = alpha * alpha * u / (1.0 - u);
    const double cosine = 1.0 / std::sqrt(1.0 + tan2), sine = std::sqrt(1.0 - cosine * cosine);
    for (int j = 0; j < turns; ++j) {
      const double phi = pi * (j + 0.5) / turns;  // the other half is its mirror image
      const dvec3 h(sine * std::cos(phi), sine * std::sin(phi), cosine);
      const double vh = glm::dot(v, h), nl = 2.0 * vh * h.z - mu;
      if (vh <= 0.0 || nl <= 0.0) continue;
      sum += vh / (mu * cosine) / (1.0 + lambda(mu, alpha) + lambda(nl, alpha));
    }
  }
  return sum / (double(steps) * turns);
}

/// A reflectance over mu in [0.05, 1], interpolated.
class AlbedoTable {
 public:
  explicit AlbedoTable(const std::function<double(double)>& reflectance) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = reflectance(muOf(i));
  }
  double at(double mu) const {
    const double x = (mu - 0.05) / 0.95 * double(values_.size() - 1);
    const std::size_t i = std::min(std::size_t(x), values_.size() - 2);
    return values_[i] + (x - double(i)) * (values_[i + 1] - values_[i]);
  }

 private:
  double muOf(std::size_t i) const { return 0.05 + 0.95 * double(i) / double(values_.size() - 1); }
  std::array<double, 48> values_;
};

constexpr int size = 32;
constexpr double halfWidth = 0.75, distance = 1e3;  // of the film around the ball of radius 1, which fills it

/// Mean of the table over one pixel of the almost parallel view.
double expectedAt(const AlbedoTable& table, int x, int y) {
  double sum = 0.0;
  for (int i = 0; i < 16; ++i) {
    const double px = ((x + (i % 4 + 0.5) / 4) / size * 2 - 1) * halfWidth;
    const double py = ((y + (i / 4 + 0.5) / 4) / size * 2 - 1) * halfWidth;
    sum += table.at(std::sqrt(std::max(1.0 - px * px - py * py, 0.0025)));
  }
  return sum / 16.0;
}

class FurnaceTest : public RendererTest {
 protected:
  Image ball(const Material& material, int bounces, int samples) {
    Scene scene = plainScene(bounces);
    scene.render.energyCompensation = false;
    add(scene, at({0, 0, 0}), Sphere{1.0}, material);
    add(scene, at({0, 0, 0}), Sphere{4.0 * distance}, emitter(1.0f));
    return render(scene, lookAt({0, 0, distance}, {0, 0, 0}, 2.0 * std::atan(halfWidth / distance)),
                  {size, size}, samples);
  }
};

TEST(FurnaceReference, ReproducesTheClosedFormOfFullRoughness) {
  EXPECT_NEAR(albedo(1.0, 1.0), 1.0 - std::log(2.0), 1e-4);
  EXPECT_NEAR(albedo(1.0, 0.25), 0.915812, 1e-4);
}

TEST_F(FurnaceTest, row23_white_metal_reflects_its_single_scatter_albedo) {
  for (const float roughness : {0.1f, 0.3f, 0.5f, 0.7f, 1.0f}) {
    SCOPED_TRACE(roughness);
    const AlbedoTable table([&](double mu) { return albedo(mu, double(roughness) * roughness); });
    const Image image = ball(metal(roughness), 1, 256);
    std::vector<double> ratio, facing, grazing;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const double value = *image.at(x, y) / expectedAt(table, x, y);
        ratio.push_back(value);
        (std::hypot(x - 15.5, y - 15.5) < 10.0 ? facing : grazing).push_back(value);
      }
    for (const auto* part : {&ratio, &facing, &grazing}) {
      const Mean mean = meanOf(*part);
      EXPECT_NEAR(mean.value, 1.0, 0.005);
      EXPECT_LT(mean.sigma, 0.002);
      measured("relative error of the albedo", std::abs(mean.value - 1.0), 0.005);
    }
  }
}

TEST_F(FurnaceTest, row23_metal_and_matt_never_reflect_more_than_they_receive) {
  for (const float roughness : {0.0f, 0.02f, 0.05f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f})
    for (const Material& material : {metal(roughness), lambert(glm::vec3(1.0f))}) {
      SCOPED_TRACE(testing::Message() << "roughness " << roughness << ", metallic " << material.metallic);
      const Mean mean = meanOf(ball(material, 2, 128));
      EXPECT_LT(mean.value, 1.0 + 1e-5 + 3.0 * mean.sigma);
      EXPECT_GT(mean.value, 0.3);
      measured("gain", mean.value - 1.0, 1e-5 + 3.0 * mean.sigma);
    }
}

/// Reflectance of a smooth white dielectric as glTF 2.0 (appendix B) mixes it: mirror F(v.n), Lambert 1 -
/// F(v.h). Towards grazing it exceeds 1, for the mix takes from the diffuse part by v.h what it gives the
/// mirror by v.n.
double smoothDielectric(double mu) {
  const int steps = 200, turns = 64;
  const auto schlick = [](double cosine) { return 0.04 + 0.96 * std::pow(1.0 - cosine, 5); };
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < turns; ++j) {
      const double u = (i + 0.5) / steps, phi = pi * (j + 0.5) / turns;
      const double vl = std::sqrt((1.0 - mu * mu) * u) * std::cos(phi) + mu * std::sqrt(1.0 - u);
      sum += 1.0 - schlick(std::sqrt(0.5 * (1.0 + vl)));
    }
  return schlick(mu) + sum / (double(steps) * turns);
}

TEST_F(FurnaceTest, row23_smooth_dielectric_reflects_what_the_gltf_mix_defines) {
  const AlbedoTable table(smoothDielectric);
  std::vector<double> ratio;
  const Image image = ball(plastic(0.0f, glm::vec3(1.0f)), 1, 512);
  for (int i = 0; i < size * size; ++i)
    ratio.push_back(*image.at(i % size, i / size) / expectedAt(table, i % size, i / size));
  const Mean mean = meanOf(ratio);
  EXPECT_NEAR(mean.value, 1.0, 0.005);
  EXPECT_LT(mean.sigma, 0.002);
  measured("relative error of the albedo", std::abs(mean.value - 1.0), 0.005);
}

TEST_F(FurnaceTest, row23_white_mirror_and_white_matt_balls_vanish) {
  for (const float value : ball(metal(0.0f), 1, 16).pixels) ASSERT_NEAR(value, 1.0f, 1e-5f);
  // The light around is sampled as well, which has noise.
  const Mean matt = meanOf(ball(lambert(glm::vec3(1.0f)), 1, 64));
  expectMean(matt, 1.0, 0.001);
  EXPECT_LT(matt.sigma, 1e-3);
}

}  // namespace
}  // namespace steradian
