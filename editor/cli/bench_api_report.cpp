// SPDX-License-Identifier: MIT
// The table of APIs for people and for programs.
#include "editor/cli/bench_api.hpp"
#include "editor/cli/bench_text.hpp"

namespace steradian::bench {

namespace {

std::string compileText(const std::optional<double>& seconds) {
  std::string text = seconds ? line("%.2f s", *seconds) : line("-");
  text.pop_back();
  return text;
}

std::string relMseText(const std::optional<double>& relMse) {
  std::string text = relMse ? line("%.1e", *relMse) : line("-");
  text.pop_back();
  return text;
}

std::string textOf(const ApiRow& row, const ApiRow& vulkan) {
  if (!row.refused.empty()) return line("  %-7s not measured: %.480s", row.api.c_str(), row.refused.c_str());
  std::string out =
      line("  %-7s %10.3f %11.1f %9.2f %9.2f  %8s %9s  %s", row.api.c_str(), row.msPerSample,
           1e3 / row.msPerSample, row.mraysPerSecond, vulkan.msPerSample / row.msPerSample,
           relMseText(row.relMse).c_str(), compileText(row.compileSeconds).c_str(), row.runsOn.c_str());
  if (row.nan + row.faults > 0)
    out += line("          NaN %llu, faults %llu", (unsigned long long)(row.nan),
                (unsigned long long)(row.faults));
  return out;
}

Json jsonOf(const ApiRow& row, const ApiRow& vulkan) {
  if (!row.refused.empty()) return {{"api", row.api}, {"refused", row.refused}};
  return {{"api", row.api},
          {"runsOn", row.runsOn},
          {"msPerSample", row.msPerSample},
          {"samplesPerSecond", 1e3 / row.msPerSample},
          {"mraysPerSecond", row.mraysPerSecond},
          {"ofVulkan", vulkan.msPerSample / row.msPerSample},
          {"relMse", bench::jsonOf(row.relMse)},
          {"compileSeconds", bench::jsonOf(row.compileSeconds)},
          {"nan", row.nan},
          {"faults", row.faults}};
}

}  // namespace

std::string textOf(const std::vector<ApiBenchResult>& results) {
  std::string out;
  for (const ApiBenchResult& r : results) {
    out += line("%s%s  %dx%d, %d bounces, %llu samples", out.empty() ? "" : "\n", r.project.c_str(),
                r.size.width, r.size.height, r.maxBounces, (unsigned long long)(r.samples));
    out += line("  %-7s %10s %11s %9s %9s  %8s %9s  %s", "", "ms/sample", "samples/s", "Mrays/s", "x Vulkan",
                "relMSE", "compile", "runs on");
    for (const ApiRow& row : r.rows) out += textOf(row, r.rows[0]);
  }
  out += line(
      "\nrelMSE: of the mean radiance, against Vulkan's. compile: with empty caches; C++ came with this "
      "program.");
  return out;
}

std::string jsonOf(const std::vector<ApiBenchResult>& results) {
  Json list = Json::array();
  for (const ApiBenchResult& r : results) {
    Json rows = Json::array();
    for (const ApiRow& row : r.rows) rows.push_back(jsonOf(row, r.rows[0]));
    list.push_back({{"project", r.project},
                    {"width", r.size.width},
                    {"height", r.size.height},
                    {"maxBounces", r.maxBounces},
                    {"samples", r.samples},
                    {"apis", rows}});
  }
  return list.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace steradian::bench
