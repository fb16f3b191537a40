// SPDX-License-Identifier: MIT
// Its own colours for light and dark, no script, no fonts to fetch.
#include "editor/report/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "editor/cli/console.hpp"
#include "editor/report/plot_axis.hpp"

namespace steradian::report {

namespace {

constexpr double kWidth = 880, kHeight = 520;
constexpr double kLeft = 92, kRight = 660, kTop = 78, kBottom = 446;  // of the plot area
constexpr double kLabelX = 690, kLabelGap = 19;

/// Okabe and Ito, "Color Universal Design", 2008: told apart with any colour vision. Its yellow is too faint
/// on white, its black is the text's.
constexpr std::array<const char*, 6> kPalette = {"#0072b2", "#d55e00", "#009e73",
                                                 "#cc79a7", "#e69f00", "#56b4e9"};
/// The first colour is the renderer's own; more curves than others differ by their dashes.
constexpr std::array<const char*, 3> kDashes = {"", "7 4", "2 4"};

constexpr const char* kStyle = R"(<style>
  .card { fill: #ffffff } .ink { fill: #1c2126 } .soft { fill: #5d6670 }
  .grid { stroke: #dfe3e8 } .fine { stroke: #f0f2f5 } .axis { stroke: #8a929c } .guide { stroke: #8a929c }
  .dot, .halo { stroke: #ffffff } .halo { stroke-width: 4px; stroke-linejoin: round; paint-order: stroke }
  @media (prefers-color-scheme: dark) {
    .card { fill: #14171b } .ink { fill: #e8ebef } .soft { fill: #98a2ae }
    .grid { stroke: #2c3238 } .fine { stroke: #1e2226 } .axis { stroke: #6b747e } .guide { stroke: #6b747e }
    .dot, .halo { stroke: #14171b }
  }
  text { font: 13px system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif }
  .title { font-size: 18px; font-weight: 600 } .small { font-size: 12px } .first { font-weight: 600 }
</style>
)";

const char* colourOf(std::size_t curve) {
  return kPalette[curve == 0 ? 0 : 1 + (curve - 1) % (kPalette.size() - 1)];
}
const char* dashesOf(std::size_t curve) {
  return kDashes[curve == 0 ? 0 : (curve - 1) / (kPalette.size() - 1) % kDashes.size()];
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '&'   ? "&amp;"
           : c == '<' ? "&lt;"
           : c == '>' ? "&gt;"
           : c == '"' ? "&quot;"
                      : std::string(1, c);
  return out;
}

std::string words(double x, double y, const char* style, const char* anchor, const std::string& text) {
  return cli::text("<text x=\"%.1f\" y=\"%.1f\" class=\"%s\" text-anchor=\"%s\">", x, y, style, anchor) +
         escaped(text) + "</text>\n";
}

std::string segment(const char* style, double x1, double y1, double x2, double y2) {
  return cli::text("<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n", style, x1, y1,
                   x2, y2);
}

struct Axes {
  LogAxis x, y;
};

bool drawable(const ChartPoint& p) {
  return p.x > 0.0 && p.y > 0.0;
}

Axes axesOf(const Chart& chart) {
  double left = 1e300, right = 0.0, low = 1e300, high = 0.0;
  for (const ChartCurve& curve : chart.curves)
    for (const ChartPoint& p : curve.points) {
      if (!drawable(p)) continue;
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
  if (!(right > 0.0)) left = low = 0.01, right = high = 1.0;
  return {{left / 1.2, right * 1.2, kLeft, kRight}, {low / 1.25, high * 1.25, kBottom, kTop}};
}

std::string gridOf(const Axes& axes, const Chart& chart) {
  std::string fine, bold, labels;
  for (const Tick& t : axes.x.ticks()) {
    (t.labelled ? bold : fine) +=
        segment(t.labelled ? "grid" : "fine", axes.x(t.value), kTop, axes.x(t.value), kBottom);
    if (t.labelled) labels += words(axes.x(t.value), kBottom + 20, "soft", "middle", chart.x.label(t.value));
  }
  for (const Tick& t : axes.y.ticks()) {
    (t.labelled ? bold : fine) +=
        segment(t.labelled ? "grid" : "fine", kLeft, axes.y(t.value), kRight, axes.y(t.value));
    if (t.labelled) labels += words(kLeft - 10, axes.y(t.value) + 4, "soft", "end", chart.y.label(t.value));
  }
  return fine + bold + segment("axis", kLeft, kBottom, kRight, kBottom) +
         segment("axis", kLeft, kTop, kLeft, kBottom) + labels;
}

std::string guideOf(const Axes& axes, const Chart& chart) {
  if (!chart.guide.ratio || chart.curves.empty() || chart.curves[0].points.empty()) return {};
  const ChartPoint& start = chart.curves[0].points.front();
  if (!drawable(start)) return {};
  constexpr int steps = 32;
  std::vector<std::pair<double, double>> line;  // pixels
  for (int i = 0; i <= steps; ++i) {
    const double x = start.x * std::pow(axes.x.most() / start.x, double(i) / steps);
    const double y = start.y * chart.guide.ratio(x, start.x);
    if (y < axes.y.least() || y > axes.y.most()) break;
    line.emplace_back(axes.x(x), axes.y(y));
  }
  if (line.size() < 2) return {};
  std::string points;
  for (const auto& [x, y] : line) points += cli::text("%.1f,%.1f ", x, y);
  const std::size_t middle = (line.size() - 1) * 55 / 100;
  const auto [x0, y0] = line[middle];
  const auto [x1, y1] = line[middle + 1];
  return "<polyline class=\"guide\" fill=\"none\" stroke-dasharray=\"5 5\" points=\"" + points + "\"/>\n" +
         cli::text(
             "<text class=\"soft small halo\" text-anchor=\"middle\" transform=\"translate(%.1f %.1f) "
             "rotate(%.1f)\">",
             x0, y0 - 7, std::atan((y1 - y0) / (x1 - x0)) * 57.29578) +
         escaped(chart.guide.label) + "</text>\n";
}

std::string bandOf(const Axes& axes, const ChartCurve& curve) {
  std::string upper, lower;
  for (const ChartPoint& p : curve.points) {
    if (!drawable(p) || !(p.most > 0.0)) continue;
    const double x = axes.x(p.x);
    const auto y = [&](double error) { return std::clamp(axes.y(std::max(error, 1e-300)), kTop, kBottom); };
    upper += cli::text("%.1f,%.1f ", x, y(p.most));
    lower = cli::text("%.1f,%.1f ", x, y(p.least)) + lower;
  }
  return cli::text("<polygon fill=\"%s\" opacity=\"0.14\" points=\"", colourOf(0)) + upper + lower + "\"/>\n";
}

std::string curveLine(const Axes& axes, const ChartCurve& curve, std::size_t index) {
  const char* colour = colourOf(index);
  std::string path, dots;
  for (const ChartPoint& p : curve.points) {
    if (!drawable(p)) continue;
    const double x = axes.x(p.x), y = axes.y(p.y);
    path += cli::text("%.1f,%.1f ", x, y);
    dots += cli::text("<circle class=\"dot\" cx=\"%.1f\" cy=\"%.1f\" r=\"%s\" fill=\"%s\"><title>", x, y,
                      index == 0 ? "4" : "3.2", colour) +
            escaped(p.tip) + "</title></circle>\n";
  }
  return cli::text(
             "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"%s\" stroke-linejoin=\"round\" "
             "stroke-dasharray=\"%s\" points=\"",
             colour, index == 0 ? "2.6" : "1.8", dashesOf(index)) +
         path + "\"/>\n" + dots;
}

/// Where a curve ends. Of ends at one height the left one is named first, so that leads do not cross.
struct End {
  std::size_t curve;
  double x, y;
  double wanted() const { return y + 0.06 * x; }
};

std::vector<End> endsOf(const Axes& axes, const Chart& chart) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const auto& points = chart.curves[i].points;
    if (!points.empty() && drawable(points.back()))
      ends.push_back({i, axes.x(points.back().x), axes.y(points.back().y)});
  }
  return ends;
}

/// The name of each curve at its end, with a thin lead.
std::string labelsOf(const Axes& axes, const Chart& chart) {
  const std::vector<End> ends = endsOf(axes, chart);
  std::vector<double> wanted;
  for (const End& end : ends) wanted.push_back(end.wanted() - 0.06 * kRight);
  const std::vector<double> placed = spreadApart(wanted, kLabelGap, kTop + 6, kBottom - 2);
  std::string out;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const End& end = ends[k];
    const char* colour = colourOf(end.curve);
    out +=
        cli::text(
            "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1\" opacity=\"0.55\" d=\"M%.1f %.1f L%.1f "
            "%.1f L%.1f %.1f\"/>\n",
            colour, end.x + 5, end.y, kLabelX - 18, placed[k], kLabelX - 12, placed[k]) +
        cli::text("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n", kLabelX - 8, placed[k], colour) +
        words(kLabelX + 2, placed[k] + 4.5, end.curve == 0 ? "ink first" : "ink", "start",
              chart.curves[end.curve].label);
  }
  return out;
}

}  // namespace

std::string svgOf(const Chart& chart) {
  const Axes axes = axesOf(chart);
  std::string out = cli::text(
                        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" width=\"%g\" "
                        "height=\"%g\" role=\"img\">\n",
                        kWidth, kHeight, kWidth, kHeight) +
                    "<title>" + escaped(chart.title) + "</title>\n" + kStyle;
  out += cli::text("<rect class=\"card\" width=\"%g\" height=\"%g\" rx=\"8\"/>\n", kWidth, kHeight);
  out +=
      words(24, 34, "ink title", "start", chart.title) + words(24, 56, "soft small", "start", chart.subtitle);
  out += gridOf(axes, chart) + guideOf(axes, chart);
  if (!chart.curves.empty()) out += bandOf(axes, chart.curves[0]);
  for (std::size_t i = chart.curves.size(); i-- > 0;) out += curveLine(axes, chart.curves[i], i);
  out += labelsOf(axes, chart);
  out += words(0.5 * (kLeft + kRight), kBottom + 46, "ink", "middle", chart.x.name);
  out += cli::text("<text class=\"ink\" text-anchor=\"middle\" transform=\"translate(24 %.1f) rotate(-90)\">",
                   0.5 * (kTop + kBottom)) +
         escaped(chart.y.name) + "</text>\n</svg>\n";
  return out;
}

}  // namespace steradian::report
