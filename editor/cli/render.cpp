// SPDX-License-Identifier: MIT
// steradian render INPUT -o OUT: the options, and the way from a file to a picture.
#include "editor/cli/render.hpp"

#include <CLI/CLI.hpp>

#include <memory>

#include "editor/cli/arguments.hpp"
#include "editor/cli/commands.hpp"
#include "editor/cli/console.hpp"
#include "editor/cli/interruption.hpp"
#include "editor/cli/progress_line.hpp"
#include "editor/cli/render_aov.hpp"
#include "editor/cli/render_report.hpp"
#include "editor/cli/render_scene.hpp"
#include "editor/still_file.hpp"
#include "editor/tonemapping.hpp"
#include "renderer/convergence.hpp"

namespace steradian::cli {

namespace {

StillRequest requestOf(const RenderOptions& options, const Scene& scene) {
  StillRequest request;
  request.spp = options.spp;
  for (const std::string& until : options.until) parseUntil(until, request);
  if (!options.samples.empty())
    std::tie(request.sampleBegin, request.sampleEnd) = parseSampleRange(options.samples);
  request.wholePasses = !options.samples.empty();
  if (request.untilRelRmse && !scene.render.errorMeter)
    throw Error(ExitCode::usage,
                "--until rel=... needs the error meter; leave out --no-meter or turn it on in the project");
  if (request.spp || request.untilRelRmse || request.untilSeconds) return request;
  if (!options.samples.empty())
    request.spp = request.sampleEnd - request.sampleBegin;
  else if (scene.render.errorMeter)
    request.untilRelRmse = 0.01, request.spp = 4096;
  else
    request.spp = 256;
  return request;
}

StillResult trace(Renderer& renderer, const StillRequest& request, const Interruption& interruption) {
  ProgressLine line;
  return renderStill(renderer, request,
                     {[&](const StillProgress& progress) { line.show(progress); },
                      [&] { return interruption.signal() != 0; }});
}

void printResult(const RenderOptions& options, const Scene& scene, const StillResult& result) {
  std::string what = text("%dx%d, %llu samples", scene.render.width, scene.render.height,
                          (unsigned long long)(result.stats.samples));
  if (result.stats.error.valid) what += ", error " + percent(result.stats.error.relRmse);
  for (const auto& path : options.outputs)
    std::printf("%s: %s, %s\n", path.c_str(), what.c_str(), duration(result.seconds).c_str());
}

/// Reading, checking and opening first: every mistake shows before the first sample.
int runRender(const RenderOptions& options) {
  const plugins::PluginHost host(plugins::defaultSearchPath(options.pluginPath));
  for (const auto& path : options.outputs) checkStillPath(host, path);
  const PreparedScene prepared = prepareScene(host, options);
  const Scene& scene = prepared.scene;
  const StillRequest request = requestOf(options, scene);
  const bool part = !options.samples.empty();
  const std::vector<Aov> aovs = parseAovs(options.aov, options.outputs, scene.render.errorMeter, part);
  const CameraView view = cameraView(scene, options.camera);
  RenderReport report;
  report.loadSeconds = secondsSinceStart();

  const Tonemapper tonemapper = tonemapperFor(host, scene.display);
  const auto device = openDevice({.device = options.device});
  const Interruption interruption;
  Renderer renderer(device);
  renderer.allowSpecialization(!options.generic);
  renderer.setTonemapper(tonemapper);
  renderer.setDisplay(scene.display);
  renderer.setScene(scene, view, {scene.render.width, scene.render.height});
  // The two pipelines may round a sample of glass differently, and a file must not show when the compiler was
  // done.
  if (!options.generic) renderer.waitForSpecialization();
  const double traceStart = secondsSinceStart();
  StillResult result = trace(renderer, request, interruption);

  const DeviceDescription description = describe(*device);
  const bool partial = result.end == StillEnd::cancelled;
  const StillOrigin origin{scene.name.empty() ? options.input.filename().string() : scene.name,
                           description.name,
                           scene.render.seed,
                           request.sampleBegin,
                           result.stats,
                           partial};
  StillExtras extras;
  if (part) extras = partExtras(renderer, origin);
  if (!aovs.empty())
    for (plugins::ImageLayer& layer : aovLayers(renderer, aovs, part))
      extras.layers.push_back(std::move(layer));
  result.stats.faults = renderer.stats().faults;
  saveStill(host, renderer, origin, options.outputs, prepared.exporterParameters, extras);
  for (const std::string& doubt : doubtsAbout(result.stats)) warn(doubt);
  if (partial) warn("interrupted; what was finished is saved");
  printResult(options, scene, result);

  report.device = description;
  report.film = {scene.render.width, scene.render.height};
  report.sampleBegin = request.sampleBegin;
  report.firstPixelSeconds = traceStart + result.secondsToFirstPixel;
  report.traceSeconds = result.seconds;
  report.validationMessages = validationMessages(*device);
  report.stats = result.stats;
  report.totalSeconds = secondsSinceStart();
  if (!options.report.empty()) writeReport(report, options.report);
  return partial ? interruption.exitCode() : 0;
}

void addSceneOptions(CLI::App& command, RenderOptions& o) {
  command.add_option("--size", o.size, "Width and height in pixels, e.g. 1280x720");
  command.add_option("--camera", o.camera, "Name of the camera to look through");
  command.add_option("--bounces", o.bounces, "Surface interactions after the first hit, 0 to 64");
  command.add_option("--seed", o.seed, "Seed of the sampler");
  command.add_option("--exposure", o.exposure, "Exposure in stops, for display formats");
  command.add_option("--tonemap", o.tonemapper, "Tonemapper by id or its last word, for display formats");
  command
      .add_option("--param", o.parameters,
                  "Parameter of the tonemapper or the exporter, ID=NUMBER; repeatable")
      ->allow_extra_args(false);
  auto* frame = command.add_option("--frame", o.frame, "Frame of the animation to render");
  command.add_option("--time", o.time, "Time of the animation to render, seconds")->excludes(frame);
}

void addSamplingOptions(CLI::App& command, RenderOptions& o) {
  command.add_option("--spp", o.spp, "Samples per pixel")->check(aboveZero);
  command
      .add_option("--until", o.until,
                  "Stop at rel=1% (relative RMSE) or time=30s; repeatable, the first that is met ends it "
                  "(default rel=1%)")
      ->allow_extra_args(false);
  command.add_option("--samples", o.samples,
                     "Only the sample indices A:B: a part for steradian merge (.exr)");
  command.add_option("--aov", o.aov,
                     "Further layers of the .exr, by commas: albedo, normal, depth, id, coverage, samples, "
                     "variance, or all");
  command.add_flag("--no-meter", o.noMeter, "One joint sample sequence: less noise, no error figure");
  command.add_flag("--generic", o.generic, "Keep the generic pipeline, do not specialize it to the scene");
}

}  // namespace

void addRender(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Render a project, or any scene file, to images");
  command
      ->add_option("input", options->input,
                   "A .srad project, its folder, or a scene file that an importer reads")
      ->required();
  command
      ->add_option("-o,--output", options->outputs, "Image to write, .exr or .png by extension; repeatable")
      ->required()
      ->allow_extra_args(false);
  addSceneOptions(*command, *options);
  addSamplingOptions(*command, *options);
  command->add_option("--device", options->device, "Vulkan device by index or part of its name");
  command->add_option("--plugin-path", options->pluginPath, "Further folder with plugins; repeatable")
      ->allow_extra_args(false);
  command->add_option("--report", options->report, "Write time, rays, error and device as JSON to this file");
  command->callback([options, &chosen] { chosen = [options] { return runRender(*options); }; });
}

}  // namespace steradian::cli
