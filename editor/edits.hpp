// SPDX-License-Identifier: MIT
// Every editing operation as a pure function Scene -> Scene; the Document stores the results, so undo needs
// nothing.
#pragma once
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/error.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian::edits {

/// A scene with something new in it.
struct Added {
  Scene scene;
  Id id = Id::none;  // of the new object or material
};
struct AddedMany {
  Scene scene;
  std::vector<Id> ids;
};

using Content = std::variant<Group, Geometry, Light, Camera>;

// New objects go to the end of the outliner's order, without a parent, under a name that is still free.
Added addShape(Scene scene, const Shape& shape, const Transform& transform = {}, Id material = Id::none);
Added addLight(Scene scene, const Light& light, const Transform& transform = {});
Added addCamera(Scene scene, const Camera& camera, const Transform& transform = {});  // active if the first
Added addGroup(Scene scene, const Transform& transform = {});
/// "Sphere", "Point light", "Group" ...: how the kind is called in menus and in new names.
std::string kindName(const Content& content);

/// Removing an object removes what the outliner shows inside it, as file trees do; `keep` hands the children
/// to the nearest remaining ancestor at the same place in the world instead.
enum class Children { remove, keep };
Scene remove(Scene scene, std::span<const Id> objects, Children children = Children::remove);

/// Deep copies with new ids and names ("Lamp" -> "Lamp.001"), animation included. An object whose ancestor is
/// in the list too is copied once. The ids are those of the copied roots, in the order of the scene.
AddedMany duplicate(Scene scene, std::span<const Id> objects);

/// A scene with another one in it.
struct Merged {
  Scene scene;
  Id group = Id::none;   // of everything that came
  std::set<Id> objects;  // what came
};
/// Adds the objects, materials and animation of `imported`, a sound scene, under one group called `name`:
/// with new ids and names that are still free. Its settings stay out, and its cameras are only objects.
Merged merge(Scene scene, const Scene& imported, std::string_view name);

/// Names stay unique: a taken one gets the next free number. An empty name changes nothing.
Scene rename(Scene scene, Id object, std::string_view name);
Scene setVisible(Scene scene, std::span<const Id> objects, bool visible);
/// Keeps the placement in the world (a shear, which no Transform can hold, is dropped).
/// Throws Error(failed) when `parent` is the object itself or one of its descendants.
Scene setParent(Scene scene, std::span<const Id> objects, Id parent);
Scene setTransform(Scene scene, Id object, const Transform& transform);
Scene setContent(Scene scene, Id object, const Content& content);

Added addMaterial(Scene scene, Material material = {});
/// Replaces the material of the same id; its name is kept unique.
Scene setMaterial(Scene scene, const Material& material);
/// Puts `material` (none = the default one) on the objects that have a surface.
Scene assignMaterial(Scene scene, std::span<const Id> objects, Id material);
/// A copy of the object's material (a default one if it has none), used by this object alone.
Added assignNewMaterial(Scene scene, Id object);
Scene removeUnusedMaterials(Scene scene);

Scene setRender(Scene scene, const RenderSettings& render);
Scene setDisplay(Scene scene, const DisplaySettings& display);
Scene setActiveCamera(Scene scene, Id camera);

/// Keys the object's present value of `property` at `time` (seconds); a key at that time is replaced.
Scene setKeyframe(Scene scene, Id object, Property property, double time);
/// A channel that loses its last key is removed.
Scene removeKeyframe(Scene scene, Id object, Property property, double time);

/// `wanted`, or `wanted` with the first free number after its stem: "Lamp.003" taken -> "Lamp.004".
std::string freeObjectName(const Scene& scene, std::string_view wanted, Id except = Id::none);

}  // namespace steradian::edits
