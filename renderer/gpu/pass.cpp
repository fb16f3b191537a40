// SPDX-License-Identifier: MIT
// The shared layout, descriptor sets, and pipelines.
#include "renderer/gpu/pass.hpp"

#include <cassert>

#include "renderer/scene/error.hpp"

namespace steradian::gpu {
namespace {

using ShaderStage = vk::ShaderStageFlagBits;
constexpr vk::ShaderStageFlags pushStages =
    ShaderStage::eCompute | ShaderStage::eVertex | ShaderStage::eFragment;

vk::raii::DescriptorSetLayout makeSetLayout(const Device& device) {
  std::vector<vk::DescriptorSetLayoutBinding> bindings;
  const vk::ShaderStageFlags stages = ShaderStage::eCompute | ShaderStage::eFragment;
  bindings.push_back({0, vk::DescriptorType::eUniformTexelBuffer, 1, stages});
  for (std::uint32_t i = 1; i <= storageBindings; ++i)
    bindings.push_back({i, vk::DescriptorType::eStorageBuffer, 1, stages});
  for (const std::uint32_t i : {tablesBinding, meshesBinding, texelsBinding})
    bindings.push_back({i, vk::DescriptorType::eUniformTexelBuffer, 1, stages});
  for (std::uint32_t i = 0; i < filmBuffers; ++i)
    bindings.push_back({filmBinding + i, vk::DescriptorType::eUniformTexelBuffer, 1, stages});
  const vk::DescriptorSetLayoutCreateInfo info({}, bindings);
  return checked(device, "creating the descriptor layout",
                 [&] { return vk::raii::DescriptorSetLayout(device.handle(), info); });
}

vk::raii::PipelineLayout makePipelineLayout(const Device& device, vk::DescriptorSetLayout set) {
  const vk::PushConstantRange push(pushStages, 0, pushConstantBytes);
  const vk::PipelineLayoutCreateInfo info({}, set, push);
  return checked(device, "creating the pipeline layout",
                 [&] { return vk::raii::PipelineLayout(device.handle(), info); });
}

vk::raii::ShaderModule makeModule(const Device& device, std::span<const std::uint32_t> spirv) {
  const vk::ShaderModuleCreateInfo info({}, spirv.size() * sizeof(std::uint32_t), spirv.data());
  return vk::raii::ShaderModule(device.handle(), info);
}

/// Specialization constants in the form that Vulkan reads; points into itself, so it stays where it is.
struct Constants {
  std::vector<vk::SpecializationMapEntry> entries;
  vk::SpecializationInfo info;

  explicit Constants(std::span<const Specialization> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      entries.emplace_back(values[i].id,
                           std::uint32_t(i * sizeof(Specialization) + offsetof(Specialization, value)),
                           sizeof(values[i].value));
    info = vk::SpecializationInfo(std::uint32_t(entries.size()), entries.data(), values.size_bytes(),
                                  values.data());
  }
  Constants(const Constants&) = delete;
};

vk::raii::Pipeline makeGraphicsPipeline(const Device& device, vk::ShaderModule vert, vk::ShaderModule frag,
                                        vk::RenderPass renderPass, const vk::SpecializationInfo& constants) {
  const std::array stages = {
      vk::PipelineShaderStageCreateInfo({}, ShaderStage::eVertex, vert, "main", &constants),
      vk::PipelineShaderStageCreateInfo({}, ShaderStage::eFragment, frag, "main", &constants)};
  const vk::PipelineVertexInputStateCreateInfo noVertices;
  const vk::PipelineInputAssemblyStateCreateInfo quad({}, vk::PrimitiveTopology::eTriangleStrip);
  const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
  vk::PipelineRasterizationStateCreateInfo raster;
  raster.lineWidth = 1.0f;
  const vk::PipelineMultisampleStateCreateInfo samples({}, vk::SampleCountFlagBits::e1);
  using Channel = vk::ColorComponentFlagBits;
  vk::PipelineColorBlendAttachmentState opaque;
  opaque.colorWriteMask = Channel::eR | Channel::eG | Channel::eB | Channel::eA;
  vk::PipelineColorBlendStateCreateInfo blend;
  blend.setAttachments(opaque);
  const std::array dynamics = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamics);
  const vk::GraphicsPipelineCreateInfo info({}, stages, &noVertices, &quad, nullptr, &viewport, &raster,
                                            &samples, nullptr, &blend, &dynamic,
                                            device.passLayout().pipeline(), renderPass);
  return vk::raii::Pipeline(device.handle(), device.pipelineCache(), info);
}

void bind(const vk::raii::CommandBuffer& cmd, vk::PipelineBindPoint point, vk::Pipeline pipeline,
          vk::PipelineLayout layout, const Bindings& bindings, const void* push, std::size_t pushBytes) {
  assert(pushBytes <= pushConstantBytes && pushBytes % 4 == 0);
  cmd.bindPipeline(point, pipeline);
  cmd.bindDescriptorSets(point, layout, 0, bindings.set(), {});
  if (pushBytes == 0) return;
  cmd.pushConstants<std::byte>(
      layout, pushStages, 0,
      vk::ArrayProxy<const std::byte>(std::uint32_t(pushBytes), static_cast<const std::byte*>(push)));
}

}  // namespace

