// SPDX-License-Identifier: MIT
// Finds the tonemapper of the display settings.
#include "editor/tonemapping.hpp"

#include <algorithm>

namespace steradian {

Tonemapper tonemapperFor(const plugins::PluginHost& host, const DisplaySettings& display) {
  const plugins::Contribution* found = host.tonemapper(display.tonemapper);
  if (!found) {
    std::string known;
    for (const auto* contribution : host.contributions(plugins::Kind::tonemapper))
      known += (known.empty() ? "" : ", ") + contribution->id;
    throw Error(ExitCode::badInput,
                "no tonemapper is called '" + display.tonemapper + "'; " +
                    (known.empty() ? "no tonemapper plugin was found" : "there are " + known));
  }
  Tonemapper tonemapper{found->id, found->glsl, {}};
  for (const plugins::Parameter& parameter : found->parameters) {
    const auto chosen = display.parameters.find(parameter.id);
    const double value = chosen == display.parameters.end() ? parameter.defaultValue : double(chosen->second);
    tonemapper.parameters.push_back(
        {parameter.id, float(std::clamp(value, parameter.minimum, parameter.maximum))});
  }
  return tonemapper;
}

}  // namespace steradian
