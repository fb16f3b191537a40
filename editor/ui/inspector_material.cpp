// SPDX-License-Identifier: MIT
// The material of the active object: choosing one, and every field of it.
#include <algorithm>
#include <vector>

#include "editor/ui/furnace_view.hpp"
#include "editor/ui/inspector.hpp"
#include "editor/ui/widgets.hpp"
#include "renderer/scene/metals.hpp"

namespace steradian::ui {

namespace {

/// Selected objects that have a surface: a chosen material goes on all of them.
std::vector<Id> surfaces(const InspectorInput& input) {
  std::vector<Id> ids;
  for (const Id id : input.document.selection()) {
    const Object* object = find(input.scene, id);
    if (object && std::holds_alternative<Geometry>(object->content)) ids.push_back(id);
  }
  return ids;
}

int usersOf(const Scene& scene, Id material) {
  return int(std::ranges::count_if(scene.objects, [&](const Object& object) {
    const auto* geometry = std::get_if<Geometry>(&object.content);
    return geometry && geometry->material == material;
  }));
}

std::optional<Edit> chooseMaterial(Ui& ui, const InspectorInput& input, const Object& object,
                                   const Material* current) {
  std::optional<Edit> edit;
  Fields fields(ui, "material");
  fields.begin("Assigned", "The material on this surface; several objects may share one.");
  const float newWidth = ui.px(46);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - newWidth - ui.px(6));
  if (ImGui::BeginCombo("##material", current ? current->name.c_str() : "default")) {
    if (ImGui::Selectable("default", !current))
      edit = Edit{edits::assignMaterial(input.scene, surfaces(input), Id::none), "Assign default material"};
    for (const Material& material : input.scene.materials) {
      ImGui::PushID(int(material.id));
      if (ImGui::Selectable(material.name.c_str(), current && current->id == material.id))
        edit =
            Edit{edits::assignMaterial(input.scene, surfaces(input), material.id), "Assign " + material.name};
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  ui.mark("material/Assigned");
  ImGui::SameLine();
  if (button(ui, "New", "material/New", "A copy of this material, for this object alone", newWidth))
    edit = Edit{edits::assignNewMaterial(input.scene, object.id).scene, "New material for " + object.name};
  fields.end(false);
  return edit;
}

void surfaceFields(Fields& fields, Material& m) {
  fields.linearColor("Albedo",
                     "Base colour: the share of light that a diffuse surface gives back, or a metal's "
                     "reflectance at normal incidence. Stored linear (Rec. 709), shown as sRGB.",
                     m.albedo);
  fields.number({.name = "Metallic",
                 .help = "0 = dielectric (plastic, stone), 1 = metal.",
                 .slider = true,
                 .standard = 0.0},
                m.metallic);
  fields.number({.name = "Roughness",
                 .help = "Perceptual roughness; the GGX width is its square. 0 = mirror, 1 = matt.",
                 .slider = true,
                 .standard = 0.5},
                m.roughness);
  fields.number({.name = "Specular",
                 .help = "Weight of the dielectric reflection; 0 = pure Lambert.",
                 .slider = true,
                 .standard = 1.0},
                m.specular);
  fields.number({.name = "IOR",
                 .help = "Index of refraction of the dielectric: water 1.33, glass 1.5, diamond 2.42.",
                 .minimum = 1.0,
                 .maximum = 4.0,
                 .slider = true,
                 .standard = 1.5},
                m.ior);
}

bool isMadeOf(const Metal& metal, const Material& m) {
  return madeOf(metal, m) == m;
}

void metalFields(Ui& ui, Fields& fields, Material& m) {
  if (m.metallic <= 0.0f) return;
  fields.begin("Metal", "Measured metals: sets albedo and edge tint from their optical constants.");
  const auto known = std::ranges::find_if(metals(), [&](const Metal& metal) { return isMadeOf(metal, m); });
  bool chosen = false;
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::BeginCombo("##metal", known != metals().end() ? known->name : "custom")) {
    for (const Metal& metal : metals()) {
      if (ImGui::Selectable(metal.name, isMadeOf(metal, m))) {
        m = madeOf(metal, m);
        chosen = true;
      }
      if (ImGui::IsItemHovered()) tooltip(metal.source);
    }
    ImGui::EndCombo();
  }
  ui.mark("material/Metal");
  fields.end(chosen);
  fields.linearColor(
      "Edge tint",
      "Metals: reflectance at 82\u00b0 beside the plain Schlick curve's. White = plain Schlick; measured "
      "metals dip a little before the edge.",
      m.edgeTint);
}

void transmissionFields(Fields& fields, Material& m) {
  fields.number(
      {.name = "Transmission",
       .help = "Share of the dielectric base that lets light through: glass and water 1. Solids refract, "
               "flat shapes let pass straight.",
       .slider = true,
       .standard = 0.0},
      m.transmission);
  if (m.transmission <= 0.0f) return;
  const bool coloured = fields.linearColor(
      "Absorption", "What is left of white light after the distance below, inside a solid.",
      m.attenuationColor);
  if (coloured) m.attenuationColor = glm::max(m.attenuationColor, glm::vec3(1e-4f));
  fields.number({.name = "Distance",
                 .help = "Way through the solid after which the absorption colour is left; 0 = clear.",
                 .unit = " m",
                 .minimum = 0.0,
                 .maximum = 1e6,
                 .decimals = 4,
                 .logarithmic = true,
                 .standard = 0.0},
                m.attenuationDistance);
}

void clearcoatFields(Fields& fields, Material& m) {
  fields.number({.name = "Clearcoat",
                 .help = "Weight of a clear coat (IOR 1.5) on top: car paint, varnished wood 1.",
                 .slider = true,
                 .standard = 0.0},
                m.clearcoat);
  if (m.clearcoat <= 0.0f) return;
  fields.number({.name = "Coat roughness",
                 .help = "Perceptual roughness of the coat. 0 = mirror.",
                 .slider = true,
                 .standard = 0.0},
                m.clearcoatRoughness);
}

void emissionFields(Fields& fields, Material& m) {
  fields.linearColor("Emission", "Multiplies the luminance. Linear Rec. 709, may exceed 1.", m.emissionColor,
                     true);
  fields.number({.name = "Luminance",
                 .help = "What the surface itself sends out, on both sides. A screen has about 300, the sky "
                         "5,000, a filament 10,000,000.",
                 .unit = " nit",
                 .minimum = 0.0,
                 .maximum = 1e10,
                 .decimals = 2,
                 .logarithmic = true,
                 .standard = 0.0},
                m.emissionLuminance);
}

}  // namespace

std::optional<Edit> inspectMaterial(Ui& ui, const InspectorInput& input, const Object& object) {
  if (!section(ui, "Material")) return std::nullopt;
  const Material* material = findMaterial(input.scene, std::get<Geometry>(object.content).material);
  if (auto edit = chooseMaterial(ui, input, object, material)) return edit;
  if (!material) {
    dimText("The default material is a neutral grey. Press New to give this object its own.");
    return std::nullopt;
  }
  Fields fields(ui, "material");
  Material next = *material;
  ImGui::PushID(int(material->id));
  fields.text("Name", "Names of materials are unique in a scene.", next.name);
  surfaceFields(fields, next);
  metalFields(ui, fields, next);
  transmissionFields(fields, next);
  clearcoatFields(fields, next);
  emissionFields(fields, next);
  textureRows(fields, *material, input.cache);
  const bool furnace = ImGui::TreeNode("Furnace");
  ui.mark("material/Furnace view");
  if (furnace) {
    furnaceView(ui, next, input.scene.render.energyCompensation);
    ImGui::TreePop();
  }
  const int users = usersOf(input.scene, material->id);
  if (users > 1) fields.note("Used by", std::to_string(users) + " objects", "A change shows on all of them.");
  ImGui::PopID();
  if (!fields.changed()) return std::nullopt;
  return Edit{edits::setMaterial(input.scene, next), fields.changeName() + " of " + material->name};
}

}  // namespace steradian::ui
