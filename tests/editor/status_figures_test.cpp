// SPDX-License-Identifier: MIT
// What the status bar says, and what gives way in a narrow window.
#include "editor/ui/status_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace steradian::ui {
namespace {

/// A picture on its way: 2 % at 256 samples, falling as samples^-1/2.
struct Status {
  DeviceDescription device{.name = "llvmpipe (LLVM 15.0.6, 256 bits)", .type = "CPU"};
  RenderStats stats;
  Goal goal{.target = 0.01, .measuredAt = 256, .secondsPerSample = 0.02};
  bool paused = false, resting = false;

  Status() {
    stats.samples = 300;
    stats.msPerSample = 12.5;
    stats.mraysPerSecond = 3.2;
    stats.error = {.rmse = 0.0123, .relRmse = 0.02, .slope = -0.5, .valid = true, .doublings = 4};
  }
  StatusInput input() const { return {device, stats, goal, paused, resting}; }
  /// Nothing when there is no such figure.
  std::optional<StatusFigure> figure(const std::string& label) const {
    for (const StatusFigure& f : statusFigures(input()))
      if (f.label == label) return f;
    return std::nullopt;
  }
  std::string text(const std::string& label) const { return figure(label).value().forms.front(); }
};

TEST(StatusFigures, foresee_when_the_target_is_met) {
  Status status;  // needs 4 * 256 samples, has 300
  EXPECT_EQ(status.text("outlook"), "1 % in 14 s, slope -0.50");
  status.stats.error.slope = -1.0;  // 2 * 256
  EXPECT_EQ(status.text("outlook"), "1 % in 4 s, slope -1.00");
  status.goal.target = 0.005;  // 4 * 256
  EXPECT_EQ(status.text("outlook"), "0.5 % in 14 s, slope -1.00");
  status.stats.error.relRmse = 0.005;
  EXPECT_EQ(status.text("outlook"), "0.5 % reached, slope -1.00");
}

TEST(StatusFigures, promise_no_time_where_no_samples_come) {
  Status status;
  status.goal.sampleLimit = 512;
  EXPECT_EQ(status.text("outlook"), "1 % at 1,000 samples, slope -0.50");
  status.goal.sampleLimit = 4096;
  EXPECT_EQ(status.text("outlook"), "1 % in 14 s, slope -0.50");
  status.paused = true;
  EXPECT_EQ(status.text("outlook"), "1 % at 1,000 samples, slope -0.50");
  status.stats.error.doublings = 1;  // of two points no slope is told
  EXPECT_EQ(status.text("outlook"), "1 % at 1,000 samples");
  status.stats.error.valid = false;
  EXPECT_FALSE(status.figure("outlook"));
}

TEST(StatusFigures, warn_of_fireflies_in_a_full_sentence) {
  Status status;
  EXPECT_FALSE(status.figure("fireflies"));
  status.stats.error.tails = {.share = 0.62, .pixels = 922, .heavy = true};
  EXPECT_EQ(status.text("fireflies"), "fireflies: 62 % in 922 pixels");
  EXPECT_NE(status.figure("fireflies")->help.find("922 pixels carry 62 % of the squared error"),
            std::string::npos);
}

TEST(StatusFigures, show_what_the_clamp_removed_only_while_it_is_on) {
  Status status;
  EXPECT_FALSE(status.figure("clamp"));
  status.stats.clampedShare = 0.032;
  EXPECT_EQ(status.text("clamp"), "clamp -3.2 %");
  EXPECT_NE(status.figure("clamp")->help.find("the clamp removed 3.2 % of the light"), std::string::npos);
  status.stats.clampedShare = 0.0;
  EXPECT_TRUE(status.figure("clamp"));
}

TEST(StatusFigures, give_way_in_order_and_keep_what_matters) {
  Status status;
  status.stats.clampedShare = 0.032;
  status.stats.error.tails = {.share = 0.62, .pixels = 922, .heavy = true};
  const std::vector<StatusFigure> figures = statusFigures(status.input());
  const auto letters = [](const std::string& text) { return float(text.size()); };
  const auto widthOf = [](const std::vector<std::string>& shown) {
    std::size_t sum = 0;
    for (const std::string& text : shown) sum += text.empty() ? 0 : text.size() + 2;
    return float(sum) - 2.0f;
  };
  const auto shows = [](const std::vector<std::string>& shown, const std::string& text) {
    return std::count(shown.begin(), shown.end(), text) == 1;
  };
  const auto all = fittedForms(figures, 1000, 2, letters);
  for (std::size_t i = 0; i < figures.size(); ++i) EXPECT_EQ(all[i], figures[i].forms.front());
  for (float width = widthOf(all); width >= 90; --width)
    EXPECT_LE(widthOf(fittedForms(figures, width, 2, letters)), width);
  const auto brief = fittedForms(figures, widthOf(all) - 1, 2, letters);
  EXPECT_TRUE(shows(brief, "llvmpipe"));
  EXPECT_TRUE(shows(brief, "1 % in 14 s, slope -0.50"));
  const auto least = fittedForms(figures, 0, 2, letters);
  for (const char* text : {"rendering", "300 samples", "error 2.0 %", "1 % in 14 s", "fireflies",
                           "clamp -3.2 %", "NaN 0", "CPU"})
    EXPECT_TRUE(shows(least, text)) << text;
}

}  // namespace
}  // namespace steradian::ui
