// SPDX-License-Identifier: MIT
// The display pass as it is shown and saved: the sRGB curve, and what every tonemapper must keep.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "plugins/host/tonemapper_file.hpp"
#include "renderer/display.hpp"
#include "renderer/gpu/barriers.hpp"
#include "renderer/gpu/buffer.hpp"
#include "tests/measured.hpp"
#include "tests/renderer/gpu/render_target.hpp"

namespace steradian {
namespace {

using gpu::QueueKind;

class DisplayPass : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    device_ = openDevice({});
    RecordProperty("device", device_->description().name);
  }
  static void TearDownTestSuite() {
    EXPECT_EQ(device_->validationMessages(), 0);
    device_.reset();
  }

  /// Each colour as the display pass encodes it, in rows of 1024 pixels.
  static std::vector<glm::vec3> show(const Tonemapper& tonemapper, const DisplaySettings& settings,
                                     const std::vector<glm::vec3>& colours) {
    const Extent extent{1024, int((colours.size() + 1023) / 1024)};
    std::vector<glm::vec4> pixels(std::size_t(extent.width) * std::size_t(extent.height), glm::vec4(0));
    for (std::size_t i = 0; i < colours.size(); ++i) pixels[i] = glm::vec4(colours[i], 1);
    gpu::Buffer resolved(*device_, gpu::BufferKind::upload, pixels.size() * sizeof(glm::vec4), "resolved");
    resolved.writeRows(0, std::span<const glm::vec4>(pixels));
    const gpu::Buffer* const storage[] = {nullptr, nullptr, nullptr, nullptr, &resolved};
    Display display(*device_);
    display.setTonemapper(tonemapper);
    display.setSettings(settings);
    const Image still = display.picture(resolved, extent);
    handOver(*device_, std::span(storage).last(1), QueueKind::compute, QueueKind::graphics);
    gpu::RenderTarget target(*device_, extent);
    const auto pass = display.pipeline(target.renderPass());
    const gpu::Bindings bindings(*device_, {}, storage);
    const Image image = target.render([&](const auto& cmd) {
      pass->draw(cmd, bindings, display.params(extent, target.rect()), target.rect());
    });
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      farthestStill_ = std::max(farthestStill_, std::fabs(double(image.pixels[i]) - double(still.pixels[i])));
    EXPECT_LE(farthestStill_, 1e-6) << "the window and the saved picture part: " << tonemapper.id;
    std::vector<glm::vec3> shown(colours.size());
    for (std::size_t i = 0; i < shown.size(); ++i)
      shown[i] = glm::vec3(image.pixels[3 * i], image.pixels[3 * i + 1], image.pixels[3 * i + 2]);
    return shown;
  }

  static std::shared_ptr<gpu::Device> device_;
  static inline double farthestStill_ = 0.0;  // between what is drawn and what is computed
};

std::shared_ptr<gpu::Device> DisplayPass::device_;

const Tonemapper identity{"identity", "vec3 tonemap(vec3 sceneLinear) { return sceneLinear; }", {}};

double srgb(double x) {  // IEC 61966-2-1
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

TEST_F(DisplayPass, row39_a_million_values_are_encoded_to_a_hundredth_of_a_code) {
  std::vector<glm::vec3> colours;
  for (int i = 0; i < 1 << 20; ++i) {
    const float x = float(i) / float((1 << 20) - 1);
    colours.emplace_back(x, x * x * x, std::exp2(-20.0f * x));  // even, and dense in the dark
  }
  const std::vector<glm::vec3> shown = show(identity, {}, colours);
  double worst = 0, worstGamma = 0;
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double curve = srgb(double(colours[i][c]));
      worst = std::max(worst, 255.0 * std::fabs(double(shown[i][c]) - curve));
      if (c == 2)
        worstGamma =
            std::max(worstGamma, 255.0 * std::fabs(std::pow(double(colours[i][c]), 1 / 2.2) - curve));
    }
  EXPECT_LE(worst, 0.01);
  measured("error of the sRGB curve, codes of 255", worst, 0.01);
  measured("drawn against saved", farthestStill_, 1e-6);
  EXPECT_GT(worstGamma, 8.0) << "a plain power of 2.2 is not the sRGB curve";
}

