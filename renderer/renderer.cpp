// SPDX-License-Identifier: MIT
#include "renderer/renderer.hpp"

#include <algorithm>
#include <bit>

#include "renderer/energy_table.hpp"
#include "renderer/gpu/barriers.hpp"
#include "renderer/mesh_buffer.hpp"
#include "renderer/renderer_impl.hpp"
#include "renderer/scene_size.hpp"
#include "renderer/shader_code.hpp"
#include "renderer/texel_buffer.hpp"

namespace steradian {

using namespace gpu;

namespace {

std::uint64_t loopBudgetOf(const Device& device) {
  return device.description().type == "CPU" ? cpuDriverLoopBudget : gpuLoopBudget;
}

std::uint32_t ablationFlags(const Ablation& a) {
  return (a.lightSampling ? 0u : TRACE_NO_LIGHT_SAMPLING) | (a.lightHits ? 0u : TRACE_NO_BSDF_HITS) |
         (a.owenSobol ? 0u : TRACE_PCG_SAMPLES) | (a.lightTree ? 0u : TRACE_UNIFORM_LIGHTS) |
         (a.visibleNormals ? 0u : TRACE_ALL_NORMALS);
}

Buffer makeTables(const Device& device, SceneCache& cache, const std::shared_ptr<const Image>& environment) {
  const std::span<const glm::vec4> energy = energyTable();
  const auto sky = environment ? cache.skyOf(environment) : nullptr;
  const std::size_t rows = energy.size() + (sky ? sky->size() : 0);
  Buffer tables(device, BufferKind::texelRows, rows * sizeof(glm::vec4), "sky");
  tables.writeRows(0, energy);
  if (sky) tables.writeRows(energy.size_bytes(), std::span<const glm::vec4>(*sky));
  return tables;
}

}  // namespace

Renderer::Impl::Impl(std::shared_ptr<Device> opened, std::shared_ptr<SceneCache> shared)
    : device(std::move(opened)),
      variants(device),
      patientVariants(*device, variants),
      tracer(*device),
      meter(*device),
      resolve(*device, resolveSpirv(), {}, "resolve"),
      pick(*device, pickSpirv(), {}, "pick"),
      display(*device),
      cache(shared ? std::move(shared) : std::make_shared<SceneCache>()) {}

void Renderer::Impl::upload(GpuScene next, Extent extent) {
  const LoopPlan nextPlan =
      planLoops(next.params, loopBudgetOf(*device), next.traversalSteps, next.traversals);
  const std::size_t bytes = next.rows.size() * sizeof(glm::vec4);
  const bool newFilm = !film || film->extent() != extent;
  const bool newRows = rows.size() < bytes;
  // Everything that can fail comes before anything is replaced.
  auto freshFilm = newFilm ? std::make_shared<Film>(*device, extent) : film;
  Buffer freshRows = newRows ? Buffer(*device, BufferKind::upload, std::bit_ceil(bytes), "scene") : Buffer();
  const bool newTables = !tables || next.environment != scene.environment;
  Buffer freshTables = newTables ? makeTables(*device, *cache, next.environment) : Buffer();
  const bool newMeshes = next.meshes != scene.meshes || next.vertices != scene.vertices;
  Buffer freshMeshes = newMeshes ? meshBuffer(*device, next) : Buffer();
  const bool newTexels = next.textures != scene.textures;
  Buffer freshTexels = newTexels ? texelBuffer(*device, next) : Buffer();
  if (newFilm) {
    preview.reset();
    showPreview = false;
  }
  film = std::move(freshFilm);
  if (newFilm) film->clear(sampleBegin, next.filmUnit);  // it may be shown before it is traced
  if (newRows) rows = std::move(freshRows);
  if (newTables) tables = std::move(freshTables);
  if (newMeshes) meshes = std::move(freshMeshes);
  if (newTexels) texels = std::move(freshTexels);
  rows.writeRows(0, std::span<const glm::vec4>(next.rows));
  const bool newBuffers = newRows || newTables || newMeshes || newTexels;
  if (newFilm || newBuffers) film->bind(sceneBuffers());
  if (newBuffers && preview) preview->bind(sceneBuffers());
  scene = std::move(next);
  plan = nextPlan;
  tracer.sceneChanged(double(iterationsPerVertex(scene.params, plan.lightSamples, scene.traversalSteps)));
  restart();
}

void Renderer::Impl::restart() {
  stale = true;
  previewPending = true;
  slope.reset();
  tailSquares.clear();
  tracer.totals = {};
  const double compileSeconds = stats.compileSeconds;
  stats = {};
  stats.compileSeconds = compileSeconds;
  stats.meshBytes = meshes.size();
  stats.textureBytes = texels.size();
  stats.skyBytes = scene.environment ? tables.size() : 0;
}

Film& Renderer::Impl::currentFilm() {
  if (stale) film->clear(sampleBegin, scene.filmUnit);
  stale = false;
  return *film;
}

const ComputePass& Renderer::Impl::pickPass() {
  if (!scene.shapeHierarchy()) return pick;
  const Specialization hierarchy{CONSTANT_SHAPE_HIERARCHY, 1u};
  if (!pickInHierarchy)
    pickInHierarchy = std::make_unique<ComputePass>(*device, pickSpirv(), std::span(&hierarchy, 1), "pick");
  return *pickInHierarchy;
}

VariantKey Renderer::Impl::neededVariant() const {
  VariantKey key = variantFor(scene, plan.lightSamples);
  key.ablation = ablation != Ablation{};
  return key;
}

const ComputePass* Renderer::Impl::tracePass() {
  const VariantKey needed = neededVariant();
  if (needed.ablation) variants.waitFor(needed);  // the generic one does not obey
  const auto choice =
      patient && !needed.ablation ? patientVariants.choose(needed) : std::optional(variants.choose(needed));
  stats.compiling = !choice;
  if (!choice) return nullptr;
  stats.variant = describeVariant(choice->key);
  return choice->pass;
}

bool Renderer::Impl::traceFilm(double budgetMs) {
  const ComputePass* pass = tracePass();
  if (!pass) return true;
  Film& target = currentFilm();
  if (!tracer.step(target, *pass, scene, plan, sampleEnd, budgetMs)) return false;
  if (target.progress.done > target.progress.begin) showPreview = false;
  updateTiming();
  return true;
}

void Renderer::Impl::updateTiming() {
  const TraceTotals& t = tracer.totals;
  stats.samples = film->progress.done - film->progress.begin;
  stats.samplesOnAverage = samplesOnAverage(film->progress, film->extent().height);
  stats.traceSeconds = t.milliseconds * 1e-3;
  stats.msPerSample = t.pixelSamples > 0.0 ? t.milliseconds / t.pixelSamples * double(film->pixels()) : 0.0;
  stats.compileSeconds = variants.compileSeconds();
}

int Renderer::Impl::previewFactor(double budgetMs) const {
  const double ms = tracer.cost().msPerMegasample() * double(film->pixels()) * 1e-6;
  int factor = 1;
  while (factor < 8 && ms / (factor * factor) > budgetMs) factor *= 2;
  return factor;
}

bool Renderer::Impl::tracePreview(double budgetMs) {
  const ComputePass* pass = tracePass();
  if (!pass) return true;
  const int factor = previewFactor(budgetMs);
  previewPending = false;
  if (factor == 1) return traceFilm(budgetMs);
  const Extent coarse{std::max(1, film->extent().width / factor),
                      std::max(1, film->extent().height / factor)};
  if (!preview || preview->extent() != coarse) {
    preview = std::make_shared<Film>(*device, coarse);
    preview->bind(sceneBuffers());
  }
  preview->clear(sampleBegin, scene.filmUnit);
  GpuScene coarseScene = scene;
  coarseScene.params.pixelScale *= float(film->extent().height) / float(coarse.height);
  const TraceTotals before = tracer.totals;
  constexpr double wholeFilm = 1e9;
  tracer.step(*preview, *pass, coarseScene, plan, sampleBegin + 1, wholeFilm);
  tracer.totals = before;
  showPreview = true;
  return true;
}

const ResolvedPicture& Renderer::Impl::resolveNow() {
  currentFilm();
  picture.prepare(*device, film);
  device->run(QueueKind::compute, [&](const auto& cmd) {
    computeToCompute(cmd);
    picture.record(cmd, resolve, metered());
  });
  return picture;
}

Renderer::Renderer(std::shared_ptr<Device> device, std::shared_ptr<SceneCache> cache)
    : impl_(std::make_unique<Impl>(std::move(device), std::move(cache))) {}
Renderer::~Renderer() = default;

void Renderer::setScene(const Scene& scene, const CameraView& view, Extent film) {
  GpuScene next = packScene(scene, view, film, *impl_->cache, impl_->shapeSearch);
  next.params.flags |= ablationFlags(impl_->ablation);
  const bool sameFilm = impl_->film && impl_->film->extent() == film;
  if (sameFilm && next.sameRadiance(impl_->scene)) return;
  checkSize(*impl_->device, scene, next);
  impl_->upload(std::move(next), film);
}

void Renderer::prepare(const Scene& scene, const CameraView& view, Extent film,
                       const std::function<bool(double)>& goOn) {
  impl_->cache->prepare(scene, goOn);
  if (!goOn(1.0)) return;
  const GpuScene packed = packScene(scene, view, film, *impl_->cache);
  const LoopPlan plan =
      planLoops(packed.params, loopBudgetOf(*impl_->device), packed.traversalSteps, packed.traversals);
  impl_->patientVariants.prepare(variantFor(packed, plan.lightSamples));
}

void Renderer::setTonemapper(const Tonemapper& tonemapper) {
  impl_->display.setTonemapper(tonemapper);
}
void Renderer::setDisplay(const DisplaySettings& display) {
  impl_->display.setSettings(display);
}

void Renderer::setSampleRange(std::uint64_t begin, std::uint64_t end) {
  constexpr std::uint64_t countable = 0xffffffffu;  // sample indices are 32-bit on the device
  if (begin >= end || begin >= countable)
    throw Error(ExitCode::usage, "The samples " + std::to_string(begin) + ":" + std::to_string(end) +
                                     " are an empty range; indices run from 0 to " +
                                     std::to_string(countable) + ".");
  impl_->sampleBegin = begin;
  impl_->sampleEnd = std::min(end, countable);
  impl_->restart();
}

void Renderer::extendSamples(std::uint64_t end) {
  impl_->sampleEnd = std::min<std::uint64_t>(end, 0xffffffffu);
}

void Renderer::allowSpecialization(bool allow) {
  impl_->variants.allowSpecial(allow);
}
void Renderer::setAblation(const Ablation& ablation) {
  if (ablation == impl_->ablation) return;
  impl_->scene.params.flags &= ~ablationFlags({false, false, false, false, false});
  impl_->scene.params.flags |= ablationFlags(ablation);
  impl_->ablation = ablation;
  impl_->restart();
}
void Renderer::setShapeSearch(ShapeSearch search) {
  impl_->shapeSearch = search;
}
void Renderer::setPatient(bool patient) {
  impl_->patient = patient;
}
void Renderer::waitForSpecialization() {
  impl_->variants.waitFor(impl_->neededVariant());
}
bool Renderer::awaitsSpecialization() {
  return impl_->variants.awaits(impl_->neededVariant());
}

bool Renderer::trace(double budgetMs) {
  return impl_->film && impl_->traceFilm(budgetMs);
}

bool Renderer::tracePreviewing(double budgetMs) {
  if (!impl_->film) return false;
  return impl_->previewPending ? impl_->tracePreview(budgetMs) : impl_->traceFilm(budgetMs);
}

const RenderStats& Renderer::stats() const {
  return impl_->stats;
}

ErrorEstimate Renderer::measureError() {
  if (!impl_->film) return {};
  const Film& film = impl_->currentFilm();
  const double clamp = impl_->scene.params.clampRadiance;
  const MeterReading r = impl_->meter.read(film, impl_->metered(), clamp);
  RenderStats& stats = impl_->stats;
  stats.nanSamples = r.nan;
  stats.faults = r.faults;
  stats.clampedShare = clamp > 0.0 ? std::optional(r.clampedShare) : std::nullopt;
  stats.raysClosest = r.raysClosest;
  stats.raysShadow = r.raysShadow;
  if (stats.traceSeconds > 0.0)
    stats.mraysPerSecond = double(r.raysClosest + r.raysShadow) / stats.traceSeconds * 1e-6;
  ErrorEstimate& e = stats.error;
  e.valid = impl_->metered() && stats.samples >= 2;
  if (!e.valid) return e;
  e.rmse = std::sqrt(r.meanSquare);
  e.relRmse = std::sqrt(r.meanRelativeSquare);
  impl_->slope.add(stats.samples, e.rmse);
  e.slope = impl_->slope.slope();
  e.doublings = impl_->slope.doublings();
  return e;
}

std::optional<PickResult> Renderer::pick(int x, int y) {
  if (!impl_->film || x < 0 || y < 0 || x >= impl_->film->extent().width || y >= impl_->film->extent().height)
    return std::nullopt;
  TraceParams params = impl_->scene.params;
  params.pickX = std::uint32_t(x);
  params.pickY = std::uint32_t(y);
  const ComputePass& pass = impl_->pickPass();
  impl_->device->run(QueueKind::compute, [&](const auto& cmd) {
    computeToCompute(cmd);
    pass.dispatch(cmd, impl_->film->bindings(), params, 1, 1);
  });
  const auto v = downloadAs<float>(*impl_->device, impl_->film->picked(), 0, PICK_ROWS * 4);
  if (std::bit_cast<std::uint32_t>(v[0]) == NO_PRIMITIVE) return std::nullopt;
  return PickResult{Id{std::bit_cast<std::uint32_t>(v[1])},
                    impl_->scene.origin + glm::dvec3(v[4], v[5], v[6]), glm::dvec3(v[8], v[9], v[10]), v[2]};
}

Image Renderer::displayed() {
  if (!impl_->film) return {};
  const ResolvedPicture& resolved = impl_->resolveNow();
  return impl_->display.picture(resolved.buffer(), resolved.extent());
}

}  // namespace steradian
