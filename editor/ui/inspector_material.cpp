// SPDX-License-Identifier: MIT
// The material of the active object: choosing one, and every field of it.
#include <algorithm>
#include <vector>

#include "editor/ui/inspector.hpp"
#include "editor/ui/widgets.hpp"

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
  emissionFields(fields, next);
  const int users = usersOf(input.scene, material->id);
  if (users > 1) fields.note("Used by", std::to_string(users) + " objects", "A change shows on all of them.");
  ImGui::PopID();
  if (!fields.changed()) return std::nullopt;
  return Edit{edits::setMaterial(input.scene, next), fields.changeName() + " of " + material->name};
}

}  // namespace steradian::ui
