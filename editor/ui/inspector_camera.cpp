// SPDX-License-Identifier: MIT
// Every field of a camera, and moving between it and the editor's own view.
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <cstdio>

#include "editor/ui/inspector.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

void projectionFields(Fields& fields, steradian::Camera& camera) {
  int projection = int(camera.projection);
  if (fields.choice("Projection", "Perspective, as eyes see; orthographic, in parallel, for plans.",
                    {"Perspective", "Orthographic"}, projection))
    camera.projection = steradian::Projection(projection);
  if (camera.projection == steradian::Projection::orthographic) {
    fields.number({.name = "Height",
                   .help = "Full height of what is seen.",
                   .unit = " m",
                   .minimum = 1e-6,
                   .maximum = 1e9,
                   .logarithmic = true,
                   .standard = 2.0},
                  camera.orthographicHeight);
    return;
  }
  double degrees = glm::degrees(camera.fovY);
  if (fields.number({.name = "Field of view",
                     .help = "Full vertical angle. 27\u00b0 is a 50 mm lens on 35 mm film.",
                     .unit = "\u00b0",
                     .minimum = 0.1,
                     .maximum = 175.0,
                     .decimals = 1,
                     .slider = true,
                     .standard = 45.0},
                    degrees))
    camera.fovY = glm::radians(degrees);
}

std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g mm", metres * 1e3);
  return text;
}

/// A thin lens on a full-frame sensor.
void lensFields(Fields& fields, steradian::Camera& camera) {
  fields.note("Focal length", millimetres(0.5 * kSensorHeightMetres / std::tan(0.5 * camera.fovY)),
              "Of a full-frame sensor, 24 mm high, at this field of view.");
  bool open = camera.fNumber > 0.0;
  if (fields.toggle("Depth of field", "A lens with an opening instead of a pinhole.", open))
    camera.fNumber = open ? 2.8 : 0.0;
  if (!open) return;
  fields.number({.name = "F-number",
                 .help = "Focal length over opening: the smaller, the shallower the depth of field.",
                 .minimum = 0.01,
                 .maximum = 1000.0,
                 .decimals = 2,
                 .logarithmic = true,
                 .standard = 2.8},
                camera.fNumber);
  fields.number({.name = "Focus distance",
                 .help = "Along the view axis to the plane that is sharp.",
                 .unit = " m",
                 .minimum = 1e-6,
                 .maximum = 1e9,
                 .logarithmic = true,
                 .standard = 5.0},
                camera.focusDistance);
  fields.note("Opening", millimetres(2.0 * apertureRadius(camera)), "Diameter of the lens opening.");
}

}  // namespace

Scene cameraAtView(const Scene& scene, Id camera, const CameraView& view) {
  const Object* object = find(scene, camera);
  if (!object || !std::holds_alternative<steradian::Camera>(object->content)) return scene;
  const glm::dmat4 parent =
      object->parent == Id::none ? glm::dmat4(1.0) : worldFromObject(scene, object->parent);
  const glm::dmat4 local = glm::inverse(parent) * view.worldFromCamera;
  glm::dmat3 axes;
  for (int i = 0; i < 3; ++i) axes[i] = glm::normalize(glm::dvec3(local[i]));
  Transform transform = object->transform;
  transform.translation = glm::dvec3(local[3]);
  transform.rotation = glm::normalize(glm::quat_cast(axes));
  Scene placed = edits::setTransform(scene, camera, transform);
  steradian::Camera lens = std::get<steradian::Camera>(object->content);
  lens.fovY = view.fovY;
  return edits::setContent(std::move(placed), camera, lens);
}

std::optional<Edit> inspectCamera(Ui& ui, const InspectorInput& input, const Object& object) {
  if (!section(ui, "Camera")) return std::nullopt;
  Fields fields(ui, "camera");
  steradian::Camera next = std::get<steradian::Camera>(object.content);
  projectionFields(fields, next);
  if (next.projection == steradian::Projection::perspective) lensFields(fields, next);
  if (fields.changed())
    return Edit{edits::setContent(input.scene, object.id, next), fields.changeName() + " of " + object.name};
  bool active = input.scene.activeCamera == object.id;
  if (fields.toggle("Active", "The camera of stills and of `steradian render`.", active))
    return Edit{edits::setActiveCamera(input.scene, active ? object.id : Id::none), "Choose camera"};
  const float half = (ImGui::GetContentRegionAvail().x - ui.px(7)) * 0.5f;
  const bool inUse = input.throughCamera == object.id;
  if (button(ui, inUse ? "Leave camera" : "Look through", "camera/Look through", "Show what this camera sees",
             half))
    ui.ask(LookThrough{inUse ? Id::none : object.id});
  ImGui::SameLine();
  if (button(ui, "Use this view", "camera/Use this view", "Put this camera where you look from now", half))
    return Edit{cameraAtView(input.scene, object.id, input.view), "Move " + object.name + " to view"};
  return std::nullopt;
}

}  // namespace steradian::ui
