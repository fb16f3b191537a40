// SPDX-License-Identifier: MIT
// Labelled fields with unit and tooltip: the only way in which panels edit numbers, colours and choices.
#pragma once
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "editor/ui/ui.hpp"

namespace steradian::ui {

/// A number as a person meets it. A slider when both ends are near (`slider`), else a drag field.
struct NumberField {
  const char* name;
  const char* help;       // physical meaning, one sentence
  const char* unit = "";  // " m", " nit"
  double minimum = 0.0;
  double maximum = 1.0;
  double speed = 0.01;  // change per pixel dragged
  int decimals = 3;
  bool slider = false;
  bool logarithmic = false;
  std::optional<double> standard = {};  // what "Reset" gives
};

inline constexpr double kFar = 1e9;  // metres; what a field for coordinates or lengths accepts

/// A size in metres, > 0.
NumberField lengthField(const char* name, const char* help, double standard);

/// One group of fields in two columns; remembers which field changed for the name of the undo step.
class Fields {
 public:
  /// Labels for tests are `scope`/field name.
  Fields(Ui& ui, std::string scope) : ui_(ui), scope_(std::move(scope)) {}

  bool number(const NumberField& field, double& value);
  bool number(const NumberField& field, float& value);
  bool integer(const NumberField& field, int& value);
  /// Components side by side; the unit stands in the name. Labels for tests end in the axis.
  bool vector(const NumberField& field, std::span<double> value, const char* axes = "XYZ");
  bool vector(const NumberField& field, glm::dvec3& value) { return vector(field, {&value.x, 3}); }
  bool vector(const NumberField& field, glm::dvec2& value) { return vector(field, {&value.x, 2}, "XZ"); }
  bool toggle(const char* name, const char* help, bool& value);
  /// Index into `choices`; `helps` may be empty.
  bool choice(const char* name, const char* help, std::initializer_list<const char*> choices, int& index);
  bool text(const char* name, const char* help, std::string& value);
  /// Stored linear Rec. 709, shown as sRGB; `unbounded` allows components above 1.
  bool linearColor(const char* name, const char* help, glm::vec3& linear, bool unbounded = false);
  /// A colour that only informs, linear Rec. 709 of any brightness.
  void swatch(const char* name, const char* help, const glm::vec3& linear);
  /// A line that only informs.
  void note(const char* name, const std::string& text, const char* help = nullptr);

  /// Starts a row by hand: draw the value with ImGui after it, then call end().
  void begin(const char* name, const char* help);
  void end(bool changed);

  bool changed() const { return !lastChanged_.empty(); }
  /// "Change roughness": for the undo step.
  std::string changeName() const;

 private:
  bool component(const NumberField& field, double& value, char axis, float width);
  bool offerReset(const NumberField& field, double& value);
  std::string scopedLabel() const { return scope_ + "/" + current_; }

  Ui& ui_;
  std::string scope_;
  std::string current_, lastChanged_;
};

/// A titled, collapsible part of a panel; true when open.
bool section(Ui& ui, const char* title, bool openAtFirst = true);
bool button(Ui& ui, const char* text, std::string_view label, const char* help = nullptr, float width = 0.0f);
/// A button that stands out: the action that the dialog is for.
bool mainButton(Ui& ui, const char* text, std::string_view label, float width = 0.0f);
/// At once and unconditionally: ask first whether the item is hovered.
void tooltip(const char* text);

/// Begins a small window with its lower right corner near `bottomRight`, for work in the background; End()
/// follows.
void beginCornerWindow(Ui& ui, const char* name, ImVec2 bottomRight);
void dimText(const std::string& text);

float srgbFromLinear(float linear);  // IEC 61966-2-1; continued above 1
float linearFromSrgb(float encoded);

}  // namespace steradian::ui
