// SPDX-License-Identifier: MIT
// A chart of curves over two logarithmic axes, as SVG.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace steradian::report {

/// x and y are drawn when positive; least and most bound the band of the first curve (0 = none).
struct ChartPoint {
  double x = 0.0, y = 0.0, least = 0.0, most = 0.0;
  std::string tip;  // shown under the pointer
};

struct ChartCurve {
  std::string label;
  std::vector<ChartPoint> points;
};

struct ChartAxis {
  std::string name;
  std::function<std::string(double)> label;  // of a tick
};

/// A law to compare with, through the first point of the first curve: its y over that point's y.
struct ChartGuide {
  std::string label;
  std::function<double(double x, double firstX)> ratio;
};

struct Chart {
  std::string title, subtitle;
  ChartAxis x, y;
  std::vector<ChartCurve> curves;  // the first is drawn strongest
  ChartGuide guide;                // without `ratio`: none
};

std::string svgOf(const Chart& chart);

}  // namespace steradian::report
