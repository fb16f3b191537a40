// SPDX-License-Identifier: MIT
// Every field of a camera, and moving between it and the editor's own view.
#include <glm/gtc/quaternion.hpp>

#include "editor/ui/inspector.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

Scene cameraAtView(const Scene& scene, Id camera, const CameraView& view) {
  const Object* object = find(scene, camera);
  if (!object) return scene;
  const glm::dmat4 parent =
      object->parent == Id::none ? glm::dmat4(1.0) : worldFromObject(scene, object->parent);
  const glm::dmat4 local = glm::inverse(parent) * view.worldFromCamera;
  glm::dmat3 axes;
  for (int i = 0; i < 3; ++i) axes[i] = glm::normalize(glm::dvec3(local[i]));
  Transform transform = object->transform;
  transform.translation = glm::dvec3(local[3]);
  transform.rotation = glm::normalize(glm::quat_cast(axes));
  Scene placed = edits::setTransform(scene, camera, transform);
  return edits::setContent(std::move(placed), camera, steradian::Camera{view.fovY});
}

std::optional<Edit> inspectCamera(Ui& ui, const InspectorInput& input, const Object& object) {
  if (!section(ui, "Camera")) return std::nullopt;
  Fields fields(ui, "camera");
  steradian::Camera next = std::get<steradian::Camera>(object.content);
  double degrees = glm::degrees(next.fovY);
  if (fields.number({.name = "Field of view",
                     .help = "Full vertical angle. 27\u00b0 is a 50 mm lens on 35 mm film.",
                     .unit = "\u00b0",
                     .minimum = 0.1,
                     .maximum = 175.0,
                     .decimals = 1,
                     .slider = true,
                     .standard = 45.0},
                    degrees)) {
    next.fovY = glm::radians(degrees);
    return Edit{edits::setContent(input.scene, object.id, next), "Change field of view of " + object.name};
  }
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
