// SPDX-License-Identifier: MIT
#include "editor/ui/furnace_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <imgui.h>

#include "renderer/furnace_curve.hpp"

namespace steradian::ui {

namespace {

constexpr int points = 17;
constexpr std::array<ImU32, 3> lineColors = {IM_COL32(232, 96, 84, 255), IM_COL32(104, 190, 104, 255),
                                             IM_COL32(96, 148, 236, 255)};

struct Plot {
  ImVec2 origin, size;  // lower left corner; pixels
  ImVec2 at(double roughness, double albedo) const {
    return {origin.x + float(roughness) * size.x, origin.y - float(albedo) * size.y};
  }
};

bool isGrey(const std::vector<glm::vec3>& curve) {
  return std::ranges::all_of(
      curve, [](const glm::vec3& a) { return std::abs(a.x - a.y) < 0.005f && std::abs(a.x - a.z) < 0.005f; });
}

void drawCurve(ImDrawList& draw, const Plot& plot, const std::vector<glm::vec3>& curve, int channel,
               ImU32 color, float width) {
  std::vector<ImVec2> line;
  for (std::size_t i = 0; i < curve.size(); ++i)
    line.push_back(plot.at(double(i) / double(curve.size() - 1), double(curve[i][channel])));
  draw.AddPolyline(line.data(), int(line.size()), color, 0, width);
}

}  // namespace

void furnaceView(Ui& ui, const Material& material, bool compensated) {
  const std::vector<glm::vec3> curve = furnaceCurve(material, points, compensated);
  const ImVec2 size(ImGui::GetContentRegionAvail().x, ui.px(72));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float margin = ui.px(4);
  const Plot plot{{corner.x + margin, corner.y + size.y - margin},
                  {size.x - 2 * margin, size.y - 2 * margin}};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                     ImGui::GetStyle().FrameRounding);
  const ImU32 grid = ImGui::GetColorU32(ImGuiCol_Border);
  for (const double albedo : {0.0, 0.5, 1.0})
    draw.AddLine(plot.at(0, albedo), plot.at(1, albedo), grid, ui.px(1));
  draw.AddLine(plot.at(material.roughness, 0), plot.at(material.roughness, 1),
               ImGui::GetColorU32(ImGuiCol_TextDisabled), ui.px(1));
  if (isGrey(curve))
    drawCurve(draw, plot, curve, 0, ImGui::GetColorU32(ImGuiCol_Text), ui.px(2));
  else
    for (int channel = 0; channel < 3; ++channel)
      drawCurve(draw, plot, curve, channel, lineColors[std::size_t(channel)], ui.px(2));
  ImGui::Dummy(size);
  ui.mark("material/Furnace");
  if (!ImGui::IsItemHovered()) return;
  tooltip(
      "White furnace: the share of even light that this surface gives back (0 to 1), against roughness "
      "(0 to 1). The upright line is its own roughness. Without energy compensation rough metal darkens.");
}

}  // namespace steradian::ui
