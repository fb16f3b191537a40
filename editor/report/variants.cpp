// SPDX-License-Identifier: MIT
// The list of what can be switched off.
#include "editor/report/variants.hpp"

#include <limits>

namespace steradian::report {

const Variant& baseline() {
  static const Variant variant{.id = "full", .label = "Steradian"};
  return variant;
}

std::span<const Variant> ablations() {
  static const Variant list[] = {
      {.id = "no-light-sampling",
       .label = "BSDF sampling alone",
       .ablation = [](Ablation& a) { a.lightSampling = false; }},
      {.id = "no-light-hits",
       .label = "light sampling alone",
       .ablation = [](Ablation& a) { a.lightHits = false; }},
      {.id = "independent-samples",
       .label = "PCG instead of Owen-Sobol",
       .ablation = [](Ablation& a) { a.owenSobol = false; }},
      {.id = "uniform-lights",
       .label = "lights chosen uniformly",
       .ablation = [](Ablation& a) { a.lightTree = false; }},
      {.id = "all-normals",
       .label = "all normals, seen or not",
       .ablation = [](Ablation& a) { a.visibleNormals = false; }},
      {.id = "no-roulette",
       .label = "no Russian roulette",
       .settings = [](RenderSettings& s) { s.russianRoulette = false; }},
      {.id = "no-meter",
       .label = "one joint sequence",
       .settings = [](RenderSettings& s) { s.errorMeter = false; }},
      {.id = "no-compensation",
       .label = "single scattering",
       .settings = [](RenderSettings& s) { s.energyCompensation = false; },
       .anotherPicture = true},
      {.id = "box-filter",
       .label = "box filter",
       .settings = [](RenderSettings& s) { s.filter = PixelFilter::box; },
       .anotherPicture = true},
      {.id = "generic", .label = "generic pipeline", .specialized = false, .onlySpeed = true},
  };
  return list;
}

void prepare(Renderer& renderer, const Variant& variant, Scene scene, const CameraView& view, Extent film,
             std::uint32_t seed) {
  scene.render.seed = seed;
  if (variant.settings) variant.settings(scene.render);
  Ablation ablation;
  if (variant.ablation) variant.ablation(ablation);
  renderer.setAblation(ablation);
  renderer.allowSpecialization(variant.specialized);
  renderer.setScene(scene, view, film);
  renderer.setSampleRange(0, std::numeric_limits<std::uint32_t>::max());
  if (variant.specialized) renderer.waitForSpecialization();
}

}  // namespace steradian::report
