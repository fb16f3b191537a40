// SPDX-License-Identifier: MIT
// The figures, and how they share the width.
#include "editor/ui/status_figures.hpp"

#include <algorithm>
#include <cmath>

#include "editor/ui/numbers.hpp"
#include "editor/ui/style.hpp"
#include "renderer/convergence.hpp"

namespace steradian::ui {

namespace {

StatusFigure stateFigure(const StatusInput& input) {
  const char* help =
      input.stats.compiling
          ? "The scene needs a pipeline that is being compiled; until then the last picture stays."
          : "P pauses and resumes. View > Rest after sets when the viewport is done.";
  if (input.paused) return {"paused", {"paused"}, help, color::kWarning};
  if (input.resting) return {"done", {"done"}, help, color::kGood};
  const char* state = input.stats.compiling ? "compiling" : "rendering";
  return {state, {state}, help, color::kAccent};
}

void paceFigures(std::vector<StatusFigure>& out, const RenderStats& stats) {
  out.push_back({"samples",
                 {countText(stats.samples) + (stats.samples == 1 ? " sample" : " samples")},
                 "Per pixel, complete over the whole picture.",
                 color::kText});
  const bool known = stats.mraysPerSecond > 0.0;
  out.push_back(
      {"time",
       {!known ? "- ms/sample"
               : formatted(stats.msPerSample < 10 ? "%.2f ms/sample" : "%.0f ms/sample", stats.msPerSample),
        ""},
       "Device time for one sample of every pixel.",
       color::kText,
       3});
  out.push_back({"rays",
                 {!known ? "- Mrays/s" : formatted("%.1f Mrays/s", stats.mraysPerSecond), ""},
                 "Closest-hit and shadow rays.",
                 color::kText,
                 4});
}

StatusFigure errorFigure(const ErrorEstimate& error) {
  std::string help =
      "How wrong the picture still is, measured from two independent halves of the samples: root mean square "
      "in scene-linear radiance, and relative to each pixel.";
  if (!error.valid) return {"error", {"error not known yet"}, help, color::kDim};
  if (error.tails.pixels > 0)
    help += "\nThe worst " + countText(error.tails.pixels) + " pixels carry " + percent(error.tails.share) +
            " of the squared error.";
  const std::string text = "error " + percent(error.relRmse);
  return {"error",
          {text + formatted("  (RMSE %.3g)", error.rmse), text},
          help,
          error.relRmse < 0.01 ? color::kGood : color::kText,
          8};
}

/// Two digits of an estimate are worth showing.
std::uint64_t twoDigits(double samples) {
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(samples)) - 1.0));
  return std::uint64_t(std::round(samples / unit) * unit);
}

/// "1 % in 12 s" while that is where the viewport is going, else how many samples it takes.
std::string outlookText(const StatusInput& input) {
  const ErrorEstimate& error = input.stats.error;
  const Goal& goal = input.goal;
  const std::string target = formatted("%.3g %%", 100.0 * goal.target);
  if (error.relRmse <= goal.target) return target + " reached";
  const double needed = samplesNeeded(goal.measuredAt, error, goal.target);
  if (!(needed < 4e9)) return target + " out of reach";
  const bool rests = goal.sampleLimit > 0 && needed > double(goal.sampleLimit);
  if (input.paused || input.resting || rests || !(goal.secondsPerSample > 0.0))
    return target + " at " + countText(twoDigits(needed)) + " samples";
  return target + " in " +
         duration(std::max(0.0, needed - double(input.stats.samples)) * goal.secondsPerSample);
}

void outlookFigure(std::vector<StatusFigure>& out, const StatusInput& input) {
  const ErrorEstimate& error = input.stats.error;
  if (!error.valid || !(error.relRmse > 0.0) || input.goal.measuredAt == 0) return;
  const std::string text = outlookText(input);
  std::vector<std::string> forms{text};
  if (error.doublings >= 2) forms.insert(forms.begin(), text + formatted(", slope %.2f", error.slope));
  out.push_back({"outlook", forms,
                 "When the error reaches its target, which is that of File > Export still, else 1 %. The "
                 "slope is fitted to the last doublings of the samples: RMSE falls as samples^slope, -0.5 "
                 "for independent samples, faster where the picture is smooth.",
                 color::kText, 6});
}

