// SPDX-License-Identifier: MIT
#include "renderer/shader_code.hpp"

namespace steradian {
namespace {
#include "shaders/aov.comp.h"
#include "shaders/cast_rays.comp.h"
#include "shaders/display.comp.text.h"
#include "shaders/display.frag.text.h"
#include "shaders/display.glsl.text.h"
#include "shaders/display.vert.h"
#include "shaders/gpu_types.h.text.h"
#include "shaders/level.comp.h"
#include "shaders/meter.comp.h"
#include "shaders/path_trace.comp.h"
#include "shaders/pick.comp.h"
#include "shaders/resolve.comp.h"
}  // namespace

std::span<const std::uint32_t> pathTraceSpirv() {
  return path_trace_comp_spirv;
}
std::span<const std::uint32_t> resolveSpirv() {
  return resolve_comp_spirv;
}
std::span<const std::uint32_t> levelSpirv() {
  return level_comp_spirv;
}
std::span<const std::uint32_t> meterSpirv() {
  return meter_comp_spirv;
}
std::span<const std::uint32_t> pickSpirv() {
  return pick_comp_spirv;
}
std::span<const std::uint32_t> aovSpirv() {
  return aov_comp_spirv;
}
std::span<const std::uint32_t> castRaysSpirv() {
  return cast_rays_comp_spirv;
}
std::span<const std::uint32_t> displayVertexSpirv() {
  return display_vert_spirv;
}
std::string_view gpuTypesText() {
  return gpu_types_h_text;
}
std::string_view displayText() {
  return display_glsl_text;
}
std::string_view displayFragmentText() {
  return display_frag_text;
}
std::string_view displayComputeText() {
  return display_comp_text;
}

}  // namespace steradian
