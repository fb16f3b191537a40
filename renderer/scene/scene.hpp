// SPDX-License-Identifier: MIT
// The scene is a value: copy it, compare it, edit it by pure functions Scene -> Scene.
// Axes and units as glTF: right-handed, Y up, metres, radians, photometric SI, linear Rec. 709.
#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "renderer/scene/animation.hpp"
#include "renderer/scene/camera.hpp"
#include "renderer/scene/ids.hpp"
#include "renderer/scene/light.hpp"
#include "renderer/scene/material.hpp"
#include "renderer/scene/settings.hpp"
#include "renderer/scene/shape.hpp"
#include "renderer/scene/transform.hpp"

namespace steradian {

/// Only groups its children.
struct Group {
  bool operator==(const Group&) const = default;
};

struct Object {
  Id id = Id::none;
  std::string name;
  Id parent = Id::none;
  Transform transform;  // parentFromLocal
  bool visible = true;  // hides its children too
  std::variant<Group, Geometry, Light, Camera> content;
  std::string extras;  // unknown keys of the project file, as JSON text

  bool operator==(const Object&) const = default;
};

struct Scene {
  std::string name;
  std::vector<Object> objects;  // parents may follow children; order is the outliner's
  std::vector<Material> materials;
  Id activeCamera = Id::none;  // object; none = the first camera
  RenderSettings render;
  DisplaySettings display;
  Animation animation;
  std::string extras;  // unknown top-level keys, as JSON text
  Id nextId = Id{1};   // ids are never reused, also across save and load

  bool operator==(const Scene&) const = default;
};

const Object* find(const Scene& scene, Id object);  // nullptr when absent
const Material* findMaterial(const Scene& scene, Id material);
const Object* findByName(const Scene& scene, std::string_view name);  // the first of that name

/// worldFromObject through the parents; a broken or cyclic chain ends at the break.
glm::dmat4 worldFromObject(const Scene& scene, Id object);
bool visibleInHierarchy(const Scene& scene, Id object);

/// The same for all objects in the order of scene.objects, in linear time.
std::vector<glm::dmat4> worldTransforms(const Scene& scene);
std::vector<bool> hierarchyVisibility(const Scene& scene);

/// The camera to render: by name, else the active, else the first; a default one when the scene has none.
/// Throws Error(badInput) naming the cameras there are when `name` is not among them.
CameraView cameraView(const Scene& scene, std::string_view name = {});

/// The scene at `timeSeconds`: channels applied, everything else unchanged.
Scene evaluatedAt(const Scene& scene, double timeSeconds);

}  // namespace steradian
