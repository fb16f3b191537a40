// SPDX-License-Identifier: MIT
// Look-ups and the object hierarchy. Every walk is iterative and ends on a broken or cyclic chain.
#include "renderer/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "renderer/scene/error.hpp"

namespace steradian {

namespace {

using Index = std::unordered_map<Id, std::size_t>;

Index indexOf(const Scene& scene) {
  Index index;
  index.reserve(scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) index.emplace(scene.objects[i].id, i);
  return index;
}

/// The object and its ancestors, nearest first. Short chains are searched in place; an index pays for deep
/// ones.
std::vector<const Object*> chainOf(const Scene& scene, Id id) {
  constexpr std::size_t kShallow = 8;
  std::vector<const Object*> chain;
  std::unordered_set<Id> seen;
  Index index;
  const Object* object = find(scene, id);
  while (object && seen.insert(object->id).second) {
    chain.push_back(object);
    if (object->parent == Id::none) break;
    if (chain.size() < kShallow) {
      object = find(scene, object->parent);
      continue;
    }
    if (index.empty()) index = indexOf(scene);
    const auto parent = index.find(object->parent);
    object = parent == index.end() ? nullptr : &scene.objects[parent->second];
  }
  return chain;
}

/// Calls visit(object index, parent index or -1) for every object, parents before their children.
template <class Visit>
void visitParentsFirst(const Scene& scene, Visit visit) {
  const Index index = indexOf(scene);
  enum class State : char { open, onPath, done };
  std::vector<State> state(scene.objects.size(), State::open);
  std::vector<std::size_t> path;
  const auto parentOf = [&](std::size_t i) -> std::ptrdiff_t {
    const auto parent = index.find(scene.objects[i].parent);
    return parent == index.end() ? -1 : std::ptrdiff_t(parent->second);
  };
  for (std::size_t start = 0; start < scene.objects.size(); ++start) {
    // Climb to the first ancestor that is done, missing, or already on this path (a cycle ends there).
    for (std::ptrdiff_t i = std::ptrdiff_t(start); i >= 0 && state[i] == State::open; i = parentOf(i)) {
      state[i] = State::onPath;
      path.push_back(i);
    }
    for (; !path.empty(); path.pop_back()) {
      const std::size_t i = path.back();
      const std::ptrdiff_t parent = parentOf(i);
      visit(i, parent >= 0 && state[parent] == State::done ? parent : -1);
      state[i] = State::done;
    }
  }
}

bool isCamera(const Object& object) {
  return std::holds_alternative<Camera>(object.content);
}

const Object* cameraNamed(const Scene& scene, std::string_view name) {
  const auto named = std::find_if(scene.objects.begin(), scene.objects.end(),
                                  [&](const Object& o) { return isCamera(o) && o.name == name; });
  if (named != scene.objects.end()) return &*named;
  std::string known;
  for (const Object& o : scene.objects)
    if (isCamera(o)) known += (known.empty() ? "'" : ", '") + o.name + "'";
  throw Error(ExitCode::badInput, "no camera is called '" + std::string(name) + "'; " +
                                      (known.empty() ? "the scene has no camera" : "there is " + known));
}

const Object* chosenCamera(const Scene& scene) {
  const Object* active = find(scene, scene.activeCamera);
  if (active && isCamera(*active)) return active;
  const auto first = std::find_if(scene.objects.begin(), scene.objects.end(), isCamera);
  return first == scene.objects.end() ? nullptr : &*first;
}

}  // namespace

const Object* find(const Scene& scene, Id object) {
  const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                  [&](const Object& o) { return o.id == object; });
  return found == scene.objects.end() ? nullptr : &*found;
}

const Material* findMaterial(const Scene& scene, Id material) {
  const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [&](const Material& m) { return m.id == material; });
  return found == scene.materials.end() ? nullptr : &*found;
}

const Object* findByName(const Scene& scene, std::string_view name) {
  const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                  [&](const Object& o) { return o.name == name; });
  return found == scene.objects.end() ? nullptr : &*found;
}

glm::dmat4 worldFromObject(const Scene& scene, Id object) {
  glm::dmat4 worldFromLocal(1.0);
  for (const Object* o : chainOf(scene, object)) worldFromLocal = matrixOf(o->transform) * worldFromLocal;
  return worldFromLocal;
}

bool visibleInHierarchy(const Scene& scene, Id object) {
  const auto chain = chainOf(scene, object);
  return !chain.empty() &&
         std::all_of(chain.begin(), chain.end(), [](const Object* o) { return o->visible; });
}

std::vector<glm::dmat4> worldTransforms(const Scene& scene) {
  std::vector<glm::dmat4> worldFromLocal(scene.objects.size());
  visitParentsFirst(scene, [&](std::size_t i, std::ptrdiff_t parent) {
    const glm::dmat4 parentFromLocal = matrixOf(scene.objects[i].transform);
    worldFromLocal[i] = parent < 0 ? parentFromLocal : worldFromLocal[parent] * parentFromLocal;
  });
  return worldFromLocal;
}

std::vector<bool> hierarchyVisibility(const Scene& scene) {
  std::vector<bool> visible(scene.objects.size());
  visitParentsFirst(scene, [&](std::size_t i, std::ptrdiff_t parent) {
    visible[i] = scene.objects[i].visible && (parent < 0 || visible[parent]);
  });
  return visible;
}

CameraView cameraView(const Scene& scene, std::string_view name) {
  const Object* camera = name.empty() ? chosenCamera(scene) : cameraNamed(scene, name);
  if (!camera) {
    CameraView standing;
    standing.worldFromCamera[3] = glm::dvec4(0.0, 1.0, 6.0, 1.0);
    return standing;
  }
  Transform rigid = transformOf(worldFromObject(scene, camera->id));
  rigid.scale = glm::dvec3(1.0);
  const Camera& lens = std::get<Camera>(camera->content);
  return {matrixOf(rigid), lens.fovY, lens};
}

double apertureRadius(const Camera& camera) {
  if (camera.fNumber <= 0.0 || camera.projection == Projection::orthographic) return 0.0;
  const double focalLength = 0.5 * kSensorHeightMetres / std::tan(0.5 * camera.fovY);
  return 0.5 * focalLength / camera.fNumber;
}

}  // namespace steradian
