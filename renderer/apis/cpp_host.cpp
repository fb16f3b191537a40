// SPDX-License-Identifier: MIT
// Work groups are handed to threads as they come.
#include "renderer/apis/cpp_host.hpp"

#include <limits>
#include <thread>

#include "renderer/apis/invocation.hpp"

namespace steradian::apis {
namespace {

class CppHost : public KernelHost {
 public:
  explicit CppHost(const KernelInput& input) : input_(input) { clear(); }

  std::string runsOn() const override {
    return std::to_string(threads_) + (threads_ == 1 ? " thread" : " threads") + ", C++ through GLM";
  }
  std::optional<double> compileSeconds() const override { return std::nullopt; }
  std::uint64_t loopBudget() const override { return std::numeric_limits<std::uint64_t>::max(); }

  void clear() override {
    const std::size_t pixels = std::size_t(input_.film.width) * input_.film.height;
    for (auto& half : film_.digits)
      for (auto& digits : half) digits.assign(pixels, glm::ivec4(0));
    film_.counters.fill(0u);
  }

  void dispatch(const gpu::TraceParams& params) override {
    const glm::uvec3 size = Invocation::gl_WorkGroupSize;
    const glm::uvec3 groups((params.width + size.x - 1) / size.x,
                            (params.rowEnd - params.rowBegin + size.y - 1) / size.y, 1);
    std::atomic<std::uint32_t> next{0};
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < threads_; ++i)
      workers.emplace_back([&] {
        for (std::uint32_t group; (group = next++) < groups.x * groups.y;) runGroup(params, groups, group);
      });
  }

  KernelSums read() override { return film_; }

 private:
  void runGroup(const gpu::TraceParams& params, glm::uvec3 groups, std::uint32_t group) {
    const glm::uvec3 size = Invocation::gl_WorkGroupSize;
    const int half = (params.flags & gpu::TRACE_HALF_B) != 0 ? 1 : 0;
    for (std::uint32_t local = 0; local < size.x * size.y; ++local) {
      Invocation invocation(input_.constants);
      invocation.params = Invocation::Params(params);
      invocation.sceneRows = input_.traced.scene.rows;
      invocation.tableRows = input_.traced.tables;
      invocation.meshRows = input_.traced.meshes;
      invocation.texels = input_.traced.texels;
      invocation.lowBefore = invocation.filmLow = film_.digits[half][0];
      invocation.middleBefore = invocation.filmMiddle = film_.digits[half][1];
      invocation.highBefore = invocation.filmHigh = film_.digits[half][2];
      invocation.counters = film_.counters;
      invocation.gl_NumWorkGroups = groups;
      invocation.gl_WorkGroupID = {group % groups.x, group / groups.x, 0};
      invocation.gl_LocalInvocationID = {local % size.x, local / size.x, 0};
      invocation.gl_GlobalInvocationID = invocation.gl_WorkGroupID * size + invocation.gl_LocalInvocationID;
      invocation.main();
    }
  }

  const KernelInput& input_;
  unsigned threads_ = std::max(1u, std::thread::hardware_concurrency());
  KernelSums film_;
};

}  // namespace

std::unique_ptr<KernelHost> makeCppHost(const KernelInput& input) {
  return std::make_unique<CppHost>(input);
}

}  // namespace steradian::apis
