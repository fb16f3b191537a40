// SPDX-License-Identifier: MIT
// What a model without camera or light is first seen with.
#include "editor/first_view.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

#include "editor/bounds.hpp"
#include "editor/edits.hpp"

namespace steradian {

namespace {

template <class Content>
bool holds(const Scene& scene) {
  return std::ranges::any_of(scene.objects,
                             [](const Object& o) { return std::holds_alternative<Content>(o.content); });
}

bool shines(const Scene& scene) {
  return holds<Light>(scene) ||
         std::ranges::any_of(scene.materials, [](const Material& m) { return m.emissionLuminance > 0; });
}

/// From the front, a little from the right and from above.
Transform seeing(const Bounds& bounds, const Camera& camera, double aspect) {
  Transform out;
  out.rotation = glm::angleAxis(0.6, glm::dvec3(0, 1, 0)) * glm::angleAxis(-0.35, glm::dvec3(1, 0, 0));
  const double halfY = 0.5 * camera.fovY, halfX = std::atan(std::tan(halfY) * aspect);
  const double distance = 1.05 * std::max(bounds.radius(), 1e-6) / std::sin(std::min(halfX, halfY));
  out.translation = bounds.center() + out.rotation * glm::dvec3(0, 0, distance);
  return out;
}

}  // namespace

FirstView withFirstView(Scene scene) {
  FirstView out;
  const auto bounds = boundsOf(scene);
  if (!holds<Camera>(scene) && bounds) {
    const double aspect = double(scene.render.width) / scene.render.height;
    Camera camera;
    const Transform place = seeing(*bounds, camera, aspect);
    camera.focusDistance = glm::length(place.translation - bounds->center());
    scene = edits::addCamera(std::move(scene), camera, place).scene;
    out.added = "a camera that sees everything";
  }
  if (!shines(scene)) {
    const EnvironmentLight soft{.horizon = glm::vec3(0.8f), .ground = glm::vec3(0.4f)};
    scene = edits::addLight(std::move(scene), Light{.kind = soft, .intensity = 1.0f}).scene;
    out.added += out.added.empty() ? "a soft sky" : " and a soft sky";
  }
  out.scene = std::move(scene);
  return out;
}

}  // namespace steradian
