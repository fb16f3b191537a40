// SPDX-License-Identifier: MIT
// What the report draws: error against time or samples, a curve for each variant.
#include <algorithm>
#include <cmath>

#include "editor/cli/console.hpp"
#include "editor/report/chart.hpp"
#include "editor/report/plot_axis.hpp"
#include "editor/report/report.hpp"

namespace steradian::report {

namespace {

std::uint64_t mostSamples(const SceneReport& scene) {
  const bool any = !scene.curves.empty() && !scene.curves[0].points.empty();
  return any ? scene.curves[0].points.back().samples : 0;
}

ChartCurve chartCurve(const Curve& curve, PlotOver over) {
  ChartCurve out{curve.label, {}};
  for (const CurvePoint& p : curve.points)
    out.points.push_back({over == PlotOver::seconds ? p.seconds.median : double(p.samples), p.relRmse.median,
                          p.relRmse.least, p.relRmse.most,
                          cli::text("%llu samples, ", (unsigned long long)(p.samples)) +
                              shortDuration(p.seconds.median) +
                              cli::text(", %.3g %%", p.relRmse.median * 100.0)});
  return out;
}

bool sameErrors(const Curve& a, const Curve& b) {
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                    [](const CurvePoint& p, const CurvePoint& q) {
                      return p.samples == q.samples && p.relRmse.median == q.relRmse.median;
                    });
}

}  // namespace

std::string svgOf(const SceneReport& scene, PlotOver over) {
  const bool seconds = over == PlotOver::seconds;
  Chart chart{
      .title = scene.name + (seconds ? ": error against time" : ": error against samples"),
      .x = seconds ? ChartAxis{"time of tracing", secondsLabel} : ChartAxis{"samples per pixel", countLabel},
      .y = {"relative RMSE", percentLabel},
      .guide = {"slope \xe2\x88\x92\xc2\xbd", [](double x, double first) { return std::sqrt(first / x); }}};
  chart.subtitle = scene.device.name +
                   cli::text(", %dx%d, 1 to %llu samples, median of %d runs, reference of %llu samples",
                             scene.film.width, scene.film.height, (unsigned long long)(mostSamples(scene)),
                             scene.runs, (unsigned long long)(scene.referenceSamples));
  for (const Curve& curve : scene.curves)
    if (seconds || &curve == &scene.curves.front() || !sameErrors(curve, scene.curves.front()))
      chart.curves.push_back(chartCurve(curve, over));
  return svgOf(chart);
}

}  // namespace steradian::report
