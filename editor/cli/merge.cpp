// SPDX-License-Identifier: MIT
// steradian merge PART.exr... -o OUT.exr: one picture from disjoint ranges of its samples.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "editor/cli/commands.hpp"
#include "editor/cli/console.hpp"
#include "editor/image_file.hpp"
#include "editor/part/part.hpp"
#include "editor/still_file.hpp"

namespace steradian::cli {

namespace {

struct MergeOptions {
  std::vector<std::filesystem::path> parts, pluginPath;
  std::filesystem::path output;
  bool acceptNan = false;
};

void checkOutput(const plugins::PluginHost& host, const std::filesystem::path& path) {
  checkStillPath(host, path);
  if (path.extension() != ".exr")
    throw Error(ExitCode::usage, path.string() + ": merged parts hold sums of samples; name an .exr file");
}

void save(const plugins::PluginHost& host, const Part& part, const std::filesystem::path& path) {
  const Image mean = meanOf(part);
  const ErrorEstimate error = errorOf(part);
  plugins::ImageToSave image{mean.width, mean.height, mean.pixels.data(), nullptr, partMetadata(part.origin)};
  image.metadata["Software"] = "Steradian " + part.origin.version;
  if (error.valid) {
    image.metadata["steradian:rmse"] = text("%.6g", error.rmse);
    image.metadata["steradian:relRmse"] = text("%.6g", error.relRmse);
  }
  const auto layers = layersOf(part);
  image.layers = layers;
  host.exportImage(image, path);
  std::printf("%s: %dx%d, samples %llu:%llu%s\n", path.c_str(), part.width, part.height,
              (unsigned long long)(part.origin.begin), (unsigned long long)(part.origin.end),
              error.valid ? (", error " + percent(error.relRmse)).c_str() : "");
}

int runMerge(const MergeOptions& options) {
  const plugins::PluginHost host(plugins::defaultSearchPath(options.pluginPath));
  checkOutput(host, options.output);
  std::vector<Part> parts;
  std::vector<std::string> names;
  for (const auto& path : options.parts) {
    const ImageFile file = readImage(path);
    parts.push_back(readPart(path.string(), file.image, file.channelNames, file.metadata));
    names.push_back(path.string());
  }
  const Part whole = merged(std::move(parts), std::move(names),
                            options.acceptNan ? DroppedSamples::accept : DroppedSamples::refuse);
  if (whole.origin.nan > 0)
    warn(std::to_string(whole.origin.nan) + " samples were not a number and were left out");
  save(host, whole, options.output);
  return 0;
}

}  // namespace

void addMerge(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<MergeOptions>();
  CLI::App* command = app.add_subcommand("merge", "One picture from renders of disjoint sample ranges");
  command
      ->add_option("parts", options->parts, "EXR files made by steradian render --samples A:B, or by merge")
      ->required();
  command->add_option("-o,--output", options->output, "EXR to write; it can be merged again")->required();
  command->add_flag("--accept-nan", options->acceptNan,
                    "Also parts that lack samples because they were not a number");
  command->add_option("--plugin-path", options->pluginPath, "Further folder with plugins; repeatable")
      ->allow_extra_args(false);
  command->footer(
      "The sums are exact: any order and any grouping of the parts gives the same bytes, those "
      "of\n"
      "the same --samples rendered at once.\n"
      "Layers (--aov) are kept from the part with the lowest samples that has them.\n"
      "Parts of one scene, size, seed and version whose samples follow each other:\n"
      "  steradian render PROJECT --samples 0:64 -o a.exr     today, or on one machine\n"
      "  steradian render PROJECT --samples 64:128 -o b.exr   tomorrow, or on another\n"
      "  steradian merge a.exr b.exr -o picture.exr");
  command->callback([options, &chosen] { chosen = [options] { return runMerge(*options); }; });
}

}  // namespace steradian::cli