void doubtFigures(std::vector<StatusFigure>& out, const RenderStats& stats) {
  if (const std::string fireflies = tailWarning(stats.error); !fireflies.empty())
    out.push_back({"fireflies",
                   {"fireflies: " + percent(stats.error.tails.share) + " in " +
                        countText(stats.error.tails.pixels) + " pixels",
                    "fireflies"},
                   fireflies,
                   color::kWarning,
                   5});
  if (stats.clampedShare) {
    const std::string cut = clampWarning(stats);
    out.push_back({"clamp",
                   {"clamp -" + percent(*stats.clampedShare)},
                   cut.empty() ? "Clamping is on and has cut nothing off yet." : cut + ".",
                   cut.empty() ? color::kDim : color::kWarning});
  }
  out.push_back({"nan",
                 {"NaN " + countText(stats.nanSamples)},
                 "Samples that were not numbers: dropped and counted. 0 is a promise.",
                 stats.nanSamples ? color::kError : color::kGood});
  if (stats.faults)
    out.push_back(
        {"faults",
         {"faults " + countText(stats.faults)},
         "Samples that ran out of loop budget or met a feature left out of the pipeline. 0 is a promise.",
         color::kError});
}

void memoryFigure(std::vector<StatusFigure>& out, const RenderStats& stats) {
  const std::size_t bytes = stats.meshBytes + stats.textureBytes + stats.skyBytes;
  if (bytes == 0) return;
  out.push_back({"memory",
                 {"memory " + memoryText(bytes), memoryText(bytes), ""},
                 "What the scene takes on the device: meshes " + memoryText(stats.meshBytes) + ", textures " +
                     memoryText(stats.textureBytes) + ", sky " + memoryText(stats.skyBytes) +
                     ". Objects that share a mesh or a texture share its memory.",
                 color::kText,
                 7});
}

void deviceFigures(std::vector<StatusFigure>& out, const StatusInput& input) {
  const DeviceDescription& device = input.device;
  if (device.type.find("CPU") != std::string::npos)
    out.push_back(
        {"cpu",
         {"CPU device", "CPU"},
         "No GPU with Vulkan was found or chosen: the same shaders run on the processor, slower but right.",
         color::kWarning,
         2});
  out.push_back({"variant",
                 {input.stats.variant.specialized ? "specialized" : "generic", ""},
                 "Which pipeline runs: the generic one that can do everything, or one compiled for what this "
                 "scene needs.",
                 color::kDim,
                 7});
  out.push_back({"device",
                 {device.name, device.name.substr(0, device.name.find(' ')), ""},
                 device.name + "\n" + device.driver + "\nVulkan " + device.api + "\n" + device.queues,
                 color::kDim,
                 9});
}

}  // namespace

std::vector<StatusFigure> statusFigures(const StatusInput& input) {
  std::vector<StatusFigure> out{stateFigure(input)};
  paceFigures(out, input.stats);
  out.push_back(errorFigure(input.stats.error));
  outlookFigure(out, input);
  doubtFigures(out, input.stats);
  memoryFigure(out, input.stats);
  deviceFigures(out, input);
  return out;
}

std::vector<std::string> fittedForms(const std::vector<StatusFigure>& figures, float available, float gap,
                                     const std::function<float(const std::string&)>& widthOf) {
  std::vector<std::size_t> form(figures.size(), 0);
  const auto text = [&](std::size_t i) -> const std::string& { return figures[i].forms[form[i]]; };
  const auto width = [&] {
    float sum = -gap;
    for (std::size_t i = 0; i < figures.size(); ++i)
      if (!text(i).empty()) sum += gap + widthOf(text(i));
    return sum;
  };
  while (width() > available) {
    std::size_t yields = figures.size();
    for (std::size_t i = 0; i < figures.size(); ++i)
      if (form[i] + 1 < figures[i].forms.size() &&
          (yields == figures.size() || figures[i].rank > figures[yields].rank))
        yields = i;
    if (yields == figures.size()) break;
    ++form[yields];
  }
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < figures.size(); ++i) shown.push_back(text(i));
  return shown;
}

}  // namespace steradian::ui
