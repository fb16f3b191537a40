// SPDX-License-Identifier: MIT
// The report as JSON for programs and as Markdown for people.
#include <nlohmann/json.hpp>

#include "editor/cli/console.hpp"
#include "editor/report/report.hpp"

namespace steradian::report {

namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const Spread& spread) {
  return {{"median", spread.median}, {"min", spread.least}, {"max", spread.most}};
}

Json jsonOf(const std::optional<PowerLaw>& law) {
  return law ? Json(law->exponent) : Json(nullptr);
}

Json ratioJson(double ratio) {
  return ratio > 0.0 ? Json(ratio) : Json(nullptr);
}

Json jsonOf(const CurvePoint& p) {
  return {{"samples", p.samples},
          {"seconds", jsonOf(p.seconds)},
          {"rmse", jsonOf(p.rmse)},
          {"relRmse", jsonOf(p.relRmse)},
          {"relMse", p.relRmse.median * p.relRmse.median},
          {"smapeDisplay", jsonOf(p.smapeDisplay)},
          {"meterRatio", ratioJson(p.meterRatio)},
          {"relMeterRatio", ratioJson(p.relMeterRatio)}};
}

Json jsonOf(const Curve& curve) {
  Json points = Json::array();
  for (const CurvePoint& point : curve.points) points.push_back(jsonOf(point));
  return {{"id", curve.id},
          {"label", curve.label},
          {"slopeOverSamples", jsonOf(curve.relRmseOverSamples)},
          {"slopeOverSeconds", jsonOf(curve.relRmseOverSeconds)},
          {"secondsTo1Percent", curve.secondsToTarget ? Json(curve.secondsToTarget->x) : Json(nullptr)},
          {"extrapolated", curve.secondsToTarget && curve.secondsToTarget->extrapolated},
          {"efficiency", curve.efficiency},
          {"nan", curve.nan},
          {"faults", curve.faults},
          {"points", points}};
}

Json jsonOf(const SceneReport& scene) {
  Json curves = Json::array();
  for (const Curve& curve : scene.curves) curves.push_back(jsonOf(curve));
  const auto& apart = scene.relMseToFirstDevice;
  return {{"name", scene.name},
          {"project", scene.project},
          {"device", scene.device.name},
          {"driver", scene.device.driver},
          {"width", scene.film.width},
          {"height", scene.film.height},
          {"runs", scene.runs},
          {"relMseToFirstDevice", apart ? Json(*apart) : Json(nullptr)},
          {"reference", {{"samples", scene.referenceSamples}, {"relRmse", scene.referenceRelRmse}}},
          {"variants", curves}};
}

std::string slopeText(const std::optional<PowerLaw>& law) {
  return law ? cli::text("%.2f", law->exponent) : "-";
}

std::string targetText(const Curve& curve) {
  if (curve.secondsToTarget)
    return (curve.secondsToTarget->extrapolated ? "~" : "") + shortDuration(curve.secondsToTarget->x);
  const bool early = !curve.points.empty() && curve.points.front().relRmse.median <= kTarget;
  return early ? "< " + shortDuration(curve.points.front().seconds.median) : "-";
}

/// Absolute and relative.
std::string meterText(const CurvePoint& p) {
  return p.meterRatio > 0.0 ? cli::text("%.2f, %.2f", p.meterRatio, p.relMeterRatio) : "-";
}

std::string rowOf(const Curve& curve) {
  const CurvePoint& last = curve.points.back();
  return "| " + curve.label + cli::text(" | %llu | ", (unsigned long long)(last.samples)) +
         shortDuration(last.seconds.median) +
         cli::text(" | %.3g %% | %.3g | %.3g | %.3g | ", last.relRmse.median * 100.0, last.rmse.median,
                   last.relRmse.median * last.relRmse.median, last.smapeDisplay.median) +
         slopeText(curve.relRmseOverSamples) + " | " + targetText(curve) +
         cli::text(" | %.3g | ", curve.efficiency) + meterText(last) +
         cli::text(" | %llu |\n", (unsigned long long)(curve.nan));
}

constexpr const char* kHead =
    "| variant | samples | time | relRMSE | RMSE | relMSE | SMAPE | slope | time to 1 % | efficiency | meter "
    "| "
    "NaN |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";

constexpr const char* kFoot =
    "Medians over the runs, of tracing alone, on a warm pipeline. RMSE is scene-linear, relRMSE divides each "
    "square by reference^2 + 0.01, SMAPE is of the picture as the scene displays it: exposure, tonemapper "
    "and transfer. The reference has another seed; its own "
    "error, known from its half-buffers, is taken off. Slope: of log relRMSE over log samples, last four "
    "doublings. ~: extrapolated along it. Efficiency: 1 / (MSE x seconds). Meter: error estimated live / "
    "true, of RMSE and of relRMSE.\n";

}  // namespace

std::string jsonOf(const Report& report) {
  Json scenes = Json::array();
  for (const SceneReport& scene : report.scenes) scenes.push_back(jsonOf(scene));
  const Json json = {{"version", report.version}, {"command", report.command}, {"scenes", scenes}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string markdownOf(const Report& report, const std::vector<PlotNames>& plotNames) {
  std::string out =
      "# Error against time\n\nSteradian " + report.version + "\n\n    " + report.command + "\n";
  for (std::size_t i = 0; i < report.scenes.size(); ++i) {
    const SceneReport& scene = report.scenes[i];
    out += "\n## " + scene.name + "\n\n![Error against time](" + plotNames[i].overSeconds +
           ")\n\n![Error against samples](" + plotNames[i].overSamples + ")\n\n" + scene.device.name + ", " +
           scene.device.driver +
           cli::text(": %dx%d, %d runs, reference %llu samples (error %.2g %%)", scene.film.width,
                     scene.film.height, scene.runs, (unsigned long long)(scene.referenceSamples),
                     scene.referenceRelRmse * 100.0);
    if (scene.relMseToFirstDevice)
      out += cli::text("; the same samples on the first device: relMSE %.2g", *scene.relMseToFirstDevice);
    out += std::string("\n\n") + kHead;
    for (const Curve& curve : scene.curves) out += rowOf(curve);
  }
  return out + "\n" + kFoot;
}

}  // namespace steradian::report
