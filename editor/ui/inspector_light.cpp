// SPDX-License-Identifier: MIT
// Every field of a light, in photometric units with the conversion beside it.
#include <cmath>
#include <cstdio>

#include "editor/photometry.hpp"
#include "editor/ui/inspector.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

std::string withUnit(double value, const char* unit) {
  char text[48];
  std::snprintf(text, sizeof text, "%.4g %s", value, unit);
  return text;
}

/// The same lamp as another kind; where the unit of its strength changes, a usual strength in the new one.
Light ofKind(Light light, int kind) {
  const decltype(Light::kind) kinds[] = {PointLight{}, SpotLight{}, DirectionalLight{}, SphereLight{},
                                         RectLight{},  DiskLight{}, EnvironmentLight{}};
  constexpr float kUsual[] = {100.0f, 100.0f, 1000.0f, 500.0f, 500.0f, 500.0f, 20.0f};
  if (kUsual[kind] != kUsual[light.kind.index()]) light.intensity = kUsual[kind];
  light.kind = kinds[kind];
  return light;
}

/// Name, meaning and unit of the strength of each kind.
struct Strength {
  const char *name, *help, *unit;
};
struct StrengthOf {
  Strength operator()(const DirectionalLight&) const {
    return {"Illuminance",
            "On a surface that faces the light: full sun 100,000, overcast 10,000, an office 500.", " lx"};
  }
  Strength operator()(const PointLight&) const { return candela(); }
  Strength operator()(const SpotLight&) const { return candela(); }
  Strength operator()(const EnvironmentLight&) const {
    return {"Luminance",
            "Of the zenith, times the image: a clear sky has about 3,000, an overcast one 5,000.", " nit"};
  }
  template <class Area>
  Strength operator()(const Area&) const {
    return {
        "Luminance",
        "How bright the lamp's surface looks: a candle flame 10,000, a frosted bulb 50,000. A larger lamp of "
        "the same luminance gives more light.",
        " nit"};
  }

 private:
  static Strength candela() {
    return {"Intensity", "Luminous intensity: a candle has 1, a 60 W bulb about 65.", " cd"};
  }
};

void intensityFields(Fields& fields, Light& light, const glm::dmat4& world) {
  const Strength strength = std::visit(StrengthOf{}, light.kind);
  fields.number({.name = strength.name,
                 .help = strength.help,
                 .unit = strength.unit,
                 .minimum = 0.0,
                 .maximum = 1e10,
                 .decimals = 2,
                 .logarithmic = true,
                 .standard = 10.0},
                light.intensity);
  const bool candela = std::string_view(strength.unit) == " cd";
  if (const auto ahead = intensityAhead(light, world); ahead && !candela)
    fields.note("Intensity", withUnit(*ahead, "cd"), "Luminous intensity straight ahead, at this size.");
  if (const auto flux = luminousFlux(light, world))
    fields.note("Flux", withUnit(*flux, "lm"),
                "Luminous flux: all the light that the source sends out, as lamps are sold.");
}

void colorFields(Fields& fields, Light& light) {
  const bool sky = std::holds_alternative<EnvironmentLight>(light.kind);
  fields.linearColor(sky ? "Zenith" : "Colour", "Multiplies the strength. Linear Rec. 709, may exceed 1.",
                     light.color, true);
  bool glows = light.temperature > 0.0f;
  if (fields.toggle("Black body", "Colour by temperature, at an unchanged strength.", glows))
    light.temperature = glows ? 4000.0f : 0.0f;
  if (!glows) return;
  fields.number(
      {.name = "Temperature",
       .help = "Colour of a black body: candle 1,900, tungsten lamp 2,700, noon sun 5,500, clear north "
               "sky 10,000 and more.",
       .unit = " K",
       .minimum = 1000.0,
       .maximum = 40000.0,
       .decimals = 0,
       .slider = true,
       .logarithmic = true,
       .standard = 6500.0},
      light.temperature);
  fields.swatch("Seen as", "Colour and temperature together, at full brightness.", lightColor(light));
}

NumberField angle(const char* name, const char* help, double least, double most, double standard) {
  return {.name = name,
          .help = help,
          .unit = "\u00b0",
          .minimum = least,
          .maximum = most,
          .decimals = 2,
          .slider = true,
          .standard = standard};
}

