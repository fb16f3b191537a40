// SPDX-License-Identifier: MIT
#include "renderer/glsl_compiler.hpp"

#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "renderer/scene/error.hpp"

namespace steradian {
namespace {

// Limits a tonemapper can meet; glslang 12 ships its table only as source.
TBuiltInResource limits() {
  TBuiltInResource r{};
  r.maxDrawBuffers = 8;
  r.maxComputeWorkGroupCountX = r.maxComputeWorkGroupCountY = r.maxComputeWorkGroupCountZ = 65535;
  r.maxComputeWorkGroupSizeX = r.maxComputeWorkGroupSizeY = 128;
  r.maxComputeWorkGroupSizeZ = 64;
  r.maxComputeUniformComponents = 1024;
  r.maxFragmentUniformVectors = 16;
  r.maxTextureImageUnits = r.maxCombinedTextureImageUnits = 80;
  r.limits.whileLoops = r.limits.doWhileLoops = r.limits.nonInductiveForLoops = true;
  r.limits.generalUniformIndexing = r.limits.generalVariableIndexing = true;
  r.limits.generalConstantMatrixVectorIndexing = true;
  return r;
}

struct Process {
  Process() { glslang::InitializeProcess(); }
  ~Process() { glslang::FinalizeProcess(); }
};

}  // namespace

std::vector<std::uint32_t> compileGlsl(std::string_view source, ShaderStage stage, const std::string& name) {
  const Process process;  // counted inside glslang: the last one cleans up
  const EShLanguage language = stage == ShaderStage::compute ? EShLangCompute : EShLangFragment;
  glslang::TShader shader(language);
  const char* text = source.data();
  const int length = int(source.size());
  shader.setStringsWithLengths(&text, &length, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 460);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
  const TBuiltInResource resources = limits();
  const auto messages = EShMessages(EShMsgSpvRules | EShMsgVulkanRules);
  if (!shader.parse(&resources, 460, false, messages))
    throw Error(ExitCode::plugin, name + ": the GLSL does not compile:\n" + shader.getInfoLog());
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages))
    throw Error(ExitCode::plugin, name + ": the GLSL does not link:\n" + program.getInfoLog());
  std::vector<std::uint32_t> spirv;
  glslang::GlslangToSpv(*program.getIntermediate(language), spirv);
  return spirv;
}

}  // namespace steradian
