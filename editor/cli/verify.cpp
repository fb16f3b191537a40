// SPDX-License-Identifier: MIT
// The options, and the way from a project to a verdict.
#include "editor/cli/verify.hpp"

#include <CLI/CLI.hpp>

#include "editor/cli/render_scene.hpp"
#include "editor/cli/verify_report.hpp"

namespace steradian::cli {

namespace {

constexpr std::uint64_t samplesByDefault = 4;
constexpr std::size_t pathsInFull = 8;  // more are summed up only

/// "X,Y" or "X0,Y0,X1,Y1", the last pixel included.
PixelRect parsePixels(const std::string& text, Extent film) {
  int v[4] = {}, end = 0;
  const int read = std::sscanf(text.c_str(), "%d,%d%n,%d,%d%n", v, v + 1, &end, v + 2, v + 3, &end);
  if ((read != 2 && read != 4) || std::size_t(end) != text.size())
    throw Error(ExitCode::usage, "--verify-pixel: '" + text + "' is not valid; expected X,Y or X0,Y0,X1,Y1");
  if (read == 2) v[2] = v[0], v[3] = v[1];
  if (v[0] < 0 || v[1] < 0 || v[2] < v[0] || v[3] < v[1] || v[2] >= film.width || v[3] >= film.height)
    throw Error(ExitCode::usage, "--verify-pixel: '" + text + "' lies outside the film of " +
                                     std::to_string(film.width) + " x " + std::to_string(film.height) +
                                     " pixels, counted from 0 at the top left");
  return {v[0], v[1], v[2] - v[0] + 1, v[3] - v[1] + 1};
}

std::vector<VerifiedPath> verify(const gpu::Device& device, const reference::TracedScene& traced,
                                 PixelRect pixels, std::uint64_t begin, std::uint64_t end) {
  reference::Judge judge(traced);
  std::vector<VerifiedPath> paths;
  for (reference::PathRecord& record : reference::recordPaths(device, traced, pixels, begin, end)) {
    VerifiedPath path{std::move(record), {}, {}};
    path.findings = judge.compare(path.record);
    path.run = judge.run(path.record);
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace

std::shared_ptr<VerifyOptions> addVerifyOptions(CLI::App& compare) {
  auto options = std::make_shared<VerifyOptions>();
  auto* pixels =
      compare.add_option("--verify-pixel", options->pixels,
                         "X,Y or X0,Y0,X1,Y1: trace these pixels of a project in the device's float and "
                         "in double, and name the stage where they part");
  compare.add_option("--sample", options->sample, "Only this sample index; default the first four")
      ->needs(pixels);
  compare.add_option("--size", options->size, "Width and height of the film, e.g. 1280x720")->needs(pixels);
  compare.add_option("--camera", options->camera, "Name of the camera to look through")->needs(pixels);
  compare.add_option("--device", options->device, "Vulkan device by index or part of its name")
      ->needs(pixels);
  return options;
}

int runVerify(const VerifyOptions& options, const std::filesystem::path& project) {
  const plugins::PluginHost host(plugins::defaultSearchPath({}));
  RenderOptions render;
  render.input = project;
  render.size = options.size;
  const Scene scene = prepareScene(host, render).scene;
  const Extent film{scene.render.width, scene.render.height};
  const PixelRect pixels = parsePixels(options.pixels, film);
  const auto device = openDevice({.device = options.device});
  const reference::TracedScene traced =
      reference::tracedScene(packScene(scene, cameraView(scene, options.camera), film), *device);
  const std::uint64_t begin = options.sample.value_or(0);
  const std::uint64_t end = options.sample ? begin + 1 : samplesByDefault;
  const std::vector<VerifiedPath> paths = verify(*device, traced, pixels, begin, end);
  if (paths.size() <= pathsInFull)
    for (const VerifiedPath& path : paths) printPath(path, traced, scene);
  return printVerdict(paths) ? 0 : int(ExitCode::failed);
}

}  // namespace steradian::cli
