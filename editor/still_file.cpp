// SPDX-License-Identifier: MIT
// Stills through the exporter plugins.
#include "editor/still_file.hpp"

#include <cstdio>
#include <exception>

#include "editor/part/part.hpp"
#include "editor/version.hpp"

namespace steradian {

namespace {

std::string number(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

}  // namespace

std::map<std::string, std::string> metadataOf(const StillOrigin& origin) {
  std::map<std::string, std::string> metadata{
      {"Software", std::string("Steradian ") + kVersion},
      {"steradian:project", origin.project},
      {"steradian:samples", std::to_string(origin.stats.samples)},
      {"steradian:sampleBegin", std::to_string(origin.sampleBegin)},
      {"steradian:seed", std::to_string(origin.seed)},
      {"steradian:device", origin.device},
      {"steradian:version", kVersion},
  };
  if (origin.stats.error.valid) {
    metadata["steradian:rmse"] = number(origin.stats.error.rmse);
    metadata["steradian:relRmse"] = number(origin.stats.error.relRmse);
  }
  if (origin.partial) metadata["steradian:partial"] = "yes";
  return metadata;
}

StillExtras partExtras(Renderer& renderer, const StillOrigin& origin) {
  char scene[17];
  std::snprintf(scene, sizeof scene, "%016llx", (unsigned long long)(renderer.sceneFingerprint()));
  PartOrigin from;
  from.scene = scene;
  from.version = kVersion;
  from.project = origin.project;
  from.seed = origin.seed;
  from.nan = origin.stats.nanSamples;
  from.devices = {origin.device};
  const Part part = partOf(renderer.filmSums(), std::move(from));
  StillExtras extras{layersOf(part), partMetadata(part.origin), meanOf(part)};
  // As merge writes them: the meter on the device rounds.
  if (const ErrorEstimate error = errorOf(part); error.valid) {
    extras.metadata["steradian:rmse"] = number(error.rmse);
    extras.metadata["steradian:relRmse"] = number(error.relRmse);
  }
  return extras;
}

void checkStillPath(const plugins::PluginHost& host, const std::filesystem::path& path) {
  if (!host.exporterFor(path, true)) {
    std::string known;
    for (const auto* exporter : host.contributions(plugins::Kind::exporter))
      for (const std::string& extension :
           exporter->takesImage ? exporter->extensions : std::vector<std::string>{})
        known += (known.empty() ? "" : ", ") + extension;
    throw Error(ExitCode::usage,
                path.string() + ": no exporter writes images of this kind; " +
                    (known.empty() ? "no image exporter plugin was found" : "choose one of " + known));
  }
  std::error_code ignored;
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, ignored))
    throw Error(ExitCode::io,
                path.string() + ": the folder " + folder.string() + " does not exist; create it first");
}

void saveStill(const plugins::PluginHost& host, Renderer& renderer, const StillOrigin& origin,
               const std::vector<std::filesystem::path>& paths, const plugins::Parameters& parameters,
               const StillExtras& extras) {
  const Image radiance = extras.radiance ? *extras.radiance : renderer.radiance();
  const Image displayed = renderer.displayed();
  plugins::ImageToSave image{radiance.width,          radiance.height, radiance.pixels.data(),
                             displayed.pixels.data(), extras.metadata, extras.layers};
  image.metadata.merge(metadataOf(origin));
  // One file that cannot be written must not cost the others.
  std::exception_ptr failure;
  for (const auto& path : paths) try {
      host.exportImage(image, path, {}, parameters);
    } catch (const Error&) {
      if (!failure) failure = std::current_exception();
    }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace steradian