void coneFields(Fields& fields, SpotLight& spot) {
  double inner = glm::degrees(double(spot.innerConeAngle)), outer = glm::degrees(double(spot.outerConeAngle));
  const bool innerChanged =
      fields.number(angle("Inner cone", "Half angle of full intensity.", 0.0, 89.9, 0.0), inner);
  const bool outerChanged =
      fields.number(angle("Outer cone", "Half angle at which the light ends.", 0.1, 90.0, 45.0), outer);
  if (innerChanged) outer = std::max(outer, inner + 0.1);
  if (outerChanged) inner = std::min(inner, outer - 0.1);
  if (!innerChanged && !outerChanged) return;
  spot.innerConeAngle = float(glm::radians(std::max(inner, 0.0)));
  spot.outerConeAngle = std::min(float(glm::radians(outer)), 1.5707963f);
}

/// Draws what only one kind of light has.
struct KindFields {
  Fields& fields;
  void operator()(PointLight&) {}
  void operator()(SpotLight& spot) { coneFields(fields, spot); }
  void operator()(DirectionalLight& sun) {
    double degrees = glm::degrees(double(sun.angularDiameter));
    if (fields.number(angle("Diameter",
                            "Angle that the light's disk covers; the sun's is 0.53\u00b0. 0 = hard shadows.",
                            0.0, 90.0, 0.53),
                      degrees))
      sun.angularDiameter = std::min(float(glm::radians(degrees)), 1.5707963f);
  }
  void operator()(SphereLight& l) {
    fields.number(lengthField("Radius", "Radius of the lamp.", 0.25), l.radius);
  }
  void operator()(RectLight& l) {
    fields.vector(lengthField("Size", "Full edge lengths; the lamp shines along its -Z.", 1.0),
                  {&l.size.x, 2}, "XY");
  }
  void operator()(DiskLight& l) {
    fields.number(lengthField("Radius", "Radius of the lamp; it shines along its -Z.", 0.5), l.radius);
  }
  void operator()(EnvironmentLight& sky) {
    const char* help = "Factor of the zenith's colour in a vertical gradient. 1 = the same all around.";
    fields.linearColor("Horizon", help, sky.horizon, true);
    fields.linearColor("Ground", help, sky.ground, true);
  }
};

/// The image of a sky: which, and buttons to choose another or none.
std::optional<Edit> skyImage(Ui& ui, Fields& fields, const Scene& scene, const Object& object, Light light) {
  auto* sky = std::get_if<EnvironmentLight>(&light.kind);
  if (!sky) return std::nullopt;
  std::string text = sky->file.empty() ? "none" : sky->file;
  if (!sky->file.empty() && !sky->image) text += " (missing)";
  fields.note("Image", text,
              "Equirectangular EXR or HDR; multiplies the gradient. Turn the object to turn the sky.");
  if (sky->image)
    fields.note("Pixels", std::to_string(sky->image->width) + " x " + std::to_string(sky->image->height));
  const float half = (ImGui::GetContentRegionAvail().x - ui.px(7)) * 0.5f;
  if (button(ui, "Choose image...", "light/Choose image", "An equirectangular EXR or HDR file", half))
    ui.ask(ChooseSky{object.id});
  if (sky->file.empty()) return std::nullopt;
  ImGui::SameLine();
  if (!button(ui, "Remove image", "light/Remove image", "The gradient alone", half)) return std::nullopt;
  sky->file.clear();
  sky->image = nullptr;
  return Edit{edits::setContent(scene, object.id, light), "Remove image of " + object.name};
}

}  // namespace

std::optional<Edit> inspectLight(Ui& ui, const Scene& scene, const Object& object) {
  if (!section(ui, "Light")) return std::nullopt;
  Fields fields(ui, "light");
  Light next = std::get<Light>(object.content);
  int kind = int(next.kind.index());
  if (fields.choice(
          "Kind",
          "Point: all around. Spot: a cone. Directional: from far away. Sphere, rectangle, disk: lamps "
          "with a size, visible, with soft shadows. Environment: the sky.",
          {"Point", "Spot", "Directional", "Sphere", "Rectangle", "Disk", "Environment"}, kind))
    next = ofKind(next, kind);
  colorFields(fields, next);
  intensityFields(fields, next, worldFromObject(scene, object.id));
  std::visit(KindFields{fields}, next.kind);
  if (auto edit = skyImage(ui, fields, scene, object, next)) return edit;
  if (!fields.changed()) return std::nullopt;
  return Edit{edits::setContent(scene, object.id, next), fields.changeName() + " of " + object.name};
}

}  // namespace steradian::ui
