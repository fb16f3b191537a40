// SPDX-License-Identifier: MIT
#include "renderer/specialize.hpp"

#include <spirv-tools/optimizer.hpp>
#include <unordered_map>

namespace steradian {

std::vector<std::uint32_t> specialized(std::span<const std::uint32_t> spirv,
                                       std::span<const gpu::Specialization> constants) {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
  for (const gpu::Specialization& constant : constants) values[constant.id] = {constant.value};
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
      .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
      .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
      .RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass());
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  std::vector<std::uint32_t> made;
  return optimizer.Run(spirv.data(), spirv.size(), &made, options) ? made : std::vector<std::uint32_t>();
}

}  // namespace steradian