PassLayout::PassLayout(const Device& device)
    : set_(makeSetLayout(device)),
      pipeline_(makePipelineLayout(device, *set_)),
      dummy_(device, BufferKind::upload, 256, "dummy"),
      dummyWords_(device, BufferKind::texelWords, 16, "dummy"),
      dummyFilm_(device, BufferKind::film, 16, "dummy") {}

Bindings::Bindings(const Device& device, const TexelBuffers& scene, std::span<const Buffer* const> storage) {
  assert(storage.size() <= storageBindings);
  const PassLayout& layout = device.passLayout();
  const std::array sizes = {vk::DescriptorPoolSize(vk::DescriptorType::eUniformTexelBuffer, 4 + filmBuffers),
                            vk::DescriptorPoolSize(vk::DescriptorType::eStorageBuffer, storageBindings)};
  const vk::DescriptorPoolCreateInfo poolInfo({}, 1, sizes);
  const vk::DescriptorSetLayout setLayout = layout.set();
  checked(device, "creating a descriptor set", [&] {
    pool_ = vk::raii::DescriptorPool(device.handle(), poolInfo);
    vk::DescriptorSetAllocateInfo allocate(*pool_, setLayout);
    set_ = vk::raii::DescriptorSets(device.handle(), allocate).front().release();
  });
  std::array<vk::DescriptorBufferInfo, storageBindings> buffers;
  for (std::size_t i = 0; i < storageBindings; ++i) {
    const Buffer* buffer = i < storage.size() && storage[i] && *storage[i] ? storage[i] : &layout.dummy();
    buffers[i] = vk::DescriptorBufferInfo(buffer->handle(), 0, VK_WHOLE_SIZE);
  }
  vk::WriteDescriptorSet writeStorage(set_, 1, 0, storageBindings, vk::DescriptorType::eStorageBuffer);
  writeStorage.pBufferInfo = buffers.data();  // consecutive bindings from 1 on
  device.handle().updateDescriptorSets(writeStorage, {});
  writeTexels(device, 0, scene.rows, layout.dummy());
  writeTexels(device, tablesBinding, scene.tables, layout.dummy());
  writeTexels(device, meshesBinding, scene.meshes, layout.dummy());
  writeTexels(device, texelsBinding, scene.texels, layout.dummyWords());
  for (std::uint32_t i = 0; i < filmBuffers; ++i)
    writeTexels(device, filmBinding + i, scene.film[i], layout.dummyFilm());
}

void Bindings::writeTexels(const Device& device, std::uint32_t binding, const Buffer* buffer,
                           const Buffer& dummy) {
  const vk::BufferView view = buffer && *buffer ? buffer->texels() : dummy.texels();
  assert(view && "texel buffers hold whole texels");
  vk::WriteDescriptorSet write(set_, binding, 0, 1, vk::DescriptorType::eUniformTexelBuffer);
  write.setTexelBufferView(view);
  device.handle().updateDescriptorSets(write, {});
}

ComputePass::ComputePass(const Device& device, std::span<const std::uint32_t> spirv,
                         std::span<const Specialization> specializations, const std::string& name)
    : layout_(device.passLayout().pipeline()) {
  device.throwIfLost();
  const Constants constants(specializations);
  checked(device, ("compiling the pipeline \"" + name + "\"").c_str(), [&] {
    const vk::raii::ShaderModule module = makeModule(device, spirv);
    const vk::PipelineShaderStageCreateInfo stage({}, ShaderStage::eCompute, *module, "main",
                                                  &constants.info);
    const vk::ComputePipelineCreateInfo info({}, stage, layout_);
    pipeline_ = vk::raii::Pipeline(device.handle(), device.pipelineCache(), info);
  });
}

void ComputePass::dispatch(const vk::raii::CommandBuffer& cmd, const Bindings& bindings, const void* push,
                           std::size_t pushBytes, std::uint32_t groupsX, std::uint32_t groupsY) const {
  bind(cmd, vk::PipelineBindPoint::eCompute, *pipeline_, layout_, bindings, push, pushBytes);
  cmd.dispatch(groupsX, groupsY, 1);
}

GraphicsPass::GraphicsPass(const Device& device, std::span<const std::uint32_t> vertSpirv,
                           std::span<const std::uint32_t> fragSpirv, vk::RenderPass renderPass,
                           std::span<const Specialization> specializations, const std::string& name)
    : layout_(device.passLayout().pipeline()) {
  device.throwIfLost();
  const Constants constants(specializations);
  checked(device, ("compiling the pipeline \"" + name + "\"").c_str(), [&] {
    const vk::raii::ShaderModule vert = makeModule(device, vertSpirv), frag = makeModule(device, fragSpirv);
    pipeline_ = makeGraphicsPipeline(device, *vert, *frag, renderPass, constants.info);
  });
}

void GraphicsPass::draw(const vk::raii::CommandBuffer& cmd, const Bindings& bindings, const void* push,
                        std::size_t pushBytes, PixelRect rect) const {
  if (rect.width <= 0 || rect.height <= 0) return;
  bind(cmd, vk::PipelineBindPoint::eGraphics, *pipeline_, layout_, bindings, push, pushBytes);
  cmd.setViewport(0, vk::Viewport(float(rect.x), float(rect.y), float(rect.width), float(rect.height), 0, 1));
  cmd.setScissor(0, vk::Rect2D({rect.x, rect.y}, {std::uint32_t(rect.width), std::uint32_t(rect.height)}));
  cmd.draw(4, 1, 0, 0);
}

}  // namespace steradian::gpu
