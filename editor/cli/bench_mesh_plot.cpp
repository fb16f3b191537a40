// SPDX-License-Identifier: MIT
// What a ray costs as a mesh grows.
#include <cmath>

#include "editor/cli/bench_mesh.hpp"
#include "editor/cli/console.hpp"
#include "editor/report/chart.hpp"

namespace steradian::bench {

namespace {

std::string countLabel(double count) {
  return count < 1e3   ? cli::text("%g", count)
         : count < 1e6 ? cli::text("%g k", count / 1e3)
                       : cli::text("%g M", count / 1e6);
}

std::string nanosecondsLabel(double value) {
  return cli::text("%g ns", value);
}

report::ChartPoint pointOf(std::size_t triangles, const std::string& who, double mraysPerSecond) {
  return {.x = double(triangles),
          .y = 1e3 / mraysPerSecond,
          .tip = cli::text("%s, %zu triangles: %.3g Mrays/s", who.c_str(), triangles, mraysPerSecond)};
}

}  // namespace

std::string plotOf(const MeshBench& bench) {
  std::vector<report::ChartCurve> ours, embree;
  for (const MeshBenchResult& result : bench.results)
    for (std::size_t kind = 0; kind < result.rays.size(); ++kind) {
      const MeshRays& rays = result.rays[kind];
      if (ours.size() <= kind) ours.push_back({rays.kind, {}});
      ours[kind].points.push_back(pointOf(result.triangles, rays.kind, rays.mraysPerSecond));
      if (!rays.embree) continue;
      if (embree.size() <= kind) embree.push_back({"Embree, " + rays.kind, {}});
      embree[kind].points.push_back(pointOf(result.triangles, embree[kind].label, *rays.embree));
    }
  report::Chart chart{
      .title = "A ray against a mesh that grows",
      .subtitle = bench.device.name + ", hills and a bumpy ball, the fastest of several runs",
      .x = {"triangles", countLabel},
      .y = {"time per ray", nanosecondsLabel},
      .curves = std::move(ours),
      .guide = {"log n", [](double x, double first) { return std::log(x) / std::log(first); }}};
  chart.curves.insert(chart.curves.end(), embree.begin(), embree.end());
  return report::svgOf(chart);
}

}  // namespace steradian::bench
