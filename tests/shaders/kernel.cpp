// SPDX-License-Identifier: MIT
// Buffers, one dispatch, read-back.
#include "tests/shaders/kernel.hpp"

#include <array>
#include <cmath>

#include "renderer/gpu/barriers.hpp"
#include "renderer/gpu/buffer.hpp"
#include "renderer/gpu/pass.hpp"

namespace steradian::kernel {
namespace {

constexpr std::size_t groupSize = 64, groupsPerRow = 1024;
constexpr std::uint32_t operationConstant = 64;

gpu::Buffer upload(const gpu::Device& device, Rows rows, std::size_t atLeast) {
  rows.resize(std::max({rows.size(), atLeast, std::size_t(1)}));
  gpu::Buffer buffer(device, gpu::BufferKind::upload, rows.size() * sizeof(glm::vec4), "kernel questions");
  buffer.writeRows(0, std::span<const glm::vec4>(rows));
  return buffer;
}

}  // namespace

std::shared_ptr<gpu::Device> KernelTest::device_;

void KernelTest::SetUpTestSuite() {
  device_ = openDevice({});
  RecordProperty("device", device_->description().name);
}

void KernelTest::TearDownTestSuite() {
  EXPECT_EQ(device_->validationMessages(), 0);
  device_.reset();
}

Rows KernelTest::run(const Kernel& kernel, const Task& task, const Rows& questions) {
  const std::size_t wanted = task.invocations ? task.invocations : questions.size() / task.rowsIn;
  const std::size_t groups = (wanted + groupSize - 1) / groupSize;
  const std::size_t groupsX = std::min(groups, groupsPerRow), groupsY = (groups + groupsX - 1) / groupsX;
  const std::size_t padded = groupsX * groupsY * groupSize;
  const gpu::Device& device = *device_;
  const gpu::Buffer scene = upload(device, task.scene, 1);
  const gpu::Buffer tables = upload(device, task.tables, 1);
  const gpu::Buffer mesh = upload(device, task.mesh, 1);
  gpu::Buffer texels;
  if (!task.texels.empty()) {
    texels = gpu::Buffer(device, gpu::BufferKind::texelWords, task.texels.size() * 4, "kernel texels");
    texels.writeRows(0, std::span<const std::uint32_t>(task.texels));
  }
  const gpu::Buffer in = upload(device, questions, padded * task.rowsIn);
  const gpu::Buffer out(device, gpu::BufferKind::deviceLocal, padded * task.rowsOut * sizeof(glm::vec4),
                        "kernel answers");
  const std::array<const gpu::Buffer*, gpu::storageBindings> storage = {nullptr, nullptr, nullptr, nullptr,
                                                                        nullptr, &in,     &out};
  const gpu::Bindings bindings(device, {&scene, &tables, &mesh, &texels}, storage);
  std::vector<std::byte> push = task.push;
  push.resize(gpu::pushConstantBytes);  // what a shader names must be set, used or not
  std::vector<gpu::Specialization> constants{{operationConstant, task.operation}};
  for (const auto& [id, value] : task.constants) constants.push_back({id, value});
  const gpu::ComputePass pass(device, kernel.spirv, constants, kernel.name);
  device.run(gpu::QueueKind::compute, [&](const vk::raii::CommandBuffer& cmd) {
    pass.dispatch(cmd, bindings, push.data(), push.size(), std::uint32_t(groupsX), std::uint32_t(groupsY));
  });
  return gpu::downloadAs<glm::vec4>(device, out, 0, wanted * task.rowsOut);
}

double Random::decades(double low, double high) {
  return std::pow(10.0, uniform(low, high));
}

glm::dvec3 Random::direction() {
  const double z = uniform(-1.0, 1.0), phi = uniform(0.0, 2.0 * M_PI), r = std::sqrt(1.0 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

double ulp(double x) {
  const float f = float(std::fabs(x));
  return double(std::nextafter(f, INFINITY)) - double(f);
}

}  // namespace steradian::kernel
