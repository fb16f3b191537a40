// SPDX-License-Identifier: MIT
// Exposure, tonemapper with its plugin's parameters, and output transfer.
#include <cmath>

#include "editor/ui/inspector.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

using plugins::Contribution;
using plugins::Parameter;

void tonemapperChoice(Ui& ui, Fields& fields, const plugins::PluginHost& host, DisplaySettings& d) {
  const Contribution* current = host.tonemapper(d.tonemapper);
  bool changed = false;
  fields.begin("Tonemapper", "Brings scene-linear radiance into the range of a display. A plugin.");
  if (ImGui::BeginCombo("##tonemapper", current ? current->name.c_str() : d.tonemapper.c_str())) {
    for (const Contribution* candidate : host.contributions(plugins::Kind::tonemapper)) {
      if (ImGui::Selectable(candidate->name.c_str(), candidate == current) && candidate != current) {
        d.tonemapper = candidate->id;
        d.parameters.clear();
        changed = true;
      }
      ui.mark("display/Tonemapper/" + candidate->name);
    }
    ImGui::EndCombo();
  }
  fields.end(changed);
  if (!current) dimText("No plugin offers this tonemapper; the last one stays in use.");
}

void parameterField(Fields& fields, const Parameter& parameter, DisplaySettings& d) {
  const auto stored = d.parameters.find(parameter.id);
  double value = stored == d.parameters.end() ? parameter.defaultValue : stored->second;
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  bool changed = false;
  if (parameter.type == Parameter::Type::boolean) {
    bool on = value != 0.0;
    changed = fields.toggle(parameter.name.c_str(), parameter.help.c_str(), on);
    value = on ? 1.0 : 0.0;
  } else {
    const bool whole = parameter.type == Parameter::Type::integer;
    changed = fields.number({.name = parameter.name.c_str(),
                             .help = parameter.help.c_str(),
                             .unit = unit.c_str(),
                             .minimum = parameter.minimum,
                             .maximum = parameter.maximum,
                             .decimals = whole ? 0 : 3,
                             .slider = true,
                             .standard = parameter.defaultValue},
                            value);
    if (whole) value = std::round(value);
  }
  if (changed) d.parameters[parameter.id] = float(value);
}

void exposureFields(Fields& fields, DisplaySettings& d) {
  fields.number({.name = "Exposure",
                 .help = "Each stop doubles the brightness that is shown.",
                 .unit = " EV",
                 .minimum = -16.0,
                 .maximum = 16.0,
                 .decimals = 2,
                 .slider = true,
                 .standard = 0.0},
                d.exposure);
  fields.toggle("Physical",
                "Exposes as a camera does: white is 1.2 \u00d7 2^EV100 nit, then the stops above.",
                d.physical);
  if (!d.physical) return;
  fields.number(
      {.name = "EV100",
       .help = "Exposure value at ISO 100: night street 3, living room 7, overcast 12, full sun 15.",
       .minimum = -10.0,
       .maximum = 25.0,
       .decimals = 2,
       .slider = true,
       .standard = 0.0},
      d.ev100);
}

}  // namespace

std::optional<Edit> inspectDisplay(Ui& ui, const InspectorInput& input) {
  Fields fields(ui, "display");
  DisplaySettings next = input.scene.display;
  if (section(ui, "Exposure and tone")) {
    exposureFields(fields, next);
    tonemapperChoice(ui, fields, input.plugins, next);
    if (const Contribution* tonemapper = input.plugins.tonemapper(next.tonemapper))
      for (const Parameter& parameter : tonemapper->parameters) parameterField(fields, parameter, next);
  }
  if (section(ui, "Output")) {
    int transfer = int(next.transfer);
    if (fields.choice("Transfer", "How linear values become code values. sRGB for screens and PNG files.",
                      {"sRGB", "Gamma"}, transfer))
      next.transfer = Transfer(transfer);
    if (next.transfer == Transfer::gamma)
      fields.number({.name = "Gamma",
                     .help = "Exponent of a plain power curve.",
                     .minimum = 1.0,
                     .maximum = 4.0,
                     .decimals = 2,
                     .slider = true,
                     .standard = 2.2},
                    next.gamma);
  }
  dimText("EXR files keep scene-linear radiance and ignore these settings.");
  if (!fields.changed()) return std::nullopt;
  return Edit{edits::setDisplay(input.scene, next), fields.changeName()};
}

}  // namespace steradian::ui
