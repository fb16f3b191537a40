// SPDX-License-Identifier: MIT
// What a Renderer owns; seen by renderer.cpp and presenter.cpp only.
#pragma once
#include <memory>

#include "renderer/display.hpp"
#include "renderer/error_meter.hpp"
#include "renderer/patient_variants.hpp"
#include "renderer/renderer.hpp"
#include "renderer/resolve.hpp"
#include "renderer/scene_cache.hpp"
#include "renderer/tracer.hpp"
#include "renderer/variants.hpp"

namespace steradian {

struct Renderer::Impl {
  Impl(std::shared_ptr<gpu::Device> opened, std::shared_ptr<SceneCache> shared);

  void upload(GpuScene next, Extent extent);
  void restart();
  /// The full film, cleared if it holds an older scene.
  Film& currentFilm();
  bool traceFilm(double budgetMs);
  bool tracePreview(double budgetMs);
  int previewFactor(double budgetMs) const;
  const gpu::ComputePass& pickPass();
  VariantKey neededVariant() const;
  /// Null while a patient renderer waits.
  const gpu::ComputePass* tracePass();
  void updateTiming();
  /// What should be on screen: the preview until the film has a whole pass.
  std::shared_ptr<const Film> shownFilm() const { return showPreview ? preview : film; }
  const ResolvedPicture& resolveNow();
  gpu::TexelBuffers sceneBuffers() const { return {&rows, &tables, &meshes, &texels}; }
  bool metered() const { return (scene.params.flags & gpu::TRACE_ERROR_METER) != 0; }

  std::shared_ptr<gpu::Device> device;
  Variants variants;
  PatientVariants patientVariants;
  Tracer tracer;
  ErrorMeter meter;
  SlopeTracker slope;
  gpu::ComputePass resolve, pick;
  std::unique_ptr<gpu::ComputePass> pickInHierarchy;  // made when first needed
  Display display;

  Ablation ablation;
  ShapeSearch shapeSearch = ShapeSearch::automatic;
  std::shared_ptr<SceneCache> cache;
  GpuScene scene;
  LoopPlan plan;
  gpu::Buffer rows, tables, meshes, texels;
  std::shared_ptr<Film> film, preview;
  ResolvedPicture picture;  // for stills and read-back
  bool stale = true;        // the film's samples belong to an older scene
  bool previewPending = false;
  bool showPreview = false;
  bool patient = false;
  std::uint64_t sampleBegin = 0, sampleEnd = 0xffffffffu;
  std::vector<double> tailSquares;  // squared errors of the first pixels, while measureTails() is under way
  RenderStats stats;
};

}  // namespace steradian
