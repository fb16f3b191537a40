// SPDX-License-Identifier: MIT
// Name, parent, visibility, placement and shape of the active object.
#include <glm/gtc/quaternion.hpp>

#include <cmath>

#include "editor/ui/inspector.hpp"
#include "editor/ui/numbers.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

bool isInside(const Scene& scene, Id object, Id ancestor) {
  for (Id up = object; up != Id::none;) {
    if (up == ancestor) return true;
    const Object* found = find(scene, up);
    up = found ? found->parent : Id::none;
  }
  return false;
}

std::optional<Edit> parentChoice(Ui& ui, Fields& fields, const Scene& scene, const Object& object) {
  std::optional<Edit> edit;
  const Object* parent = find(scene, object.parent);
  fields.begin("Parent", "The object that this one moves with. Changing it keeps the place in the world.");
  if (ImGui::BeginCombo("##parent", parent ? parent->name.c_str() : "none")) {
    if (ImGui::Selectable("none", !parent))
      edit = Edit{edits::setParent(scene, std::vector{object.id}, Id::none), "Unparent " + object.name};
    for (const Object& candidate : scene.objects) {
      if (isInside(scene, candidate.id, object.id)) continue;
      ImGui::PushID(int(candidate.id));
      if (ImGui::Selectable(candidate.name.c_str(), candidate.id == object.parent))
        edit = Edit{edits::setParent(scene, std::vector{object.id}, candidate.id), "Reparent " + object.name};
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  fields.end(false);
  ui.mark("object/Parent");
  return edit;
}

glm::dvec3& degreesOf(EulerMemory& euler, const Object& object) {
  const glm::dquat& q = object.transform.rotation;
  if (euler.object != object.id || !(euler.rotation == q))
    euler = {object.id, q, glm::degrees(glm::eulerAngles(q)) + 0.0};
  return euler.degrees;
}

/// A scale of 0 has no inverse: the field steps over it.
void keepAwayFromZero(glm::dvec3& scale) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(scale[i]) < 1e-6) scale[i] = scale[i] < 0 ? -1e-6 : 1e-6;
}

/// Draws the sizes of one kind of shape; true when one changed.
struct ShapeFields {
  Fields& fields;
  const SceneCache& cache;
  bool operator()(Sphere& s) {
    return fields.number(lengthField("Radius", "Radius of the sphere.", 1), s.radius);
  }
  bool operator()(Plane&) {
    fields.note("Size", "infinite", "The plane goes through the object's origin, normal along its +Y.");
    return false;
  }
  bool operator()(Box& b) { return fields.vector(lengthField("Size", "Full edge length.", 2), b.size); }
  bool operator()(Rect& r) { return fields.vector(lengthField("Size", "Full edge length.", 2), r.size); }
  bool operator()(Disk& d) {
    return fields.number(lengthField("Radius", "Radius of the disk.", 1), d.radius);
  }
  bool operator()(Cylinder& c) {
    const bool radius = fields.number(lengthField("Radius", "Radius of the cylinder.", 1), c.radius);
    return fields.number(lengthField("Height", "Length along the object's Y axis.", 2), c.height) || radius;
  }
  bool operator()(MeshShape& s) {
    fields.note("Triangles", countText(s.mesh->triangles.size()), "Objects may share one mesh.");
    fields.note("Vertices", countText(s.mesh->positions.size()));
    fields.note("Memory", memoryText(cache.meshes.bytesOf(*s.mesh)),
                "What the mesh takes on the device, once for all objects that share it.");
    return false;
  }
};

}  // namespace

std::optional<Edit> inspectObject(Ui& ui, const Scene& scene, const Object& object) {
  Fields fields(ui, "object");
  ImGui::Dummy({0, ui.px(2)});
  std::string name = object.name;
  if (fields.text("Name", "Names are unique in a scene.", name))
    return Edit{edits::rename(scene, object.id, name), "Rename " + object.name};
  fields.note("Kind", edits::kindName(object.content));
  if (auto edit = parentChoice(ui, fields, scene, object)) return edit;
  bool visible = object.visible;
  if (fields.toggle("Visible", "In the viewport and in renders; hides what the object holds, too.", visible))
    return Edit{edits::setVisible(scene, std::vector{object.id}, visible),
                (visible ? "Show " : "Hide ") + object.name};
  return std::nullopt;
}

std::optional<Edit> inspectTransform(Ui& ui, EulerMemory& euler, const Scene& scene, const Object& object) {
  if (!section(ui, "Transform")) return std::nullopt;
  Fields fields(ui, "transform");
  Transform next = object.transform;
  glm::dvec3& degrees = degreesOf(euler, object);
  const bool moved = fields.vector({.name = "Position",
                                    .help = "Relative to the parent.",
                                    .unit = " m",
                                    .minimum = -kFar,
                                    .maximum = kFar,
                                    .speed = 0.01,
                                    .standard = 0.0},
                                   next.translation);
  const bool turned = fields.vector({.name = "Rotation",
                                     .help = "Euler angles: about X first, then Y, then Z.",
                                     .unit = "\u00b0",
                                     .minimum = -360.0,
                                     .maximum = 360.0,
                                     .speed = 0.5,
                                     .decimals = 2,
                                     .standard = 0.0},
                                    degrees);
  if (turned) euler.rotation = next.rotation = glm::normalize(glm::dquat(glm::radians(degrees)));
  bool scaled = false;
  if (!std::holds_alternative<steradian::Camera>(object.content))
    scaled = fields.vector({.name = "Scale",
                            .help = "Factor along the object's own axis, not 0.",
                            .minimum = -1e6,
                            .maximum = 1e6,
                            .speed = 0.01,
                            .standard = 1.0},
                           next.scale);
  if (scaled) keepAwayFromZero(next.scale);
  if (!moved && !turned && !scaled) return std::nullopt;
  const char* verb = moved ? "Move " : turned ? "Rotate " : "Scale ";
  return Edit{edits::setTransform(scene, object.id, next), verb + object.name};
}

std::optional<Edit> inspectShape(Ui& ui, const InspectorInput& input, const Object& object) {
  if (!section(ui, "Shape")) return std::nullopt;
  Fields fields(ui, "shape");
  Geometry next = std::get<Geometry>(object.content);
  if (!std::visit(ShapeFields{fields, input.cache}, next.shape)) return std::nullopt;
  return Edit{edits::setContent(input.scene, object.id, next), fields.changeName() + " of " + object.name};
}

}  // namespace steradian::ui
