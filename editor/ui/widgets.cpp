// SPDX-License-Identifier: MIT
// Rows of a property list: name on the left, value on the right, meaning in the tooltip.
#include "editor/ui/widgets.hpp"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <cmath>
#include <cstdio>

#include "editor/ui/style.hpp"

namespace steradian::ui {

namespace {

constexpr float kNameShare = 0.385f;  // of the row's width
constexpr float kMostNameShare = 0.6f;
constexpr float kTooltipDelay = 0.45f;

std::string formatOf(const NumberField& field) {
  std::string unit;
  for (const char* c = field.unit; *c; ++c) unit += *c == '%' ? std::string("%%") : std::string(1, *c);
  return "%." + std::to_string(field.decimals) + "f" + unit;
}

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string helpOf(const NumberField& field) {
  std::string help = std::string(field.help) + "\nRange " + shortNumber(field.minimum) + " to " +
                     (field.maximum >= 1e9 ? "any size" : shortNumber(field.maximum)) + field.unit;
  if (field.standard) help += ", default " + shortNumber(*field.standard) + field.unit;
  return help + ".\nDrag, or double-click to type.";
}

ImGuiSliderFlags flagsOf(const NumberField& field) {
  return ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat |
         (field.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
}

/// What rounds to zero is shown without a sign: the format then holds the figure itself.
std::string unsignedZero(const NumberField& field, double value, const std::string& format) {
  const bool negativeZero =
      value <= 0.0 && std::signbit(value) && value > -0.5 * std::pow(10.0, -field.decimals);
  if (!negativeZero) return format;
  const std::string figure = "%." + std::to_string(field.decimals) + "f";
  char zero[32];
  std::snprintf(zero, sizeof zero, figure.c_str(), 0.0);
  return zero + format.substr(figure.size());
}

bool drawNumber(const NumberField& field, const char* id, double& value, const std::string& plainFormat) {
  const std::string format = unsignedZero(field, value, plainFormat);
  const ImGuiDataType type = ImGuiDataType_Double;
  if (field.slider)
    return ImGui::SliderScalar(id, type, &value, &field.minimum, &field.maximum, format.c_str(),
                               flagsOf(field));
  // A drag that moves by a share of the value feels the same for a lamp of 1 cd and of 100,000 cd.
  const double speed = field.logarithmic ? std::max(std::abs(value) * 0.01, 1e-4) : field.speed;
  const ImGuiSliderFlags flags = flagsOf(field) & ~ImGuiSliderFlags_Logarithmic;
  return ImGui::DragScalar(id, type, &value, float(speed), &field.minimum, &field.maximum, format.c_str(),
                           flags);
}

ImU32 axisColor(char axis) {
  if (axis == 'X') return IM_COL32(198, 86, 82, 255);
  return axis == 'Y' ? IM_COL32(116, 168, 92, 255) : IM_COL32(88, 134, 204, 255);
}

void delayedTooltip(const char* text) {
  if (!ImGui::IsItemHovered() || ImGui::IsAnyItemActive()) return;
  if (ImGui::GetCurrentContext()->HoveredIdTimer > kTooltipDelay) tooltip(text);
}

}  // namespace

NumberField lengthField(const char* name, const char* help, double standard) {
  return {.name = name,
          .help = help,
          .unit = " m",
          .minimum = 1e-6,
          .maximum = kFar,
          .decimals = 4,
          .logarithmic = true,
          .standard = standard};
}

void beginCornerWindow(Ui& ui, const char* name, ImVec2 bottomRight) {
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                      ImGuiWindowFlags_NoNav;
  const float margin = ui.px(14);
  ImGui::SetNextWindowPos({bottomRight.x - margin, bottomRight.y - margin}, ImGuiCond_Always, {1, 1});
  ImGui::SetNextWindowSize({ui.px(330), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::Begin(name, nullptr, kFlags);
  ImGui::PopStyleVar();
}

void tooltip(const char* text) {
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void dimText(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

void Fields::begin(const char* name, const char* help) {
  current_ = name;
  const float width = ImGui::GetContentRegionAvail().x;
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(172, 176, 183, 255));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  // A long name moves its value aside rather than being cut.
  const float gap = ui_.px(6), wanted = ImGui::CalcTextSize(name).x + gap;
  const float valueAt = std::max(width * kNameShare, std::min(wanted, width * kMostNameShare));
  ImGui::PushClipRect(at, {at.x + valueAt - gap, at.y + ImGui::GetFrameHeight()}, true);
  ImGui::TextUnformatted(name);
  ImGui::PopClipRect();
  ImGui::PopStyleColor();
  if (help && ImGui::IsItemHovered()) tooltip(help);
  ImGui::SameLine(left + valueAt);
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::PushID(name);
}

void Fields::end(bool changed) {
  ui_.mark(scopedLabel());
  ImGui::PopID();
  if (changed) lastChanged_ = current_;
}

std::string Fields::changeName() const {
  std::string name = lastChanged_;
  if (!name.empty()) name[0] = char(std::tolower(static_cast<unsigned char>(name[0])));
  return "Change " + name;
}

bool Fields::offerReset(const NumberField& field, double& value) {
  if (!field.standard || !ImGui::BeginPopupContextItem("reset")) return false;
  const std::string text = "Reset to " + shortNumber(*field.standard) + field.unit;
  const bool reset = ImGui::MenuItem(text.c_str());
  if (reset) value = *field.standard;
  ImGui::EndPopup();
  return reset;
}

bool Fields::number(const NumberField& field, double& value) {
  begin(field.name, field.help);
  bool changed = drawNumber(field, "##value", value, formatOf(field));
  ui_.mark(scopedLabel());
  delayedTooltip(helpOf(field).c_str());
  changed |= offerReset(field, value);
  ImGui::PopID();
  if (changed) lastChanged_ = field.name;
  return changed;
}

bool Fields::number(const NumberField& field, float& value) {
  double wide = value;
  const bool changed = number(field, wide);
  if (changed) value = float(wide);
  return changed;
}

bool Fields::integer(const NumberField& field, int& value) {
  double wide = value;
  const bool changed = number(field, wide);
  const int rounded = int(std::lround(wide));
  const bool differs = changed && rounded != value;
  if (differs) value = rounded;
  return differs;
}

bool Fields::component(const NumberField& field, double& value, char axis, float width) {
  ImGui::PushID(axis);
  ImGui::SetNextItemWidth(width);
  bool changed = drawNumber(field, "##value", value, "%." + std::to_string(field.decimals) + "f");
  ui_.mark(scopedLabel() + " " + axis);
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRectFilled({min.x, min.y}, {min.x + ui_.px(3), max.y}, axisColor(axis),
                                            ui_.px(3), ImDrawFlags_RoundCornersLeft);
  delayedTooltip((std::string(1, axis) + ". " + helpOf(field)).c_str());
  changed |= offerReset(field, value);
  ImGui::PopID();
  return changed;
}

bool Fields::vector(const NumberField& field, std::span<double> value, const char* axes) {
  begin(field.name, field.help);
  const float gap = ui_.px(3);
  const float width =
      (ImGui::GetContentRegionAvail().x - gap * float(value.size() - 1)) / float(value.size());
  bool changed = false;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    changed |= component(field, value[i], axes[i], width);
  }
  ImGui::PopID();
  if (changed) lastChanged_ = field.name;
  return changed;
}

bool Fields::toggle(const char* name, const char* help, bool& value) {
  begin(name, help);
  const bool changed = ImGui::Checkbox("##value", &value);
  delayedTooltip(help);
  end(changed);
  return changed;
}

bool Fields::choice(const char* name, const char* help, std::initializer_list<const char*> choices,
                    int& index) {
  begin(name, help);
  const bool open = ImGui::BeginCombo("##value", choices.begin()[index]);
  ui_.mark(scopedLabel());
  if (!open) delayedTooltip(help);
  bool changed = false;
  if (open) {
    for (int i = 0; i < int(choices.size()); ++i) {
      if (ImGui::Selectable(choices.begin()[i], i == index) && i != index) {
        index = i;
        changed = true;
      }
      ui_.mark(scopedLabel() + "/" + choices.begin()[i]);
    }
    ImGui::EndCombo();
  }
  ImGui::PopID();
  if (changed) lastChanged_ = name;
  return changed;
}

bool Fields::text(const char* name, const char* help, std::string& value) {
  begin(name, help);
  const bool changed = ImGui::InputText("##value", &value, ImGuiInputTextFlags_AutoSelectAll);
  delayedTooltip(help);
  end(changed);
  return changed;
}

bool Fields::linearColor(const char* name, const char* help, glm::vec3& linear, bool unbounded) {
  begin(name, help);
  float encoded[3];
  for (int i = 0; i < 3; ++i) encoded[i] = srgbFromLinear(linear[i]);
  const ImGuiColorEditFlags flags = ImGuiColorEditFlags_Float | ImGuiColorEditFlags_PickerHueWheel |
                                    (unbounded ? ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_DisplayRGB
                                               : ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_Uint8);
  const bool changed =
      ImGui::ColorEdit3("##value", encoded, flags & ~(unbounded ? 0 : ImGuiColorEditFlags_Float));
  end(changed);
  if (changed)
    for (int i = 0; i < 3; ++i) linear[i] = std::max(0.0f, linearFromSrgb(encoded[i]));
  return changed;
}

void Fields::swatch(const char* name, const char* help, const glm::vec3& linear) {
  begin(name, help);
  const glm::vec3 shown = linear / std::max({linear.x, linear.y, linear.z, 1e-6f});
  const ImVec4 encoded{srgbFromLinear(shown.x), srgbFromLinear(shown.y), srgbFromLinear(shown.z), 1.0f};
  const ImVec2 size{ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight()};
  ImGui::ColorButton("##value", encoded, ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                     size);
  delayedTooltip(help);
  end(false);
}

void Fields::note(const char* name, const std::string& text, const char* help) {
  begin(name, help);
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  if (help && ImGui::IsItemHovered()) tooltip(help);
  end(false);
}

bool section(Ui& ui, const char* title, bool openAtFirst) {
  ImGui::Dummy({0, ui.px(1)});
  const bool open =
      ImGui::CollapsingHeader(title, openAtFirst ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
  ui.mark(std::string("section/") + title);
  return open;
}

bool button(Ui& ui, const char* text, std::string_view label, const char* help, float width) {
  const bool pressed = ImGui::Button(text, {width, 0});
  ui.mark(label);
  if (help) delayedTooltip(help);
  return pressed;
}

bool mainButton(Ui& ui, const char* text, std::string_view label, float width) {
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(196, 130, 56, 255));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, IM_COL32(214, 146, 66, 255));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, IM_COL32(232, 160, 76, 255));
  ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(24, 20, 14, 255));
  const bool pressed = button(ui, text, label, nullptr, width);
  ImGui::PopStyleColor(4);
  return pressed;
}

float srgbFromLinear(float linear) {
  if (linear <= 0.0031308f) return 12.92f * linear;
  return 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float linearFromSrgb(float encoded) {
  if (encoded <= 0.04045f) return encoded / 12.92f;
  return std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace steradian::ui
