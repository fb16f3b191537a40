// SPDX-License-Identifier: MIT
// The results of the mesh bench for people and for programs.
#include "editor/cli/bench_mesh.hpp"
#include "editor/cli/bench_text.hpp"

namespace steradian::bench {

namespace {

double perMillion(double seconds, std::size_t triangles) {
  return seconds / double(triangles) * 1e6;
}

}  // namespace

std::string textOf(const MeshBench& bench) {
  std::string out = line("%s, %s", bench.device.name.c_str(), bench.device.driver.c_str());
  if (!bench.peer.empty()) out += line("%s", bench.peer.c_str());
  for (const MeshBenchResult& r : bench.results) {
    out += line("%zu triangles: %zu MiB on the device, depth %d, built in %.3f s (%.2f s per million)",
                r.triangles, r.megabytes, r.depth, r.buildSeconds, perMillion(r.buildSeconds, r.triangles));
    if (r.embreeBuildSeconds)
      out += line("  Embree built in %.3f s (%.2f s per million)", *r.embreeBuildSeconds,
                  perMillion(*r.embreeBuildSeconds, r.triangles));
    for (const MeshRays& rays : r.rays) {
      out += line("  %-8s %9.2f Mrays/s", rays.kind.c_str(), rays.mraysPerSecond);
      if (rays.embree) {
        out.pop_back();
        out += line("   Embree %7.2f   ratio %.2f   %.4f %% differ", *rays.embree,
                    rays.mraysPerSecond / *rays.embree, 100.0 * rays.disagreeing.value_or(0.0));
      }
      if (rays.visits) {
        out.pop_back();
        out += line("   %.1f tests a ray", *rays.visits);
      }
    }
  }
  return out;
}

std::string jsonOf(const MeshBench& bench) {
  Json sizes = Json::array();
  for (const MeshBenchResult& r : bench.results) {
    Json rays = Json::array();
    for (const MeshRays& k : r.rays)
      rays.push_back({{"kind", k.kind},
                      {"rays", k.rays},
                      {"mraysPerSecond", k.mraysPerSecond},
                      {"testsPerRay", jsonOf(k.visits)},
                      {"embreeMraysPerSecond", jsonOf(k.embree)},
                      {"disagreeing", jsonOf(k.disagreeing)}});
    sizes.push_back({{"triangles", r.triangles},
                     {"buildSeconds", r.buildSeconds},
                     {"embreeBuildSeconds", jsonOf(r.embreeBuildSeconds)},
                     {"megabytes", r.megabytes},
                     {"depth", r.depth},
                     {"worstLoopTurns", r.steps},
                     {"rays", rays}});
  }
  const Json all{{"device", bench.device.name}, {"driver", bench.device.driver}, {"sizes", sizes}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace steradian::bench