TEST_F(DisplayPass, row39_plain_gamma_and_exposure_do_what_they_say) {
  DisplaySettings settings;
  settings.transfer = Transfer::gamma;
  settings.exposure = 1.0f;
  const std::vector<glm::vec3> shown = show(identity, settings, {{0.1f, 0.25f, 0.0f}, {0.5f, 2.0f, 1e-4f}});
  EXPECT_NEAR(shown[0].x, std::pow(0.2, 1 / 2.2), 1e-4);
  EXPECT_NEAR(shown[0].y, std::pow(0.5, 1 / 2.2), 1e-4);
  EXPECT_EQ(shown[0].z, 0.0f);
  EXPECT_NEAR(shown[1].x, 1.0, 1e-6);
  EXPECT_EQ(shown[1].y, 1.0f);
  measured("error of a power of 1/2.2", std::fabs(double(shown[0].x) - std::pow(0.2, 1 / 2.2)), 1e-4);
}

/// Every tonemapper of the product, with its parameters at their defaults.
std::vector<Tonemapper> tonemappers() {
  std::vector<Tonemapper> all;
  for (const auto& folder : std::filesystem::directory_iterator(STERADIAN_TONEMAPPER_SOURCES)) {
    const auto file = folder.path() / (folder.path().filename().string() + ".glsl");
    if (!std::filesystem::exists(file)) continue;
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    const plugins::Contribution parsed = plugins::parseTonemapper(text.str());
    Tonemapper tonemapper{parsed.id, text.str(), {}};
    for (const auto& p : parsed.parameters) tonemapper.parameters.push_back({p.id, float(p.defaultValue)});
    all.push_back(tonemapper);
  }
  return all;
}

TEST_F(DisplayPass, physical_exposure_saturates_at_1_2_times_2_to_the_ev100) {
  DisplaySettings settings{.physical = true, .ev100 = 15.0f, .transfer = Transfer::gamma, .gamma = 1.0f};
  const float white = 1.2f * 32768.0f;
  const std::vector<glm::vec3> nit{glm::vec3(white), glm::vec3(white / 4), glm::vec3(0)};
  const auto shown = show(identity, settings, nit);
  EXPECT_NEAR(shown[0].x, 1.0f, 1e-6f);
  EXPECT_NEAR(shown[1].y, 0.25f, 1e-6f);
  EXPECT_EQ(shown[2].z, 0.0f);
  settings.exposure = 1.0f;  // the stops come on top
  EXPECT_NEAR(show(identity, settings, nit)[1].x, 0.5f, 1e-6f);
  settings.physical = false;  // the EV of an exposure that is off changes nothing
  EXPECT_NEAR(show(identity, settings, {glm::vec3(0.25f)})[0].x, 0.5f, 1e-6f);
}

TEST_F(DisplayPass, every_tonemapper_maps_black_to_black_and_greys_in_order) {
  const std::vector<Tonemapper> all = tonemappers();
  ASSERT_GE(all.size(), 6u);
  std::vector<glm::vec3> greys = {glm::vec3(0)};
  for (int i = 0; i < 1 << 14; ++i) greys.emplace_back(std::exp2(-20.0f + 36.0f * float(i) / float(1 << 14)));
  for (const Tonemapper& tonemapper : all) {
    const std::vector<glm::vec3> shown = show(tonemapper, {}, greys);
    EXPECT_EQ(shown[0], glm::vec3(0)) << tonemapper.id;
    float brightest = 0;
    for (std::size_t i = 1; i < shown.size(); ++i) {
      for (int c = 0; c < 3; ++c)
        ASSERT_GE(shown[i][c], shown[i - 1][c] - 2e-6f) << tonemapper.id << " at " << greys[i].x;
      brightest = std::max(brightest, shown[i].x);
    }
    EXPECT_GT(brightest, 0.95f) << tonemapper.id;
  }
}

