// SPDX-License-Identifier: MIT
#include "renderer/ray_caster.hpp"

#include <algorithm>
#include <cstring>

#include "renderer/gpu/barriers.hpp"
#include "renderer/gpu/commands.hpp"
#include "renderer/gpu/pass.hpp"
#include "renderer/mesh_buffer.hpp"
#include "renderer/shader_code.hpp"

namespace steradian {

using namespace gpu;

namespace {

constexpr std::size_t raysPerGroup = 64, groupsPerRow = 1024;

ComputePass passFor(const Device& device, const GpuScene& scene, bool any, bool whileWhile) {
  std::vector<Specialization> constants;
  for (std::uint32_t i = 0; i < FEATURE_COUNT; ++i) constants.push_back({i, (scene.features >> i) & 1u});
  constants.push_back({CONSTANT_WHILE_WHILE, whileWhile});
  constants.push_back({CONSTANT_ONE_INSTANCE, scene.oneInstance()});
  constants.push_back({CONSTANT_SHAPE_HIERARCHY, scene.shapeHierarchy()});
  constants.push_back({CONSTANT_ANY_HIT, any});
  return ComputePass(device, castRaysSpirv(), constants, any ? "cast shadow rays" : "cast rays");
}

Buffer rowBuffer(const Device& device, const GpuScene& scene) {
  Buffer rows(device, BufferKind::upload, scene.rows.size() * sizeof(glm::vec4), "scene");
  rows.writeRows(0, std::span(scene.rows));
  return rows;
}

}  // namespace

struct RayCaster::Impl {
  std::shared_ptr<Device> device;
  GpuScene scene;
  Buffer rows, meshes;
  ComputePass closest, any;
  Commands commands;
};

RayCaster::RayCaster(std::shared_ptr<Device> opened, GpuScene scene, bool whileWhile) {
  Buffer rows = rowBuffer(*opened, scene), meshes = meshBuffer(*opened, scene);
  ComputePass closest = passFor(*opened, scene, false, whileWhile),
              any = passFor(*opened, scene, true, whileWhile);
  impl_.reset(new Impl{opened, std::move(scene), std::move(rows), std::move(meshes), std::move(closest),
                       std::move(any), Commands(*opened, QueueKind::compute)});
}

RayCaster::~RayCaster() = default;

RayCaster::Answer RayCaster::cast(std::span<const CastRay> rays, bool any, int runs) {
  Impl& i = *impl_;
  if (rays.empty()) return {};
  Buffer in(*i.device, BufferKind::deviceLocal, rays.size_bytes(), "rays");
  in.write(0, std::as_bytes(rays));
  const Buffer out(*i.device, BufferKind::deviceLocal, rays.size() * sizeof(CastHit), "hits");
  const Buffer* const storage[] = {&in, &out};
  const Bindings bindings(*i.device, {&i.rows, nullptr, &i.meshes, nullptr}, storage);
  const std::size_t groups = (rays.size() + raysPerGroup - 1) / raysPerGroup,
                    wide = std::min(groups, groupsPerRow);
  TraceParams params = i.scene.params;
  params.width = std::uint32_t(rays.size());
  params.height = std::uint32_t(wide);
  Answer answer;
  for (int run = 0; run < runs; ++run) {
    const double ms = i.commands.run([&](const auto& cmd) {
      computeToCompute(cmd);
      (any ? i.any : i.closest)
          .dispatch(cmd, bindings, params, std::uint32_t(wide), std::uint32_t((groups + wide - 1) / wide));
    });
    answer.milliseconds = run == 0 ? ms : std::min(answer.milliseconds, ms);
  }
  answer.hits = downloadAs<CastHit>(*i.device, out, 0, rays.size());
  return answer;
}

}  // namespace steradian
