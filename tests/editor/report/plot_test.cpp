// SPDX-License-Identifier: MIT
// Axes, labels, tables and the SVG's promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "editor/report/plot_axis.hpp"
#include "editor/report/report.hpp"

using namespace steradian;
using namespace steradian::report;

namespace {

Curve curve(const char* label, double start, double exponent, double msPerSample, int points = 9) {
  std::vector<std::vector<Sample>> runs(3);
  for (std::size_t r = 0; r < 3; ++r)
    for (int i = 0; i < points; ++i) {
      const double n = double(1u << i);
      const double e = start * std::pow(n, exponent) * (1.0 + 0.06 * (double(r) - 1.0));
      runs[r].push_back({std::uint64_t(n), n * msPerSample * 1e-3, e * e * 0.1, e * e, e * 0.3, e * 0.32});
    }
  return curveOf(label, label, runs);
}

Report sampleReport() {
  Report report;
  report.version = "0.1.0";
  report.command = "steradian report projects/cornell --ablate";
  SceneReport scene{"Cornell <box> & more", "projects/cornell", {}, {256, 192}, 3, 16384, 0.0021, {}};
  scene.device.name = "llvmpipe (LLVM 15.0.6, 256 bits)";
  scene.device.driver = "Mesa 22.3.6";
  scene.curves = {curve("Steradian", 0.9, -0.66, 9.0),
                  curve("one joint sequence", 0.9, -0.72, 9.0),
                  curve("no Russian roulette", 0.89, -0.66, 11.5),
                  curve("generic pipeline", 0.9, -0.66, 14.0),
                  curve("PCG instead of Owen-Sobol", 0.92, -0.5, 8.8),
                  curve("no light sampling", 3.9, -0.49, 6.0)};
  report.scenes = {scene};
  return report;
}

}  // namespace

TEST(LogAxis, puts_values_where_their_logarithms_are_and_labels_the_decades) {
  const LogAxis axis(0.1, 1000.0, 100.0, 500.0);
  EXPECT_DOUBLE_EQ(axis(0.1), 100.0);
  EXPECT_DOUBLE_EQ(axis(10.0), 300.0);
  EXPECT_DOUBLE_EQ(axis(1000.0), 500.0);
  const auto ticks = axis.ticks();
  EXPECT_EQ(std::count_if(ticks.begin(), ticks.end(), [](const Tick& t) { return t.labelled; }), 5);
  const auto brief = LogAxis(0.15, 6.0, 0.0, 1.0).ticks();  // 0.2 0.5 1 2 5
  EXPECT_EQ(std::count_if(brief.begin(), brief.end(), [](const Tick& t) { return t.labelled; }), 5);
}

TEST(LogAxis, speaks_of_seconds_and_percent) {
  EXPECT_EQ(secondsLabel(0.002), "2 ms");
  EXPECT_EQ(secondsLabel(0.1), "0.1 s");
  EXPECT_EQ(secondsLabel(100.0), "100 s");
  EXPECT_EQ(percentLabel(0.005), "0.5 %");
}

TEST(Labels, are_spread_apart_and_stay_in_order_and_in_the_picture) {
  const auto placed = spreadApart({100, 101, 99, 300, 497}, 20, 0, 500);
  EXPECT_EQ(placed, (std::vector<double>{100, 120, 80, 300, 497}));
  const auto crowded = spreadApart({495, 496, 497}, 20, 0, 500);
  EXPECT_EQ(crowded, (std::vector<double>{460, 480, 500}));
  EXPECT_EQ(spreadApart({5, 6}, 20, 0, 500), (std::vector<double>{0, 20}));
}

TEST(Plot, names_every_curve_once_at_its_end_and_escapes_text) {
  const Report report = sampleReport();
  const std::string svg = svgOf(report.scenes[0], PlotOver::seconds);
  if (const char* folder = std::getenv("STERADIAN_TEST_OUTPUT"))  // to look at it
    std::ofstream(std::string(folder) + "/plot.svg") << svg;
  for (const Curve& c : report.scenes[0].curves) {
    const auto at = svg.find(">" + c.label + "</text>");
    EXPECT_NE(at, std::string::npos) << c.label;
    EXPECT_EQ(svg.find(">" + c.label + "</text>", at + 1), std::string::npos);
  }
  EXPECT_NE(svg.find("Cornell &lt;box&gt; &amp; more"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_NE(svg.find("prefers-color-scheme: dark"), std::string::npos);
}

TEST(Plot, over_samples_leaves_out_what_differs_in_speed_alone) {
  const SceneReport scene = sampleReport().scenes[0];
  const std::string svg = svgOf(scene, PlotOver::samples);
  if (const char* folder = std::getenv("STERADIAN_TEST_OUTPUT"))  // to look at it
    std::ofstream(std::string(folder) + "/plot-samples.svg") << svg;
  EXPECT_NE(svg.find("error against samples"), std::string::npos);
  EXPECT_NE(svg.find(">samples per pixel</text>"), std::string::npos);
  EXPECT_NE(svg.find(">100</text>"), std::string::npos);
  for (const Curve& c : scene.curves)
    EXPECT_EQ(svg.find(">" + c.label + "</text>") == std::string::npos, c.label == "generic pipeline")
        << c.label;
  EXPECT_NE(svgOf(scene, PlotOver::seconds).find(">generic pipeline</text>"), std::string::npos);
}

TEST(Plot, of_nothing_or_of_no_error_is_still_a_picture) {
  SceneReport scene{"empty", "", {}, {1, 1}, 1, 1, 0.0, {}};
  EXPECT_NE(svgOf(scene, PlotOver::seconds).find("</svg>"), std::string::npos);
  scene.curves = {curveOf("a", "a", {{{1, 0.1, 0.0, 0.0, 0.0, 0.0}}})};
  const std::string svg = svgOf(scene, PlotOver::seconds);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(Report, is_a_table_for_people_and_json_for_programs) {
  const Report report = sampleReport();
  const std::string table = markdownOf(report, {{"cornell.svg", "cornell-samples.svg"}});
  EXPECT_NE(table.find("![Error against time](cornell.svg)"), std::string::npos);
  EXPECT_NE(table.find("![Error against samples](cornell-samples.svg)"), std::string::npos);
  EXPECT_NE(table.find("| PCG instead of Owen-Sobol | 256 | 2.25 s | 5.75 % |"), std::string::npos) << table;
  EXPECT_NE(table.find("    steradian report projects/cornell --ablate"), std::string::npos);
  const auto json = nlohmann::json::parse(jsonOf(report));
  const auto& variant = json["scenes"][0]["variants"][4];
  EXPECT_NEAR(variant["slopeOverSamples"].get<double>(), -0.5, 1e-9);
  EXPECT_EQ(variant["points"].size(), 9u);
  EXPECT_TRUE(variant["extrapolated"].get<bool>());
  EXPECT_NEAR(variant["secondsTo1Percent"].get<double>(), 0.92 * 0.92 * 1e4 * 8.8e-3, 1e-6);
}

TEST(Duration, is_short) {
  EXPECT_EQ(shortDuration(0.0123), "12.3 ms");
  EXPECT_EQ(shortDuration(2.345), "2.35 s");
  EXPECT_EQ(shortDuration(125.0), "2 min 05 s");
  EXPECT_EQ(shortDuration(7200.0), "2 h");
}
