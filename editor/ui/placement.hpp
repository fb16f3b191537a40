// SPDX-License-Identifier: MIT
// Where and how large a new object comes into the scene, and the scene a new document starts with.
#pragma once
#include "editor/edits.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian::ui {

/// A place on a surface, seen from `distance` metres.
struct Place {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0, 1.0, 0.0};  // unit
  double distance = 5.0;
};

/// Adds `content` at a size that fits the view, resting on the place; a surface gets a material of its own.
edits::Added placed(const Scene& scene, const edits::Content& content, const Place& place,
                    const CameraView& view);

/// A ground, a sphere, a light and a camera: what a new document shows. Built by the same edits.
Scene startScene();

}  // namespace steradian::ui
