// SPDX-License-Identifier: MIT
// The inspector: every field of the active object, of the render settings and of the display.
#pragma once
#include <optional>
#include <span>

#include "editor/document.hpp"
#include "editor/ui/ui.hpp"
#include "editor/ui/widgets.hpp"
#include "plugins/host/plugin_host.hpp"
#include "renderer/renderer.hpp"
#include "renderer/scene_cache.hpp"

namespace steradian::ui {

/// Rotations are stored as quaternions; the angles a person typed are kept as long as they still mean the
/// same rotation, so that they do not jump while they are dragged.
struct EulerMemory {
  Id object = Id::none;
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 degrees{0.0};
};

struct InspectorState {
  EulerMemory euler;
};

/// What the inspector may look at.
struct InspectorInput {
  const Scene& scene;
  const Document& document;
  CameraView view;   // where the editor looks from
  Id throughCamera;  // the camera looked through, none = the free view
  const plugins::PluginHost& plugins;
  const SceneCache& cache;  // what meshes and textures take on the device
  const RenderStats& stats;
};

std::optional<Edit> inspector(Ui& ui, InspectorState& state, const InspectorInput& input);

// Its parts, each in a file of its own; each returns the edit that a person made in it.
std::optional<Edit> inspectObject(Ui& ui, const Scene& scene, const Object& object);
std::optional<Edit> inspectTransform(Ui& ui, EulerMemory& euler, const Scene& scene, const Object& object);
std::optional<Edit> inspectShape(Ui& ui, const InspectorInput& input, const Object& object);
std::optional<Edit> inspectMaterial(Ui& ui, const InspectorInput& input, const Object& object);
std::optional<Edit> inspectLight(Ui& ui, const Scene& scene, const Object& object);
std::optional<Edit> inspectCamera(Ui& ui, const InspectorInput& input, const Object& object);
std::optional<Edit> inspectRender(Ui& ui, const Scene& scene);
/// Rows that only inform: the textures of a material, and what the whole scene holds.
void textureRows(Fields& fields, const Material& material, const SceneCache& cache);
void inspectStatistics(Ui& ui, const InspectorInput& input);
std::optional<Edit> inspectDisplay(Ui& ui, const InspectorInput& input);

/// The scene with `camera` placed so that it sees `view`.
Scene cameraAtView(const Scene& scene, Id camera, const CameraView& view);

}  // namespace steradian::ui
