// SPDX-License-Identifier: MIT
// Finds the module beside this program and hands the scene over.
#include "renderer/apis/opengl_host.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <span>

#include "renderer/apis/opengl_module.hpp"
#include "renderer/loop_budget.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::apis {
namespace {

namespace fs = std::filesystem;

struct Module {
  OpenGlOpen* open = nullptr;
  OpenGlClear* clear = nullptr;
  OpenGlDispatch* dispatch = nullptr;
  OpenGlRead* read = nullptr;
  OpenGlClose* close = nullptr;

  Module() {
    std::error_code none;
    const fs::path path =
        fs::read_symlink("/proc/self/exe", none).parent_path().parent_path() / STERADIAN_OPENGL_MODULE;
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library)
      throw Error(ExitCode::noDevice, std::string("the OpenGL module cannot be loaded: ") + dlerror() +
                                          "; build it with libegl-dev and libopengl-dev");
    find(library, open, "steradianOpenGlOpen");
    find(library, clear, "steradianOpenGlClear");
    find(library, dispatch, "steradianOpenGlDispatch");
    find(library, read, "steradianOpenGlRead");
    find(library, close, "steradianOpenGlClose");
  }

 private:
  template <class Function>
  static void find(void* library, Function*& function, const char* name) {
    function = reinterpret_cast<Function*>(dlsym(library, name));
    if (!function)
      throw Error(ExitCode::noDevice,
                  std::string("the OpenGL module is another version's: no ") + name + "; build it again");
  }
};

OpenGlBytes bytesOf(const auto& values) {
  return {values.data(), std::span(values).size_bytes()};
}

class OpenGlHost : public KernelHost {
 public:
  OpenGlHost(const KernelInput& input, bool software)
      : pixels_(std::size_t(input.film.width) * input.film.height) {
    const OpenGlScene scene{
        bytesOf(input.traced.scene.rows), bytesOf(input.traced.tables),     bytesOf(input.traced.meshes),
        bytesOf(input.traced.texels),     input.constants.data(),           input.constants.size(),
        std::uint32_t(input.film.width),  std::uint32_t(input.film.height), software ? 1 : 0};
    OpenGlText message{};
    tracer_ = module_.open(&scene, &message, &compileSeconds_, &software_);
    if (!tracer_) throw Error(ExitCode::noDevice, message.text);
    runsOn_ = message.text;
  }
  ~OpenGlHost() override { module_.close(tracer_); }
  OpenGlHost(const OpenGlHost&) = delete;
  OpenGlHost& operator=(const OpenGlHost&) = delete;

  std::string runsOn() const override { return runsOn_; }
  std::optional<double> compileSeconds() const override { return compileSeconds_; }
  std::uint64_t loopBudget() const override { return software_ ? cpuDriverLoopBudget : gpuLoopBudget; }
  void clear() override { module_.clear(tracer_); }

  void dispatch(const gpu::TraceParams& params) override {
    constexpr std::uint32_t group = 8;  // local size of path_trace.comp in x and y
    const unsigned error =
        module_.dispatch(tracer_, &params, sizeof params, (params.width + group - 1) / group,
                         (params.rowEnd - params.rowBegin + group - 1) / group,
                         (params.flags & gpu::TRACE_HALF_B) != 0 ? 1 : 0);
    if (error != 0)
      throw Error(ExitCode::noDevice, "OpenGL: the dispatch failed with error " + std::to_string(error));
  }

  KernelSums read() override {
    KernelSums sums;
    for (const int half : {0, 1}) {
      for (auto& digits : sums.digits[half]) digits.resize(pixels_);
      auto& [low, middle, high] = sums.digits[half];
      module_.read(tracer_, half, &low[0].x, &middle[0].x, &high[0].x, sums.counters.data());
    }
    return sums;
  }

 private:
  Module module_;
  std::size_t pixels_;
  OpenGlTracer* tracer_ = nullptr;
  std::string runsOn_;
  double compileSeconds_ = 0.0;
  int software_ = 0;
};

}  // namespace

std::unique_ptr<KernelHost> makeOpenGlHost(const KernelInput& input, bool software) {
  return std::make_unique<OpenGlHost>(input, software);
}

}  // namespace steradian::apis
