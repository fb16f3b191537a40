// SPDX-License-Identifier: MIT
#include "settings.hpp"

namespace gltf_export {

namespace {

namespace sdk = steradian::sdk;

Json renderOf(const sdk::RenderSettingsRecord& r) {
  return {{"width", r.width},
          {"height", r.height},
          {"maxBounces", r.maxBounces},
          {"lightSamples", r.lightSamples},
          {"russianRoulette", r.russianRoulette},
          {"errorMeter", r.errorMeter},
          {"filter", r.filter},
          {"seed", r.seed},
          {"energyCompensation", r.energyCompensation},
          {"clamp", r.clamp}};
}

Json displayOf(const sdk::DisplaySettingsRecord& d) {
  Json parameters = Json::object();
  for (std::uint64_t i = 0; i < d.parameterCount; ++i)
    parameters[d.parameters[i].id.str()] = d.parameters[i].value;
  return {{"exposure", d.exposure},   {"tonemapper", d.tonemapper.str()},
          {"parameters", parameters}, {"transfer", d.transfer},
          {"gamma", d.gamma},         {"physical", d.physical},
          {"ev100", d.ev100}};
}

}  // namespace

Json settingsOf(sdk::SceneView& view) {
  return {{"framesPerSecond", view.scene().framesPerSecond},
          {"render", renderOf(view.render())},
          {"display", displayOf(view.display())}};
}

}  // namespace gltf_export
