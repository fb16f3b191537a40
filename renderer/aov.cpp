// SPDX-License-Identifier: MIT
// The pass over the first hits, and the figures of the film.
#include "renderer/aov.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "renderer/film_sums.hpp"
#include "renderer/gpu/barriers.hpp"
#include "renderer/loop_budget.hpp"
#include "renderer/renderer_impl.hpp"
#include "renderer/shader_code.hpp"

namespace steradian {

using namespace gpu;

namespace {

constexpr std::uint32_t aovGroupSize = 8;             // local size of aov.comp in x and y
constexpr std::uint32_t raysPerDispatch = 16;         // of one pixel
constexpr std::uint64_t testsPerDispatch = 1u << 25;  // of a ray and a shape: well below a second anywhere

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Sums over the camera rays of each pixel: 4 floats per pixel, see aov.comp.
struct FirstHits {
  std::vector<float> albedo, normal;
  std::vector<std::uint32_t> object;
  double samples = 0.0;

  double hits(std::size_t pixel) const { return albedo[pixel * 4 + 3]; }
};

std::uint32_t groups(std::uint32_t pixels) {
  return (pixels + aovGroupSize - 1) / aovGroupSize;
}

class FirstHitPass {
 public:
  /// Adds rays that ran out of the driver's loop budget to the film's `counters`.
  FirstHitPass(const Device& device, Extent extent, const TexelBuffers& scene, bool shapeHierarchy,
               const Buffer& counters)
      : device_(device),
        extent_(extent),
        pixels_(std::size_t(extent.width) * extent.height),
        pass_(device, aovSpirv(), std::vector<Specialization>{{CONSTANT_SHAPE_HIERARCHY, shapeHierarchy}},
              "aov"),
        albedo_(device, BufferKind::deviceLocal, pixels_ * 16, "albedo"),
        normal_(device, BufferKind::deviceLocal, pixels_ * 16, "normals"),
        object_(device, BufferKind::deviceLocal, pixels_ * 4, "object ids"),
        bindings_(device, scene,
                  std::array<const Buffer*, 5>{&albedo_, &normal_, &object_, nullptr, &counters}) {}

  /// All rows of the film, in bands of bounded work.
  FirstHits run(TraceParams params, std::uint32_t samples, std::uint64_t testsPerVertex) {
    for (const Buffer* buffer : {&albedo_, &normal_, &object_}) fillZero(device_, *buffer);
    const std::uint64_t perRow = std::uint64_t(params.width) * (raysPerDispatch + 1) * testsPerVertex;
    const auto band = std::uint32_t(std::max<std::uint64_t>(aovGroupSize, testsPerDispatch / perRow));
    // A vertex' two traversals and more are room for one camera ray and, once, that of the object id.
    const auto rays =
        std::uint32_t(std::clamp<std::uint64_t>(cpuDriverLoopBudget / testsPerVertex, 1, raysPerDispatch));
    for (params.rowBegin = 0; params.rowBegin < params.height; params.rowBegin = params.rowEnd) {
      params.rowEnd = std::min(params.height, params.rowBegin + band);
      for (params.sampleBegin = 0; params.sampleBegin < samples; params.sampleBegin = params.sampleEnd) {
        params.sampleEnd = std::min(samples, params.sampleBegin + rays);
        device_.run(QueueKind::compute, [&](const auto& cmd) {
          computeToCompute(cmd);
          pass_.dispatch(cmd, bindings_, params, groups(params.width),
                         groups(params.rowEnd - params.rowBegin));
        });
      }
    }
    return {downloadAs<float>(device_, albedo_, 0, pixels_ * 4),
            downloadAs<float>(device_, normal_, 0, pixels_ * 4),
            downloadAs<std::uint32_t>(device_, object_, 0, pixels_), double(samples)};
  }

