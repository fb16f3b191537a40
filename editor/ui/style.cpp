// SPDX-License-Identifier: MIT
// Theme, spacing and fonts.
#include "editor/ui/style.hpp"

#include <imgui_freetype.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

namespace steradian::ui {

namespace {

constexpr float kFontSize = 14.5f;  // design pixels

ImVec4 gray(float value, float alpha = 1.0f) {
  return {value, value + 0.006f, value + 0.016f, alpha};
}
ImVec4 accent(float alpha) {
  return {0.91f, 0.63f, 0.30f, alpha};
}

void setSurfaces(ImVec4* colors) {
  colors[ImGuiCol_Text] = {0.86f, 0.866f, 0.88f, 1.0f};
  colors[ImGuiCol_TextDisabled] = {0.53f, 0.55f, 0.58f, 1.0f};
  colors[ImGuiCol_WindowBg] = gray(0.135f);
  colors[ImGuiCol_ChildBg] = gray(0.0f, 0.0f);
  colors[ImGuiCol_PopupBg] = gray(0.155f, 0.99f);
  colors[ImGuiCol_MenuBarBg] = gray(0.105f);
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = gray(0.105f);
  colors[ImGuiCol_Border] = gray(0.06f);
  colors[ImGuiCol_Separator] = gray(0.23f);
  colors[ImGuiCol_ModalWindowDimBg] = {0.0f, 0.0f, 0.0f, 0.45f};
  colors[ImGuiCol_NavHighlight] = accent(0.8f);
}

void setControls(ImVec4* colors) {
  colors[ImGuiCol_FrameBg] = gray(0.205f);
  colors[ImGuiCol_FrameBgHovered] = gray(0.25f);
  colors[ImGuiCol_FrameBgActive] = gray(0.29f);
  colors[ImGuiCol_Button] = gray(0.245f);
  colors[ImGuiCol_ButtonHovered] = gray(0.31f);
  colors[ImGuiCol_ButtonActive] = gray(0.36f);
  colors[ImGuiCol_Header] = gray(0.21f);
  colors[ImGuiCol_HeaderHovered] = gray(0.27f);
  colors[ImGuiCol_HeaderActive] = gray(0.32f);
  colors[ImGuiCol_Tab] = gray(0.165f);
  colors[ImGuiCol_TabHovered] = gray(0.30f);
  colors[ImGuiCol_TabActive] = colors[ImGuiCol_TabUnfocusedActive] = gray(0.27f);
  colors[ImGuiCol_TabUnfocused] = gray(0.165f);
  colors[ImGuiCol_CheckMark] = accent(1.0f);
  colors[ImGuiCol_SliderGrab] = accent(0.75f);
  colors[ImGuiCol_SliderGrabActive] = accent(1.0f);
  colors[ImGuiCol_PlotHistogram] = accent(0.85f);
  colors[ImGuiCol_TextSelectedBg] = accent(0.35f);
  colors[ImGuiCol_DragDropTarget] = accent(0.9f);
  colors[ImGuiCol_ScrollbarBg] = gray(0.0f, 0.0f);
  colors[ImGuiCol_ScrollbarGrab] = gray(0.30f);
  colors[ImGuiCol_ScrollbarGrabHovered] = gray(0.36f);
  colors[ImGuiCol_ScrollbarGrabActive] = gray(0.42f);
}

/// Font files in order of preference; Debian's packages of each are optional.
constexpr std::array kFonts = {
    "/usr/share/fonts/opentype/inter/Inter-Regular.otf",
    "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
};

/// Latin, Greek, Cyrillic, punctuation and the few symbols that labels use; names in scenes may be any.
constexpr ImWchar kRanges[] = {0x0020, 0x024F, 0x0370, 0x052F, 0x2010, 0x2044, 0x2070, 0x209F, 0x20A0,
                               0x20BF, 0x2190, 0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

}  // namespace

void applyStyle(UiScale scale) {
  ImGuiStyle style;
  style.WindowPadding = {10, 8};
  style.FramePadding = {7, 4};
  style.ItemSpacing = {7, 5};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {4, 2.5f};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 9;
  style.WindowRounding = 0;
  style.PopupRounding = 5;
  style.FrameRounding = style.GrabRounding = 4;
  style.ScrollbarRounding = 6;
  style.TabRounding = 4;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.WindowTitleAlign = {0.02f, 0.5f};
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.ScaleAllSizes(scale.units);
  setSurfaces(style.Colors);
  setControls(style.Colors);
  ImGui::GetStyle() = style;
  ImGuiIO& io = ImGui::GetIO();
  io.MouseDragThreshold = io.MouseDoubleClickMaxDist = 6 * scale.units;
}

void loadFonts(UiScale scale) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  io.Fonts->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  io.FontGlobalScale = 1.0f / scale.pixelsPerUnit;
  const float size = std::round(kFontSize * scale.units * scale.pixelsPerUnit);
  for (const char* file : kFonts) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) continue;
    if (io.Fonts->AddFontFromFileTTF(file, size, nullptr, kRanges)) return;
  }
  ImFontConfig config;
  config.SizePixels = size;
  io.Fonts->AddFontDefault(&config);
}

}  // namespace steradian::ui
