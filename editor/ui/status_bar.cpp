// SPDX-License-Identifier: MIT
// One line of figures, each with its meaning in the tooltip.
#include "editor/ui/status_bar.hpp"

#include <cmath>
#include <cstdio>

#include "editor/ui/style.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

template <class... Args>
std::string formatted(const char* format, Args... args) {
  char text[128];
  std::snprintf(text, sizeof text, format, args...);
  return text;
}

void figure(Ui& ui, const char* label, const std::string& text, const char* help, ImU32 tint = color::kText) {
  ImGui::SameLine(0, ui.px(18));
  ImGui::PushStyleColor(ImGuiCol_Text, tint);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ui.mark(std::string("status/") + label);
  if (ImGui::IsItemHovered()) tooltip(help);
}

void errorFigure(Ui& ui, const ErrorEstimate& error) {
  const char* help =
      "How wrong the picture still is, measured from two independent halves of the samples: root mean square "
      "in scene-linear radiance, and relative to each pixel.";
  if (!error.valid) return figure(ui, "error", "error not known yet", help, color::kDim);
  figure(ui, "error", formatted("error %s  (RMSE %.3g)", percent(error.relRmse).c_str(), error.rmse), help,
         error.relRmse < 0.01 ? color::kGood : color::kText);
}

void healthFigures(Ui& ui, const RenderStats& stats) {
  figure(ui, "nan", "NaN " + countText(stats.nanSamples),
         "Samples that were not numbers: dropped and counted. 0 is a promise.",
         stats.nanSamples ? color::kError : color::kGood);
  if (stats.faults)
    figure(ui, "faults", "faults " + countText(stats.faults),
           "Samples that ran out of loop budget or met a feature left out of the pipeline. 0 is a promise.",
           color::kError);
}

void memoryFigure(Ui& ui, const RenderStats& stats) {
  const std::size_t bytes = stats.meshBytes + stats.textureBytes + stats.skyBytes;
  if (bytes == 0) return;
  const std::string help = "What the scene takes on the device: meshes " + memoryText(stats.meshBytes) +
                           ", textures " + memoryText(stats.textureBytes) + ", sky " +
                           memoryText(stats.skyBytes) +
                           ". Objects that share a mesh or a texture share its memory.";
  figure(ui, "memory", "memory " + memoryText(bytes), help.c_str());
}

void deviceFigures(Ui& ui, const StatusInput& input) {
  const DeviceDescription& device = input.device;
  const std::string tip =
      device.name + "\n" + device.driver + "\nVulkan " + device.api + "\n" + device.queues;
  const bool cpu = device.type == "CPU" || device.type.find("CPU") != std::string::npos;
  if (cpu)
    figure(ui, "cpu", "CPU device",
           "No GPU with Vulkan was found or chosen: the same shaders run on the processor, slower but right.",
           color::kWarning);
  const std::string variant = input.stats.variant.specialized ? "specialized" : "generic";
  figure(ui, "variant", variant,
         "Which pipeline runs: the generic one that can do everything, or one compiled for what this scene "
         "needs.",
         color::kDim);
  std::string name = device.name;
  if (name.size() > 34) name = name.substr(0, 32) + "...";
  figure(ui, "device", name, tip.c_str(), color::kDim);
}

}  // namespace

std::string percent(double ratio) {
  const double value = 100.0 * ratio;
  return formatted(value < 1.0 ? "%.2f %%" : value < 10.0 ? "%.1f %%" : "%.0f %%", value);
}

std::string duration(double seconds) {
  if (!(seconds >= 0.0) || seconds > 1e7) return "unknown";
  const long whole = std::lround(seconds);
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

std::string memoryText(std::size_t bytes) {
  if (bytes < std::size_t(1) << 20) return formatted("%.1f KiB", double(bytes) / 1024);
  return formatted(bytes < std::size_t(1) << 30 ? "%.1f MiB" : "%.0f MiB", double(bytes) / (1 << 20));
}

std::string countText(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (int at = int(digits.size()) - 3; at > 0; at -= 3) digits.insert(std::size_t(at), 1, ',');
  return digits;
}

void statusBar(Ui& ui, const StatusInput& input) {
  const RenderStats& stats = input.stats;
  const char* state = input.paused      ? "paused"
                      : input.resting   ? "done"
                      : stats.compiling ? "compiling"
                                        : "rendering";
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(ImColor(input.paused    ? color::kWarning
                             : input.resting ? color::kGood
                                             : color::kAccent),
                     "%s", state);
  ui.mark(std::string("status/") + state);
  if (ImGui::IsItemHovered())
    tooltip(stats.compiling
                ? "The scene needs a pipeline that is being compiled; until then the last picture stays."
                : "P pauses and resumes. View > Rest after sets when the viewport is done.");
  figure(ui, "samples", countText(stats.samples) + (stats.samples == 1 ? " sample" : " samples"),
         "Per pixel, complete over the whole picture.");
  const bool known = stats.mraysPerSecond > 0.0;
  figure(ui, "time",
         !known ? "- ms/sample"
                : formatted(stats.msPerSample < 10 ? "%.2f ms/sample" : "%.0f ms/sample", stats.msPerSample),
         "Device time for one sample of every pixel.");
  figure(ui, "rays", !known ? "- Mrays/s" : formatted("%.1f Mrays/s", stats.mraysPerSecond),
         "Closest-hit and shadow rays.");
  errorFigure(ui, stats.error);
  healthFigures(ui, stats);
  memoryFigure(ui, stats);
  deviceFigures(ui, input);
}

}  // namespace steradian::ui