 private:
  const Device& device_;
  Extent extent_;
  std::size_t pixels_;
  ComputePass pass_;
  Buffer albedo_, normal_, object_;
  Bindings bindings_;
};

/// `value(pixel, channel)` for all pixels.
template <class Value>
AovLayer layer(Aov kind, Extent extent, std::vector<std::string> channels, Value&& value) {
  AovLayer made{nameOf(kind), std::move(channels), {extent.width, extent.height, 0, {}}};
  made.pixels.channels = int(made.channels.size());
  const std::size_t pixels = std::size_t(extent.width) * extent.height;
  made.pixels.pixels.reserve(pixels * made.channels.size());
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < made.channels.size(); ++c) made.pixels.pixels.push_back(float(value(i, c)));
  return made;
}

AovLayer firstHitLayer(Aov kind, Extent extent, const FirstHits& hits) {
  switch (kind) {
    case Aov::albedo:
      return layer(kind, extent, {"R", "G", "B"},
                   [&](std::size_t i, std::size_t c) { return hits.albedo[i * 4 + c] / hits.samples; });
    case Aov::normal:
      return layer(kind, extent, {"X", "Y", "Z"},
                   [&](std::size_t i, std::size_t c) { return hits.normal[i * 4 + c] / hits.samples; });
    case Aov::depth:
      return layer(kind, extent, {"Z"}, [&](std::size_t i, std::size_t) {
        return hits.hits(i) > 0.0 ? hits.normal[i * 4 + 3] / hits.hits(i) : infinite;
      });
    case Aov::coverage:
      return layer(kind, extent, {"A"},
                   [&](std::size_t i, std::size_t) { return hits.hits(i) / hits.samples; });
    default:
      return layer(kind, extent, {"ID"}, [&](std::size_t i, std::size_t) { return float(hits.object[i]); });
  }
}

AovLayer filmLayer(Aov kind, Extent extent, const FilmSums& sums) {
  const auto counts = [&](std::size_t pixel) {
    const int row = int(pixel / std::size_t(extent.width));
    return glm::dvec2(double(sums.count(0, row)), double(sums.count(1, row)));
  };
  if (kind == Aov::samples)
    return layer(kind, extent, {"N"}, [&](std::size_t i, std::size_t) { return counts(i).x + counts(i).y; });
  return layer(kind, extent, {"R", "G", "B"}, [&](std::size_t i, std::size_t c) {
    const glm::dvec2 n = counts(i);
    if (n.x == 0.0 || n.y == 0.0) return double(infinite);  // not known at all
    // As meter.comp: the squared difference of the halves, brought to the variance of the joint mean.
    const double difference = sums.radiance(0, i * 3 + c) / n.x - sums.radiance(1, i * 3 + c) / n.y,
                 all = n.x + n.y;
    return difference * difference * n.x * n.y / (all * all);
  });
}

bool ofFilm(Aov kind) {
  return kind == Aov::samples || kind == Aov::variance;
}

}  // namespace

const char* nameOf(Aov aov) {
  constexpr const char* names[] = {"albedo", "normal", "depth", "id", "coverage", "samples", "variance"};
  return names[int(aov)];
}

std::vector<AovLayer> Renderer::aovs(const AovRequest& request) {
  if (!impl_->film || request.kinds.empty()) return {};
  const Film& film = impl_->currentFilm();
  const Extent extent = film.extent();
  const auto& kinds = request.kinds;
  FirstHits hits;
  FilmSums sums;
  if (std::any_of(kinds.begin(), kinds.end(), ofFilm)) sums = filmSums();
  const bool variance = std::find(kinds.begin(), kinds.end(), Aov::variance) != kinds.end();
  if (variance && !impl_->metered())
    throw Error(ExitCode::usage, "the variance of the pixels needs the error meter");
  if (!std::all_of(kinds.begin(), kinds.end(), ofFilm)) {
    TraceParams params = impl_->scene.params;
    FirstHitPass pass(*impl_->device, extent, impl_->sceneBuffers(), impl_->scene.shapeHierarchy(),
                      film.counters());
    hits = pass.run(params, std::uint32_t(std::clamp(request.samples, 1, 4096)),
                    iterationsPerVertex(params, 1, impl_->scene.traversalSteps * impl_->scene.traversals));
    impl_->stats.faults =
        downloadAs<std::uint32_t>(*impl_->device, film.counters(), COUNTER_FAULTS * 4, 1)[0];
  }
  std::vector<AovLayer> layers;
  for (const Aov kind : kinds)
    layers.push_back(ofFilm(kind) ? filmLayer(kind, extent, sums) : firstHitLayer(kind, extent, hits));
  return layers;
}

}  // namespace steradian
