// SPDX-License-Identifier: MIT
// One dispatch per sample index, one invocation per pixel.
#include "renderer/reference/device_paths.hpp"

#include "renderer/energy_table.hpp"
#include "renderer/film.hpp"
#include "renderer/gpu/barriers.hpp"
#include "renderer/gpu_environment.hpp"
#include "renderer/loop_budget.hpp"
#include "renderer/mesh_buffer.hpp"
#include "renderer/reference/shaders.hpp"
#include "renderer/texel_buffer.hpp"

namespace steradian::reference {
namespace {

#include "shaders/verify_path.comp.h"

constexpr std::size_t largestRecord = std::size_t(256) << 20;  // bytes

std::size_t rowsPerPath(const gpu::TraceParams& params) {
  const Shaders<float> layout;
  const std::uint32_t vertices =
      params.maxBounces + ((params.flags & gpu::TRACE_MET_LIGHTS) != 0 ? 2 : 1);  // lastBounce() + 1
  return layout.RECORD_HEADER + std::size_t(vertices) * layout.RECORD_VERTEX_ROWS;
}

gpu::Buffer upload(const gpu::Device& device, const std::vector<glm::vec4>& rows, const char* what) {
  gpu::Buffer buffer(device, gpu::BufferKind::upload, rows.size() * sizeof(glm::vec4), what);
  buffer.writeRows(0, std::span<const glm::vec4>(rows));
  return buffer;
}

// The kinds are compiled in, as in the tracer's special pipelines; they leave the image as it is.
std::vector<gpu::Specialization> kindsOf(const GpuScene& scene) {
  std::vector<gpu::Specialization> kinds;
  for (std::uint32_t i = 0; i < gpu::FEATURE_COUNT; ++i) kinds.push_back({i, (scene.features >> i) & 1u});
  kinds.push_back({gpu::CONSTANT_SHAPE_HIERARCHY, scene.shapeHierarchy()});
  kinds.push_back({gpu::CONSTANT_MESH_LIGHTS, scene.meshLights});
  for (std::uint32_t i = 0; i < gpu::SOLID_LIGHT_KINDS; ++i)
    kinds.push_back({gpu::CONSTANT_SOLID_LIGHTS + i, (scene.solidLights >> i) & 1u});
  return kinds;
}

void checkSize(PixelRect pixels, std::size_t bytes) {
  if (bytes <= largestRecord) return;
  throw Error(ExitCode::usage, "--verify-pixel: a region of " + std::to_string(pixels.width) + " x " +
                                   std::to_string(pixels.height) + " pixels records " +
                                   std::to_string(bytes >> 20) +
                                   " MiB, 256 MiB is the most; choose a smaller one");
}

// What the mesh and the texel buffers hold, for the reference.
std::vector<glm::vec4> meshRows(const GpuScene& scene) {
  std::vector<glm::vec4> rows;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    for (const auto* part : {&scene.meshes[i]->nodes, &scene.meshes[i]->triangles, &scene.vertices[i]->rows})
      rows.insert(rows.end(), part->begin(), part->end());
  return rows;
}

std::vector<std::uint32_t> texelWords(const GpuScene& scene) {
  std::vector<std::uint32_t> words = texelTables(scene.textures);
  for (const auto& texture : scene.textures)
    words.insert(words.end(), texture->words.begin(), texture->words.end());
  return words;
}

}  // namespace

TracedScene tracedScene(GpuScene scene, const gpu::Device& device) {
  const bool cpu = device.description().type == "CPU";
  const LoopPlan plan = planLoops(scene.params, cpu ? cpuDriverLoopBudget : gpuLoopBudget,
                                  scene.traversalSteps, scene.traversals);
  scene.params.lightSamples = plan.lightSamples;
  std::vector<glm::vec4> tables = energyTable();
  if (scene.environment) {
    const std::vector<glm::vec4> sky = environmentTables(*scene.environment);
    tables.insert(tables.end(), sky.begin(), sky.end());
  }
  std::vector<glm::vec4> meshes = meshRows(scene);
  std::vector<std::uint32_t> texels = texelWords(scene);
  return {std::move(scene), std::move(tables), std::move(meshes), std::move(texels)};
}

gpu::TraceParams paramsOfSample(const TracedScene& traced, std::uint64_t sample) {
  gpu::TraceParams params = traced.scene.params;
  const bool errorMeter = (params.flags & gpu::TRACE_ERROR_METER) != 0;
  const int half = errorMeter ? int(sample & 1u) : 0;
  const HalfRange range = halfRange(sample, sample + 1, half, errorMeter);
  params.sampleBegin = range.begin;
  params.sampleEnd = range.end;
  params.flags |= half == 1 ? gpu::TRACE_HALF_B : 0u;
  return params;
}

std::vector<PathRecord> recordPaths(const gpu::Device& device, const TracedScene& traced, PixelRect pixels,
                                    std::uint64_t begin, std::uint64_t end) {
  const std::size_t rows = rowsPerPath(traced.scene.params),
                    paths = std::size_t(pixels.width) * pixels.height;
  checkSize(pixels, rows * paths * sizeof(glm::vec4));
  const gpu::Buffer scene = upload(device, traced.scene.rows, "scene"),
                    tables = upload(device, traced.tables, "tables"),
                    meshes = meshBuffer(device, traced.scene), texels = texelBuffer(device, traced.scene);
  const gpu::Buffer record(device, gpu::BufferKind::deviceLocal, rows * paths * sizeof(glm::vec4),
                           "path record");
  const std::array<const gpu::Buffer*, gpu::storageBindings> storage = {nullptr, nullptr, nullptr, nullptr,
                                                                        nullptr, nullptr, &record};
  const gpu::Bindings bindings(device, {&scene, &tables, &meshes, &texels}, storage);
  const gpu::ComputePass pass(device, verify_path_comp_spirv, kindsOf(traced.scene), "verify_path");
  std::vector<PathRecord> records;
  for (std::uint64_t sample = begin; sample < end; ++sample) {
    gpu::TraceParams params = paramsOfSample(traced, sample);
    params.pickX = std::uint32_t(pixels.x);
    params.pickY = std::uint32_t(pixels.y);
    gpu::fillZero(device, record);
    device.run(gpu::QueueKind::compute, [&](const auto& cmd) {
      gpu::computeToCompute(cmd);
      pass.dispatch(cmd, bindings, params, std::uint32_t(pixels.width), std::uint32_t(pixels.height));
    });
    const auto all = gpu::downloadAs<glm::vec4>(device, record, 0, rows * paths);
    for (std::size_t i = 0; i < paths; ++i)
      records.push_back(
          {pixels.x + int(i) % pixels.width,
           pixels.y + int(i) / pixels.width,
           sample,
           {all.begin() + std::ptrdiff_t(i * rows), all.begin() + std::ptrdiff_t((i + 1) * rows)}});
  }
  return records;
}

}  // namespace steradian::reference
