// SPDX-License-Identifier: MIT
// Runs production GLSL on the device: rows of questions in, rows of answers out.
#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "renderer/gpu/device.hpp"
#include "tests/measured.hpp"

namespace steradian::kernel {

using Rows = std::vector<glm::vec4>;

/// A compiled test kernel (kernels/kernel_*.comp).
struct Kernel {
  std::span<const std::uint32_t> spirv;
  const char* name;
};

/// What an operation of a kernel reads and writes.
struct Task {
  std::uint32_t operation = 0;
  std::size_t rowsIn = 1;       // per invocation; 0 = the questions are shared by all
  std::size_t rowsOut = 1;      // per invocation
  std::size_t invocations = 0;  // 0 = as many as the questions need
  std::vector<std::byte> push = {};
  Rows scene = {};                                                      // binding 0
  Rows tables = {};                                                     // binding 8
  Rows mesh = {};                                                       // binding 9
  std::vector<std::uint32_t> texels = {};                               // binding 10
  std::vector<std::pair<std::uint32_t, std::uint32_t>> constants = {};  // of the production GLSL: id, value
};

template <class Push>
std::vector<std::byte> pushBytes(const Push& push) {
  std::vector<std::byte> bytes(sizeof push);
  std::memcpy(bytes.data(), &push, sizeof push);
  return bytes;
}

/// One device per suite; it must end without validation messages.
class KernelTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite();
  static void TearDownTestSuite();

  /// Answers in the order of the questions. Blocks.
  static Rows run(const Kernel& kernel, const Task& task, const Rows& questions);

  static std::shared_ptr<gpu::Device> device_;
};

/// Numbers of a fixed seed.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low = 0.0, double high = 1.0) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// 10^[low, high), evenly by logarithm.
  double decades(double low, double high);
  glm::dvec3 direction();

 private:
  std::mt19937_64 engine_;
};

inline glm::dvec3 xyz(glm::vec4 v) {
  return glm::dvec3(v.x, v.y, v.z);
}
/// A miss, as the shaders say it.
inline bool missed(float t) {
  return t >= 1e30f;
}
/// The distance between the floats around x.
double ulp(double x);

}  // namespace steradian::kernel