TEST_F(DisplayPass, every_tonemapper_is_finite_for_infinity_and_nan) {
  const float inf = INFINITY, nan = NAN;
  const std::vector<glm::vec3> colours = {
      {0, 0, 0},     {65504, 65504, 65504}, {inf, inf, inf}, {nan, nan, nan}, {inf, 0, 0},  {0, nan, 1},
      {65504, 0, 0}, {0, 0, 65504},         {1e38f, 1, 1},   {-1, -1, -1},    {-inf, 1, 0}, {1e-38f, 0, 0}};
  for (const Tonemapper& tonemapper : tonemappers()) {
    const std::vector<glm::vec3> shown = show(tonemapper, {}, colours);
    for (std::size_t i = 0; i < shown.size(); ++i)
      for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(shown[i][c] >= 0.0f && shown[i][c] <= 1.0f) << tonemapper.id << " of colour " << i;
    EXPECT_EQ(shown[3], glm::vec3(0)) << tonemapper.id << ": a lost sample is black";
    EXPECT_GT(shown[2].x, 0.95f) << tonemapper.id << ": infinity is bright";
  }
}

const Tonemapper& named(const std::vector<Tonemapper>& all, const std::string& id) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Tonemapper& t) { return t.id == id; });
  if (found == all.end()) throw std::runtime_error("no tonemapper " + id);
  return *found;
}

TEST_F(DisplayPass, white_points_become_one) {
  const std::vector<Tonemapper> all = tonemappers();
  EXPECT_NEAR(show(named(all, "org.steradian.tonemap.linear"), {}, {glm::vec3(1)})[0].x, 1.0f, 1e-6);
  const Tonemapper& reinhard = named(all, "org.steradian.tonemap.reinhard_luminance");
  for (const float white : {2.0f, 4.0f, 16.0f}) {
    DisplaySettings settings;
    settings.parameters["whitePoint"] = white;
    const auto shown = show(reinhard, settings, {glm::vec3(white), glm::vec3(0.5f * white)});
    EXPECT_NEAR(shown[0].x, 1.0f, 1e-5) << white;
    EXPECT_LT(shown[1].x, 0.99f) << white;
  }
}

/// Display-linear value of what was shown.
double decoded(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92 : std::pow((double(encoded) + 0.055) / 1.055, 2.4);
}

TEST_F(DisplayPass, row42_20_reinhard_on_luminance_keeps_the_hue_and_per_channel_does_not) {
  const std::vector<Tonemapper> all = tonemappers();
  const glm::vec3 orange(2.0f, 0.5f, 0.1f);
  const auto ratio = [](glm::vec3 shown) { return decoded(shown.y) / decoded(shown.z); };
  const auto byLuminance = show(named(all, "org.steradian.tonemap.reinhard_luminance"), {}, {orange})[0];
  const auto byChannel = show(named(all, "org.steradian.tonemap.reinhard"), {}, {orange})[0];
  EXPECT_NEAR(ratio(byLuminance), 5.0, 1e-3);
  measured("shift of a ratio of channels", std::fabs(ratio(byLuminance) - 5.0), 1e-3);
  EXPECT_LT(ratio(byChannel), 4.0);
}

TEST_F(DisplayPass, row42_19_the_curve_is_not_a_power) {
  const float shown = show(identity, {}, {glm::vec3(0.0022f)})[0].x;
  EXPECT_NEAR(255 * shown, 255 * 12.92 * 0.0022, 0.01);
  measured("error of the sRGB curve, codes of 255", std::fabs(255 * double(shown) - 255 * 12.92 * 0.0022),
           0.01);
  EXPECT_NEAR(255 * std::pow(0.0022, 1 / 2.2) - 255 * shown, 8.55, 0.1) << "printed: x^(1/2.2)";
}

}  // namespace
}  // namespace steradian
