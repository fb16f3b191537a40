// SPDX-License-Identifier: MIT
#include "renderer/display.hpp"

#include <cmath>

#include "renderer/gpu/barriers.hpp"
#include "renderer/shader_code.hpp"

namespace steradian {
namespace {

constexpr std::size_t maxParameters = std::size(decltype(gpu::DisplayParams::parameters){});

// Until a tonemapper is set: the display's range as it is.
const Tonemapper identity{"none", "vec3 tonemap(vec3 sceneLinear) { return sceneLinear; }\n", {}};

}  // namespace

float exposureScaleOf(const DisplaySettings& settings) {
  const float scale = std::exp2(settings.exposure);
  return settings.physical ? scale * std::exp2(-settings.ev100) / 1.2f : scale;
}

std::string displaySource(const Tonemapper& tonemapper, ShaderStage stage) {
  if (tonemapper.parameters.size() > maxParameters)
    throw Error(ExitCode::plugin, tonemapper.id + ": has " + std::to_string(tonemapper.parameters.size()) +
                                      " parameters; at most " + std::to_string(maxParameters) +
                                      " are possible");
  std::string source = "#version 460\n";
  source += gpuTypesText();
  source += "layout(push_constant) uniform Push { DisplayParams display; };\n";
  std::string assignments;
  for (std::size_t i = 0; i < tonemapper.parameters.size(); ++i) {
    const std::string& id = tonemapper.parameters[i].id;
    source += "float " + id + ";\n";
    assignments += "  " + id + " = display.parameters[" + std::to_string(i) + "];\n";
  }
  source += "void setTonemapperParameters() {\n" + assignments + "}\n#line 1\n";
  source += tonemapper.glsl;
  source += "\n";
  source += displayText();
  source += stage == ShaderStage::compute ? displayComputeText() : displayFragmentText();
  return source;
}

Display::Display(const gpu::Device& device) : device_(device) {
  setTonemapper(identity);
}

void Display::setTonemapper(const Tonemapper& tonemapper) {
  if (version_ > 0 && tonemapper == tonemapper_) {
    tonemapper_.parameters = tonemapper.parameters;
    return;
  }
  spirv_ =
      compileGlsl(displaySource(tonemapper, ShaderStage::fragment), ShaderStage::fragment, tonemapper.id);
  compute_.reset();
  tonemapper_ = tonemapper;
  ++version_;
}

gpu::DisplayParams Display::params(Extent film, PixelRect rect) const {
  gpu::DisplayParams p{};
  p.rectX = float(rect.x);
  p.rectY = float(rect.y);
  p.rectWidth = float(rect.width);
  p.rectHeight = float(rect.height);
  p.width = std::uint32_t(film.width);
  p.height = std::uint32_t(film.height);
  p.exposureScale = exposureScaleOf(settings_);
  p.transfer = std::uint32_t(settings_.transfer);
  p.inverseGamma = 1.0f / settings_.gamma;
  for (std::size_t i = 0; i < tonemapper_.parameters.size(); ++i) {
    const auto chosen = settings_.parameters.find(tonemapper_.parameters[i].id);
    p.parameters[i] = chosen != settings_.parameters.end() ? chosen->second : tonemapper_.parameters[i].value;
  }
  return p;
}

std::unique_ptr<gpu::GraphicsPass> Display::pipeline(gpu::TargetPass renderPass) const {
  return std::make_unique<gpu::GraphicsPass>(device_, displayVertexSpirv(), spirv_, renderPass,
                                             std::span<const gpu::Specialization>{}, "display");
}

Image Display::picture(const gpu::Buffer& resolved, Extent film) {
  constexpr auto stage = ShaderStage::compute;
  if (!compute_)
    compute_ = std::make_unique<gpu::ComputePass>(
        device_, compileGlsl(displaySource(tonemapper_, stage), stage, tonemapper_.id),
        std::span<const gpu::Specialization>{}, "display");
  const std::size_t pixels = std::size_t(film.width) * std::size_t(film.height);
  const gpu::Buffer encoded(device_, gpu::BufferKind::deviceLocal, pixels * sizeof(glm::vec4), "picture");
  const gpu::Buffer* const storage[] = {nullptr, nullptr, nullptr, nullptr, &resolved, &encoded};
  const gpu::Bindings bindings(device_, {}, storage);
  constexpr std::uint32_t groupsX = 256, perRow = groupsX * 64;  // display.comp takes 64 pixels a group
  device_.run(gpu::QueueKind::compute, [&](const auto& cmd) {
    gpu::computeToCompute(cmd);
    compute_->dispatch(cmd, bindings, params(film, {0, 0, film.width, film.height}), groupsX,
                       std::uint32_t((pixels + perRow - 1) / perRow));
  });
  const auto values = gpu::downloadAs<glm::vec4>(device_, encoded, 0, pixels);
  Image image{film.width, film.height, 3, std::vector<float>(pixels * 3)};
  for (std::size_t i = 0; i < pixels; ++i)
    for (int c = 0; c < 3; ++c) image.pixels[i * 3 + std::size_t(c)] = values[i][c];
  return image;
}

}  // namespace steradian
