// SPDX-License-Identifier: MIT
// Scene -> image that converges. No Vulkan type appears here; one thread owns a Renderer.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image.hpp"
#include "renderer/scene/error.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian {

namespace gpu {
class Device;
}

/// What can be asked of the machine before any renderer exists.
struct DeviceDescription {
  int index = 0;
  std::string name, driver, type,
      api;             // type: "discrete GPU", "CPU" ...; driver: name and version; api: "1.3.230"
  std::string queues;  // "compute family 2, graphics family 0"
  bool usable = false;
  std::string reason;   // why not usable
  bool chosen = false;  // the default choice
};

/// Throws Error(noDevice) with a package hint when no Vulkan loader or driver answers.
std::vector<DeviceDescription> describeDevices();

/// How a surface is made without this header knowing a window system or Vulkan.
struct SurfaceSource {
  std::vector<const char*> instanceExtensions;
  std::function<std::uint64_t(void* vkInstance)> create;  // returns a VkSurfaceKHR, owned by the Device
};

struct DeviceRequest {
  std::string device;       // name part or index; empty = the best one
  bool validation = false;  // core + synchronization validation; also by STERADIAN_VALIDATION=1
  const SurfaceSource* surface = nullptr;  // present on it; null = headless
};

/// Throws Error(noDevice): nothing fits, or nothing is called `request.device` (the message lists what there
/// is).
std::shared_ptr<gpu::Device> openDevice(const DeviceRequest& request);
DeviceDescription describe(const gpu::Device& device);
/// Validation messages since start (warnings and errors). 0 is a promise.
int validationMessages(const gpu::Device& device);

struct Extent {
  int width = 0, height = 0;
  bool operator==(const Extent&) const = default;
};

/// How wrong the picture still is, from the two half-buffers (accuracy: image-level figures only).
struct ErrorEstimate {
  double rmse = 0.0;     // scene-linear, over pixels and channels
  double relRmse = 0.0;  // sqrt(mean((estimate - truth)^2 / (estimate^2 + 0.01)))
  double slope = 0.0;    // d log RMSE / d log samples since the last doubling; 0 = not known yet
  bool valid = false;    // both halves hold samples
};

struct VariantInfo {
  bool specialized = false;
  std::vector<std::string> features;  // compiled in
  std::vector<std::string> leftOut;   // left out because the scene needs none
};

struct RenderStats {
  std::uint64_t samples = 0;  // per pixel, complete over the whole film
  std::uint64_t raysClosest = 0, raysShadow = 0;
  std::uint64_t nanSamples = 0;  // dropped and counted
  std::uint64_t faults = 0;   // samples that met a feature left out or ran out of loop budget: 0 is a promise
  double traceSeconds = 0.0;  // device time when timestamps exist, else wall time of the dispatches
  double msPerSample = 0.0;   // of the whole film, recent average
  double mraysPerSecond = 0.0;  // closest + shadow, recent average
  double compileSeconds = 0.0;  // of pipelines, in all
  ErrorEstimate error;
  VariantInfo variant;
};

struct PickResult {
  Id object = Id::none;
  glm::dvec3 position{0.0};  // world, metres
  glm::dvec3 normal{0.0};    // world, unit, facing the viewer
  double distance = 0.0;     // metres from the camera
};

/// A tonemapper as the display pass needs it: GLSL text with `vec3 tonemap(vec3 sceneLinear)` and its
/// parameters.
struct Tonemapper {
  std::string id;
  std::string glsl;
  struct Parameter {
    std::string id;
    float value;
  };
  std::vector<Parameter> parameters;  // at most 8; each is a global float of that name in the GLSL
  bool operator==(const Tonemapper& o) const { return id == o.id && glsl == o.glsl; }
};

/// Owns the film, the scene on the device and the passes. Every method belongs to the thread that made it.
class Renderer {
 public:
  /// Compiles the generic pipeline (ready at return). Throws Error(noDevice).
  explicit Renderer(std::shared_ptr<gpu::Device> device);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Compares with the last call, uploads what changed, starts over when the radiance would differ.
  /// Throws Error(badInput) when the device's loop budget or memory cannot take the scene, the old one stays.
  void setScene(const Scene& scene, const CameraView& view, Extent film);
  /// Throws Error(plugin) with the compiler's lines when the GLSL does not compile; the old one stays.
  void setTonemapper(const Tonemapper& tonemapper);
  void setDisplay(const DisplaySettings& display);
  /// Only the sample indices [begin, end) are ever traced; default all, that is 2^32 - 1. Starts over.
  /// Throws Error(usage) when the range is empty.
  void setSampleRange(std::uint64_t begin, std::uint64_t end);
  /// Specialized pipelines may be compiled on a worker thread and swapped in; off = stay generic. Default on.
  void allowSpecialization(bool allow);
  /// Block until the special pipeline for this scene runs (stills and benches).
  void waitForSpecialization();

  /// Trace one batch of about `budgetMs` of device time and wait for it. False when the sample range is
  /// exhausted. Throws Error(noDevice) when the device is lost or does not answer in time.
  bool trace(double budgetMs);
  /// Interactive: as trace(), but first a coarse preview of about `budgetMs`, so that an edit shows at once.
  bool tracePreviewing(double budgetMs);

  const RenderStats& stats() const;
  /// Runs the meter pass and updates stats().error.
  ErrorEstimate measureError();
  std::optional<PickResult> pick(int x, int y);  // film pixels from the top left

  /// Scene-linear radiance, 3 channels, mean over the samples. Shows black where nothing was traced yet.
  Image radiance();
  /// Means of the two half-buffers (tests and merges).
  std::pair<Image, Image> halves();
  /// Display-encoded [0, 1], 3 channels, made by the same pass that draws the viewport.
  Image displayed();

 private:
  friend class Presenter;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace steradian
