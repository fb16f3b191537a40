// SPDX-License-Identifier: MIT
// Every field of a light, in photometric units with the conversion beside it.
#include <cmath>
#include <cstdio>

#include "editor/ui/inspector.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

constexpr double kPi = 3.14159265358979323846;

std::string withUnit(double value, const char* unit) {
  char text[48];
  std::snprintf(text, sizeof text, "%.4g %s", value, unit);
  return text;
}

/// Luminous flux of a spot whose intensity falls from the inner to the outer cone as
/// KHR_lights_punctual recommends: clamp((cos t - cos outer) / (cos inner - cos outer), 0, 1)^2.
double spotFlux(const SpotLight& spot, double candela) {
  const double inner = std::cos(spot.innerConeAngle), outer = std::cos(spot.outerConeAngle);
  return 2.0 * kPi * candela * ((1.0 - inner) + (inner - outer) / 3.0);
}

Light ofKind(Light light, int kind) {
  if (kind == 0) light.kind = PointLight{};
  if (kind == 1) light.kind = SpotLight{};
  if (kind == 2) light.kind = DirectionalLight{};
  return light;
}

void intensityFields(Fields& fields, Light& light) {
  const bool directional = std::holds_alternative<DirectionalLight>(light.kind);
  NumberField field{.name = "Intensity",
                    .help = "Luminous intensity: a candle has 1, a 60 W bulb about 65.",
                    .unit = " cd",
                    .minimum = 0.0,
                    .maximum = 1e10,
                    .decimals = 2,
                    .logarithmic = true,
                    .standard = 10.0};
  if (directional) {
    field.name = "Illuminance";
    field.help = "On a surface that faces the light: full sun 100,000, overcast 10,000, an office 500.";
    field.unit = " lx";
  }
  fields.number(field, light.intensity);
  const char* help = "Luminous flux: all the light that the source sends out.";
  if (std::holds_alternative<PointLight>(light.kind))
    fields.note("Flux", withUnit(4.0 * kPi * light.intensity, "lm"), help);
  if (const auto* spot = std::get_if<SpotLight>(&light.kind))
    fields.note("Flux", withUnit(spotFlux(*spot, light.intensity), "lm"), help);
}

void coneFields(Fields& fields, SpotLight& spot) {
  double inner = glm::degrees(double(spot.innerConeAngle)), outer = glm::degrees(double(spot.outerConeAngle));
  NumberField field{.name = "Inner cone",
                    .help = "Half angle of full intensity.",
                    .unit = "\u00b0",
                    .minimum = 0.0,
                    .maximum = 89.9,
                    .decimals = 1,
                    .slider = true,
                    .standard = 0.0};
  const bool innerChanged = fields.number(field, inner);
  field = {.name = "Outer cone",
           .help = "Half angle at which the light ends.",
           .unit = "\u00b0",
           .minimum = 0.1,
           .maximum = 90.0,
           .decimals = 1,
           .slider = true,
           .standard = 45.0};
  const bool outerChanged = fields.number(field, outer);
  if (innerChanged) outer = std::max(outer, inner + 0.1);
  if (outerChanged) inner = std::min(inner, outer - 0.1);
  if (!innerChanged && !outerChanged) return;
  spot.innerConeAngle = float(glm::radians(std::max(inner, 0.0)));
  spot.outerConeAngle = std::min(float(glm::radians(outer)), 1.5707963f);
}

}  // namespace

std::optional<Edit> inspectLight(Ui& ui, const Scene& scene, const Object& object) {
  if (!section(ui, "Light")) return std::nullopt;
  Fields fields(ui, "light");
  Light next = std::get<Light>(object.content);
  int kind = int(next.kind.index());
  if (fields.choice("Kind", "Point: all around. Spot: a cone. Directional: parallel, from far away.",
                    {"Point", "Spot", "Directional"}, kind))
    next = ofKind(next, kind);
  fields.linearColor("Colour", "Multiplies the intensity. Linear Rec. 709, may exceed 1.", next.color, true);
  intensityFields(fields, next);
  if (auto* spot = std::get_if<SpotLight>(&next.kind)) coneFields(fields, *spot);
  if (!fields.changed()) return std::nullopt;
  return Edit{edits::setContent(scene, object.id, next), fields.changeName() + " of " + object.name};
}

}  // namespace steradian::ui
