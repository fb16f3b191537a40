// SPDX-License-Identifier: MIT
#include "restore_settings.hpp"

#include "restore_fields.hpp"

namespace gltf {

namespace {

constexpr double kLargest = 3.4e38;

const std::string& textIn(const Json& value, const std::string& key) {
  if (!value.is_string()) failField(key, "a text");
  return value.get_ref<const std::string&>();
}

}  // namespace

sdk::RenderSettingsRecord restoreRender(const Json& render, const sdk::RenderSettingsRecord& start) {
  sdk::RenderSettingsRecord out = start;
  readField(render, "width", out.width, 1, 16384);
  readField(render, "height", out.height, 1, 16384);
  readField(render, "maxBounces", out.maxBounces, 0, 64);
  readField(render, "lightSamples", out.lightSamples, 1, 16);
  readField(render, "russianRoulette", out.russianRoulette, 0, 1);
  readField(render, "errorMeter", out.errorMeter, 0, 1);
  readField(render, "filter", out.filter, 0, 1);
  readField(render, "seed", out.seed, 0, UINT32_MAX);
  readField(render, "energyCompensation", out.energyCompensation, 0, 1);
  readField(render, "clamp", out.clamp, 0, kLargest);
  return out;
}

void restoreDisplay(const Json& display, OwnDisplay& out) {
  readField(display, "exposure", out.record.exposure, -kLargest, kLargest);
  readField(display, "transfer", out.record.transfer, 0, 1);
  readField(display, "gamma", out.record.gamma, 1e-3, 1e3);
  readField(display, "physical", out.record.physical, 0, 1);
  readField(display, "ev100", out.record.ev100, -kLargest, kLargest);
  if (display.contains("tonemapper"))
    out.record.tonemapper = out.texts.emplace_back(textIn(display["tonemapper"], "tonemapper"));
  const Json parameters = display.value("parameters", Json::object());
  for (const auto& [id, value] : parameters.items())
    out.parameters.push_back(
        {out.texts.emplace_back(id), numberIn(value, "parameters", -kLargest, kLargest)});
  out.record.parameters = out.parameters.data();
  out.record.parameterCount = out.parameters.size();
}

}  // namespace gltf
