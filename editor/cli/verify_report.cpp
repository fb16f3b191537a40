// SPDX-License-Identifier: MIT
#include "editor/cli/verify_report.hpp"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>

namespace steradian::cli {

namespace {

using namespace reference;

constexpr const char* stages[] = {"camera", "intersection", "normal", "light", "BSDF", "throughput"};

/// The largest of a stage at a vertex, as text; "-" where nothing was compared.
std::string worstOf(const std::vector<Finding>& findings, int vertex, const char* stage) {
  const Finding* worst = nullptr;
  for (const Finding& f : findings)
    if (f.vertex == vertex && std::strcmp(infoOf(f.quantity).stage, stage) == 0 &&
        (!worst || !(f.relative <= worst->relative)))
      worst = &f;
  if (!worst) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.1e%s", worst->relative, worst->parts() ? "!" : "");
  return text;
}

std::string objectName(const PathRecord& record, int vertex, const TracedScene& traced, const Scene& scene) {
  const auto primitive = primitiveAt(record, vertex);
  if (!primitive) return "(left the scene)";
  const float bits = traced.scene.rows[traced.scene.params.objectRow + *primitive].x;
  const Id id{std::bit_cast<std::uint32_t>(bits)};
  const auto object = std::ranges::find(scene.objects, id, &Object::id);
  return object != scene.objects.end() ? object->name : "primitive " + std::to_string(*primitive);
}

void printRun(const FreeRun& run) {
  if (run.partedAt)
    std::printf("  free-running in double: another path from vertex %d on\n", *run.partedAt);
  else
    std::printf(
        "  free-running in double: the same %d vertices, distances within %.1e, radiance within %.1e\n",
        run.vertices, run.distance, run.radiance);
}

void printQuantities(const Summary& summary) {
  std::printf("%-13s%-19s%10s%12s%10s%8s\n", "stage", "quantity", "compared", "largest", "gate", "parted");
  for (std::size_t q = 0; q < std::size_t(Quantity::count); ++q) {
    if (!summary.worst[q]) continue;
    const QuantityInfo& info = infoOf(Quantity(q));
    std::printf("%-13s%-19s%10zu%12.1e%10.0e%8zu\n", info.stage, info.name, summary.compared[q],
                summary.worst[q]->relative, info.gate, summary.parted[q]);
  }
}

void printParting(const VerifiedPath& path, const Finding& f) {
  const QuantityInfo& info = infoOf(f.quantity);
  const std::string slot = f.slot < 0 ? "" : ", light sample " + std::to_string(f.slot);
  std::printf(
      "they part at pixel %d,%d sample %llu vertex %d%s: %s, %s: float %s, double %s (%.1e, rounding "
      "explains %.0e)\n",
      path.record.x, path.record.y, (unsigned long long)path.record.sample, f.vertex, slot.c_str(),
      info.stage, info.name, f.device.c_str(), f.reference.c_str(), f.relative, f.allowed());
}

}  // namespace

void printPath(const VerifiedPath& path, const TracedScene& traced, const Scene& scene) {
  std::printf("pixel %d,%d sample %llu\n  %-7s%-22s", path.record.x, path.record.y,
              (unsigned long long)path.record.sample, "vertex", "object");
  for (const char* stage : stages) std::printf("%13s", stage);
  std::puts("");
  for (int i = 0; i < vertexCount(path.record); ++i) {
    std::printf("  %-7d%-22.22s", i, objectName(path.record, i, traced, scene).c_str());
    for (const char* stage : stages) std::printf("%13s", worstOf(path.findings, i, stage).c_str());
    std::puts("");
  }
  printRun(path.run);
}

bool printVerdict(const std::vector<VerifiedPath>& paths) {
  constexpr int named = 8;  // partings that are told one by one
  Summary summary;
  std::size_t vertices = 0, partings = 0, other = 0;
  for (const VerifiedPath& path : paths) {
    summary.add(path.findings);
    vertices += std::size_t(vertexCount(path.record));
    other += path.run.partedAt ? 1 : 0;
  }
  printQuantities(summary);
  for (const VerifiedPath& path : paths)
    for (const Finding& f : path.findings)
      if (f.parts() && ++partings <= named) printParting(path, f);
  std::printf("%s: %zu paths, %zu vertices, %zu differences beyond rounding; ",
              partings ? "PARTED" : "agreed", paths.size(), vertices, partings);
  std::printf("%zu paths take another way when double runs free\n", other);
  return partings == 0;
}

}  // namespace steradian::cli
