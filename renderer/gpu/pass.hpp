// SPDX-License-Identifier: MIT
// A shader with its pipeline. All passes share one layout: storage buffers at bindings 1..7, texel buffers at
// 0 and from 8 on, of which the last are the film.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vulkan/vulkan_raii.hpp>

#include "renderer/gpu/buffer.hpp"
#include "renderer/gpu/device.hpp"
#include "renderer/presenter.hpp"

namespace steradian::gpu {

inline constexpr std::uint32_t storageBindings = 7;  // bindings 1..7 of set 0
inline constexpr std::uint32_t tablesBinding = 8;
inline constexpr std::uint32_t meshesBinding = 9;
inline constexpr std::uint32_t texelsBinding = 10;
inline constexpr std::uint32_t filmBinding = 11;
inline constexpr std::uint32_t filmBuffers = 6;
inline constexpr std::uint32_t pushConstantBytes = 128;

/// What a GraphicsPass draws into, as Swapchain hands it out.
using TargetPass = vk::RenderPass;

/// Owned by Device, the same for every pass: set 0 = { 0, 8, 9: samplerBuffer, 10:
/// usamplerBuffer, 11..16: isamplerBuffer, 1..7: storage buffers } for compute and fragment shaders, 128
/// bytes of push constants for compute, vertex and fragment shaders.
class PassLayout {
 public:
  explicit PassLayout(const Device& device);
  vk::DescriptorSetLayout set() const { return *set_; }
  vk::PipelineLayout pipeline() const { return *pipeline_; }
  const Buffer& dummy() const { return dummy_; }  // stands in for unused bindings
  const Buffer& dummyWords() const { return dummyWords_; }
  const Buffer& dummyFilm() const { return dummyFilm_; }

 private:
  vk::raii::DescriptorSetLayout set_;
  vk::raii::PipelineLayout pipeline_;
  Buffer dummy_, dummyWords_, dummyFilm_;
};

/// The texel buffers of a scene and of a film, by binding; null or empty = not used.
struct TexelBuffers {
  const Buffer* rows = nullptr;                   // 0, kind upload
  const Buffer* tables = nullptr;                 // 8, kind texelRows
  const Buffer* meshes = nullptr;                 // 9, kind texelRows
  const Buffer* texels = nullptr;                 // 10, kind texelWords
  std::array<const Buffer*, filmBuffers> film{};  // from 11 on, kind film
};

/// Which buffers a pass sees. Immutable; the buffers must outlive its use. Null or empty = not used.
class Bindings {
 public:
  /// `storage[i]` goes to binding 1 + i; at most 7.
  Bindings(const Device& device, const TexelBuffers& scene, std::span<const Buffer* const> storage);
  vk::DescriptorSet set() const { return set_; }

 private:
  void writeTexels(const Device& device, std::uint32_t binding, const Buffer* buffer, const Buffer& dummy);

  vk::raii::DescriptorPool pool_{nullptr};
  vk::DescriptorSet set_;  // dies with the pool
};

/// `layout(constant_id = id) const bool/uint/int/float`: the value's 32 bits.
struct Specialization {
  std::uint32_t id;
  std::uint32_t value;
};

/// A compute shader with entry point main. Construction compiles (any thread); `name` is for messages.
class ComputePass {
 public:
  ComputePass(const Device& device, std::span<const std::uint32_t> spirv,
              std::span<const Specialization> specializations, const std::string& name);

  /// `push`: at most 128 bytes, a multiple of 4, same struct as in the shader. Barriers are the caller's.
  void dispatch(const vk::raii::CommandBuffer& cmd, const Bindings& bindings, const void* push,
                std::size_t pushBytes, std::uint32_t groupsX, std::uint32_t groupsY) const;
  template <class Push>
  void dispatch(const vk::raii::CommandBuffer& cmd, const Bindings& bindings, const Push& push,
                std::uint32_t groupsX, std::uint32_t groupsY) const {
    static_assert(sizeof(Push) <= pushConstantBytes && sizeof(Push) % 4 == 0);
    dispatch(cmd, bindings, &push, sizeof(Push), groupsX, groupsY);
  }

 private:
  vk::PipelineLayout layout_;
  vk::raii::Pipeline pipeline_{nullptr};
};

/// A full-screen quad from gl_VertexIndex (4 vertices, triangle strip) with a fragment shader; no blending.
class GraphicsPass {
 public:
  GraphicsPass(const Device& device, std::span<const std::uint32_t> vertSpirv,
               std::span<const std::uint32_t> fragSpirv, vk::RenderPass renderPass,
               std::span<const Specialization> specializations, const std::string& name);

  /// Inside a render pass compatible with the constructor's. `rect`: viewport and scissor, framebuffer pixels
  /// from the top left; must lie inside the framebuffer.
  void draw(const vk::raii::CommandBuffer& cmd, const Bindings& bindings, const void* push,
            std::size_t pushBytes, PixelRect rect) const;
  template <class Push>
  void draw(const vk::raii::CommandBuffer& cmd, const Bindings& bindings, const Push& push,
            PixelRect rect) const {
    static_assert(sizeof(Push) <= pushConstantBytes && sizeof(Push) % 4 == 0);
    draw(cmd, bindings, &push, sizeof(Push), rect);
  }

 private:
  vk::PipelineLayout layout_;
  vk::raii::Pipeline pipeline_{nullptr};
};

}  // namespace steradian::gpu
