// SPDX-License-Identifier: MIT
// shaders/path_trace.comp on APIs other than Vulkan: what it reads, who runs it, and one way to drive them
// all.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/reference/device_paths.hpp"

namespace steradian::apis {

/// The scene as the kernel reads it, and what the Vulkan renderer's special pipeline has compiled in.
struct KernelInput {
  reference::TracedScene traced;
  std::vector<std::uint32_t> constants;  // specialization constants by their id
  Extent film;
};

/// With as many light samples per vertex as `device` takes, so that all APIs trace the same picture. Throws
/// what planLoops() throws.
KernelInput kernelInput(const Scene& scene, const CameraView& view, Extent film, const gpu::Device& device);

/// A film's digits as gpu_types.h describes them, read back: per half-buffer low, middle and high of each
/// pixel.
struct KernelSums {
  std::array<std::array<std::vector<glm::ivec4>, gpu::FILM_DIGITS>, 2> digits;
  std::array<std::uint32_t, gpu::COUNTERS> counters{};
};

/// One API with one scene and its film. One thread.
class KernelHost {
 public:
  virtual ~KernelHost() = default;
  virtual std::string runsOn() const = 0;  // device and driver
  /// From the text to a program that has run once; none: compiled with this program.
  virtual std::optional<double> compileSeconds() const = 0;
  virtual std::uint64_t loopBudget() const = 0;  // iterations of one invocation (loop_budget.hpp)
  virtual void clear() = 0;
  /// Adds the samples of `params` to their half of every pixel. Blocks. Throws Error(noDevice).
  virtual void dispatch(const gpu::TraceParams& params) = 0;
  virtual KernelSums read() = 0;
};

struct KernelRun {
  double seconds = 0.0;  // wall, of all dispatches
  std::uint64_t rays = 0, nan = 0, faults = 0;
  Image mean;  // radiance, 3 channels
};

/// Samples [0, samples) of every pixel, from a cleared film. Throws what planLoops() and dispatch() throw.
KernelRun runKernel(KernelHost& host, const KernelInput& input, std::uint64_t samples);

}  // namespace steradian::apis
