// SPDX-License-Identifier: MIT
// Scene -> image that converges. No Vulkan type appears here; one thread owns a Renderer.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/aov.hpp"
#include "renderer/scene/error.hpp"
#include "renderer/scene/image.hpp"
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

struct FilmSums;
class SceneCache;

struct Extent {
  int width = 0, height = 0;
  bool operator==(const Extent&) const = default;
};

/// How much of the squared error the worst pixels carry: fireflies are few pixels with most of it.
struct ErrorTails {
  double share = 0.0;        // of the total squared error, 0..1
  std::uint64_t pixels = 0;  // that carry it: the worst 0.1 %; 0 = not measured
  bool heavy = false;        // the error falls slower than it should, and these pixels are why
  bool operator==(const ErrorTails&) const = default;
};

/// How wrong the picture still is, from the two half-buffers (accuracy: image-level figures only).
struct ErrorEstimate {
  double rmse = 0.0;     // scene-linear, over pixels and channels
  double relRmse = 0.0;  // sqrt(mean((estimate - truth)^2 / (truth^2 + 0.01))), by relative_error.hpp
  double slope = 0.0;    // d log RMSE / d log samples over the last doublings; 0 = not known yet
  bool valid = false;    // both halves hold samples
  int doublings = 0;     // of the sample count that the slope stands on
  ErrorTails tails;      // by measureTails()
};

struct VariantInfo {
  bool specialized = false;
  std::vector<std::string> features;  // compiled in
  std::vector<std::string> leftOut;   // left out because the scene needs none
};

struct RenderStats {
  std::uint64_t samples = 0;      // per pixel, complete over the whole film
  double samplesOnAverage = 0.0;  // with those that only some rows hold yet: what progress goes by
  std::uint64_t raysClosest = 0, raysShadow = 0;
  std::uint64_t nanSamples = 0;  // dropped and counted
  std::uint64_t faults = 0;  // samples that met a feature left out or ran out of loop budget: 0 is a promise
  std::optional<double> clampedShare;  // of the light: what clamping cut off, 0..1; nothing when it is off
  double traceSeconds = 0.0;           // device time when timestamps exist, else wall time of the dispatches
  double msPerSample = 0.0;            // of the whole film, recent average
  double mraysPerSecond = 0.0;         // closest + shadow, recent average
  double compileSeconds = 0.0;         // of pipelines, in all
  bool compiling = false;              // a patient renderer waits for a pipeline; the last picture stays
  std::size_t meshBytes = 0, textureBytes = 0, skyBytes = 0;  // on the device
  ErrorEstimate error;
  VariantInfo variant;
};

/// Methods that a measurement may switch off to find out what they are worth. The expected picture stays the
/// same; only its noise changes.
struct Ablation {
  bool lightSampling = true;   // area lights and sky are sampled; off = met by paths alone
  bool lightHits = true;       // they count when paths meet them; off = sampled alone
  bool owenSobol = true;       // off = PCG: independent numbers
  bool lightTree = true;       // off = uniform choice among many lights
  bool visibleNormals = true;  // off = facets are drawn whether they are seen or not
  bool operator==(const Ablation&) const = default;
};

/// How rays find shapes that have bounds, the same either way: one after the other, or through the hierarchy
/// over the scene. Automatic: what is faster for their number.
enum class ShapeSearch { automatic, list, hierarchy };

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
  /// Renderers that share `cache` make what is heavy about a scene once; null = one of its own. Throws
  /// Error(noDevice).
  explicit Renderer(std::shared_ptr<gpu::Device> device, std::shared_ptr<SceneCache> cache = nullptr);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Compares with the last call, uploads what changed, starts over when the radiance would differ.
  /// Throws Error(badInput) when the device's loop budget or memory cannot take the scene, the old one stays.
  void setScene(const Scene& scene, const CameraView& view, Extent film);
  /// Makes ahead what setScene would have to make: what is heavy about the scene, and a pipeline. Any thread,
  /// beside every other method. `goOn` is told the share that is done, 0..1; false ends it early. Throws what
  /// setScene throws, and Error(noDevice) when the pipeline cannot be compiled.
  void prepare(const Scene& scene, const CameraView& view, Extent film,
               const std::function<bool(double)>& goOn);
  /// Throws Error(plugin) with the compiler's lines when the GLSL does not compile; the old one stays.
  void setTonemapper(const Tonemapper& tonemapper);
  void setDisplay(const DisplaySettings& display);
  /// Only the sample indices [begin, end) are ever traced; default all, that is 2^32 - 1. Starts over.
  /// Throws Error(usage) when the range is empty.
  void setSampleRange(std::uint64_t begin, std::uint64_t end);
  /// Go on to sample index `end` without starting over; what is accumulated beyond it stays.
  void extendSamples(std::uint64_t end);
  /// Specialized pipelines may be compiled on a worker thread and swapped in; off = stay generic. Default on.
  void allowSpecialization(bool allow);
  /// Default: everything on. Starts over when it changes.
  void setAblation(const Ablation& ablation);
  /// For the scenes that are set from now on; default automatic. For measurements and tests.
  void setShapeSearch(ShapeSearch search);
  /// For windows: tracing never waits for a pipeline; until one is ready it does nothing and the last picture
  /// stays. Only the very first is waited for. Default off.
  void setPatient(bool patient);
  /// Block until the special pipeline for this scene runs (stills and benches).
  void waitForSpecialization();
  /// The same for a frame loop: true while the special pipeline is being compiled. Never blocks.
  bool awaitsSpecialization();

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
  /// The accumulated sums without loss (parts of a still that are merged later).
  FilmSums filmSums();
  /// Reads the half-buffers back and updates stats().error.tails: costs a transfer of the film.
  ErrorTails measureTails();
  /// The same in slices, between which samples may be added: reads `mostPixels` of the film, at least a row.
  /// True when the last slice is in and the figure is new. Starting over drops what was read.
  bool measureTails(std::size_t mostPixels);
  /// Some rows hold more samples than others: a pass over the film is under way.
  bool midPass() const;
  /// Equal for pictures that differ in their sample indices only: scene, view, size, settings and seed.
  std::uint64_t sceneFingerprint() const;
  /// Further layers of the picture, in the order asked for: from the film, or by tracing camera rays now.
  /// Throws Error(usage) when the variance is asked for without the meter.
  std::vector<AovLayer> aovs(const AovRequest& request);
  /// Display-encoded [0, 1], 3 channels, made by the same pass that draws the viewport.
  Image displayed();

 private:
  friend class Presenter;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace steradian
