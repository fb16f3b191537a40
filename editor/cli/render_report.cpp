// SPDX-License-Identifier: MIT
// The report as JSON: stable keys, SI units.
#include "editor/cli/render_report.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "renderer/scene/error.hpp"

namespace steradian::cli {

namespace {

using Json = nlohmann::ordered_json;

Json errorOf(const ErrorEstimate& error) {
  if (!error.valid) return {{"rmse", nullptr}, {"relRmse", nullptr}, {"slope", nullptr}, {"tails", nullptr}};
  const ErrorTails& tails = error.tails;
  return {{"rmse", error.rmse},
          {"relRmse", error.relRmse},
          {"slope", error.slope},
          {"tails", {{"share", tails.share}, {"pixels", tails.pixels}, {"heavy", tails.heavy}}}};
}

}  // namespace

std::string reportText(const RenderReport& report) {
  const RenderStats& stats = report.stats;
  const double rays = double(stats.raysClosest + stats.raysShadow);
  const Json json = {
      {"device", report.device.name},
      {"driver", report.device.driver},
      {"queues", report.device.queues},
      {"width", report.film.width},
      {"height", report.film.height},
      {"spp", stats.samples},
      {"samples", {{"begin", report.sampleBegin}, {"end", report.sampleBegin + stats.samples}}},
      {"seconds",
       {{"load", report.loadSeconds},
        {"compile", stats.compileSeconds},
        {"firstPixel", report.firstPixelSeconds},
        {"trace", report.traceSeconds},
        {"total", report.totalSeconds}}},
      {"rays", {{"closest", stats.raysClosest}, {"shadow", stats.raysShadow}}},
      {"mraysPerSecond", report.traceSeconds > 0.0 ? rays / report.traceSeconds * 1e-6 : 0.0},
      {"error", errorOf(stats.error)},
      {"nan", stats.nanSamples},
      {"clampedShare", stats.clampedShare ? Json(*stats.clampedShare) : Json(nullptr)},
      {"memory", {{"meshes", stats.meshBytes}, {"textures", stats.textureBytes}, {"sky", stats.skyBytes}}},
      {"variant",
       {{"specialized", stats.variant.specialized},
        {"features", stats.variant.features},
        {"leftOut", stats.variant.leftOut}}},
      {"validationMessages", report.validationMessages},
  };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void writeReport(const RenderReport& report, const std::filesystem::path& path) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  stream << reportText(report);
  stream.close();
  if (!stream)
    throw Error(ExitCode::io, path.string() + ": the report cannot be written: " + std::strerror(errno));
}

}  // namespace steradian::cli
