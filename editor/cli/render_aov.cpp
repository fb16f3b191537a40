// SPDX-License-Identifier: MIT
#include "editor/cli/render_aov.hpp"

#include <algorithm>
#include <sstream>

namespace steradian::cli {

namespace {

Aov parseAov(const std::string& name) {
  std::string known;
  for (const Aov aov : kAllAovs) {
    if (name == nameOf(aov)) return aov;
    known += std::string(known.empty() ? "" : ", ") + nameOf(aov);
  }
  throw Error(ExitCode::usage, "--aov: there is no layer '" + name + "'; choose among " + known + ", or all");
}

/// A figure of all samples; the others are of camera rays alone.
bool ofFilm(Aov aov) {
  return aov == Aov::samples || aov == Aov::variance;
}

}  // namespace

std::vector<Aov> parseAovs(const std::string& text, const std::vector<std::filesystem::path>& outputs,
                           bool errorMeter, bool part) {
  if (text.empty()) return {};
  std::vector<Aov> kinds;
  std::istringstream names(text);
  for (std::string name; std::getline(names, name, ',');) {
    if (name == "all")
      std::copy_if(std::begin(kAllAovs), std::end(kAllAovs), std::back_inserter(kinds),
                   [&](Aov aov) { return !(part && ofFilm(aov)) && (errorMeter || aov != Aov::variance); });
    else
      kinds.push_back(parseAov(name));
  }
  std::vector<Aov> once;
  for (const Aov aov : kinds)
    if (std::find(once.begin(), once.end(), aov) == once.end()) once.push_back(aov);
  if (!errorMeter && std::find(once.begin(), once.end(), Aov::variance) != once.end())
    throw Error(ExitCode::usage,
                "--aov variance needs the error meter; leave out --no-meter or turn it on in the project");
  if (part && std::any_of(once.begin(), once.end(), ofFilm))
    throw Error(
        ExitCode::usage,
        "--aov: samples and variance are of the whole picture, not of --samples; merge tells its error");
  const auto holdsLayers = [](const std::filesystem::path& path) { return path.extension() == ".exr"; };
  if (std::none_of(outputs.begin(), outputs.end(), holdsLayers))
    throw Error(ExitCode::usage, "--aov: only .exr files hold layers; add -o NAME.exr");
  return once;
}

std::vector<plugins::ImageLayer> aovLayers(Renderer& renderer, const std::vector<Aov>& kinds, bool part) {
  constexpr std::uint64_t enough = 64;  // camera rays: soft edges without steps
  const auto samples = part ? enough : std::clamp<std::uint64_t>(renderer.stats().samples, 1, enough);
  std::vector<plugins::ImageLayer> layers;
  for (AovLayer& layer : renderer.aovs({kinds, int(samples)}))
    layers.push_back({std::move(layer.name), std::move(layer.pixels), std::move(layer.channels)});
  return layers;
}

}  // namespace steradian::cli
