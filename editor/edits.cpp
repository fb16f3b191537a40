// SPDX-License-Identifier: MIT
// Edits of the object tree: add, remove, duplicate, rename, reparent.
#include "editor/edits.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <unordered_map>
#include <unordered_set>

#include "editor/edits_detail.hpp"

namespace steradian::edits {

namespace {

using IdSet = std::unordered_set<Id>;

/// `ids` and everything below them, in linear time even for deep chains.
IdSet withDescendants(const Scene& scene, std::span<const Id> ids) {
  std::unordered_multimap<Id, Id> children;
  for (const Object& object : scene.objects) children.emplace(object.parent, object.id);
  IdSet all;
  std::vector<Id> open(ids.begin(), ids.end());
  while (!open.empty()) {
    const Id id = open.back();
    open.pop_back();
    if (id == Id::none || !all.insert(id).second) continue;
    const auto [first, last] = children.equal_range(id);
    for (auto child = first; child != last; ++child) open.push_back(child->second);
  }
  return all;
}

/// The nearest ancestor of `object` that is not in `gone`.
Id remainingAncestor(const std::unordered_map<Id, Id>& parents, Id object, const IdSet& gone) {
  for (std::size_t steps = 0; steps <= parents.size(); ++steps) {
    const auto parent = parents.find(object);
    if (parent == parents.end() || parent->second == Id::none) break;
    object = parent->second;
    if (!gone.count(object)) return object;
  }
  return Id::none;
}

std::unordered_map<Id, Id> parentsOf(const Scene& scene) {
  std::unordered_map<Id, Id> parents;
  for (const Object& object : scene.objects) parents.emplace(object.id, object.parent);
  return parents;
}

/// Hands the children of `gone` to what remains, at the same place in the world.
Scene reparentAround(Scene scene, const IdSet& gone) {
  const auto parents = parentsOf(scene);
  const auto world = worldTransforms(scene);
  std::unordered_map<Id, glm::dmat4> worldFrom;
  for (std::size_t i = 0; i < world.size(); ++i) worldFrom.emplace(scene.objects[i].id, world[i]);
  for (std::size_t i = 0; i < world.size(); ++i) {
    Object& object = scene.objects[i];
    if (gone.count(object.id) || !gone.count(object.parent)) continue;
    object.parent = remainingAncestor(parents, object.id, gone);
    const glm::dmat4 worldFromParent =
        object.parent == Id::none ? glm::dmat4(1.0) : worldFrom.at(object.parent);
    object.transform = transformOf(glm::inverse(worldFromParent) * world[i]);
  }
  return scene;
}

Scene withoutObjects(Scene scene, const IdSet& gone) {
  std::erase_if(scene.objects, [&](const Object& o) { return gone.count(o.id) > 0; });
  std::erase_if(scene.animation.channels, [&](const Channel& c) { return gone.count(c.target) > 0; });
  if (gone.count(scene.activeCamera)) scene.activeCamera = Id::none;
  return scene;
}

Added addObject(Scene scene, Content content, const Transform& transform) {
  Object object;
  object.id = takeId(scene);
  object.name = freeObjectName(scene, kindName(content));
  object.transform = transform;
  object.content = std::move(content);
  scene.objects.push_back(object);
  return {std::move(scene), object.id};
}

struct ShapeName {
  const char* operator()(const Sphere&) const { return "Sphere"; }
  const char* operator()(const Plane&) const { return "Plane"; }
  const char* operator()(const Box&) const { return "Box"; }
  const char* operator()(const Rect&) const { return "Rect"; }
  const char* operator()(const Disk&) const { return "Disk"; }
  const char* operator()(const Cylinder&) const { return "Cylinder"; }
  const char* operator()(const MeshShape&) const { return "Mesh"; }
};
struct LightName {
  const char* operator()(const PointLight&) const { return "Point light"; }
  const char* operator()(const SpotLight&) const { return "Spot light"; }
  const char* operator()(const DirectionalLight&) const { return "Directional light"; }
  const char* operator()(const SphereLight&) const { return "Sphere light"; }
  const char* operator()(const RectLight&) const { return "Rect light"; }
  const char* operator()(const DiskLight&) const { return "Disk light"; }
  const char* operator()(const EnvironmentLight&) const { return "Environment"; }
};
struct ContentName {
  const char* operator()(const Group&) const { return "Group"; }
  const char* operator()(const Camera&) const { return "Camera"; }
  const char* operator()(const Geometry& geometry) const { return std::visit(ShapeName{}, geometry.shape); }
  const char* operator()(const Light& light) const { return std::visit(LightName{}, light.kind); }
};

}  // namespace

Object* findMutable(Scene& scene, Id id) {
  return const_cast<Object*>(find(scene, id));
}

Id takeId(Scene& scene) {
  const Id id = scene.nextId;
  scene.nextId = Id(unsigned(id) + 1);
  return id;
}

std::string freeName(std::string_view wanted, const std::unordered_set<std::string_view>& taken) {
  if (!taken.count(wanted)) return std::string(wanted);
  std::size_t stemLength = wanted.size();
  while (stemLength > 0 && std::isdigit(static_cast<unsigned char>(wanted[stemLength - 1]))) --stemLength;
  const bool numbered = stemLength > 1 && stemLength < wanted.size() && wanted[stemLength - 1] == '.' &&
                        wanted.size() - stemLength <= 6;
  const std::string stem(numbered ? wanted.substr(0, stemLength - 1) : wanted);
  for (unsigned number = numbered ? unsigned(std::stoul(std::string(wanted.substr(stemLength)))) + 1 : 1;;
       ++number) {
    char digits[16];
    std::snprintf(digits, sizeof digits, ".%03u", number);
    if (!taken.count(stem + digits)) return stem + digits;
  }
}

std::string freeObjectName(const Scene& scene, std::string_view wanted, Id except) {
  std::unordered_set<std::string_view> taken;
  for (const Object& object : scene.objects)
    if (object.id != except) taken.insert(object.name);
  return freeName(wanted, taken);
}

std::string kindName(const Content& content) {
  return std::visit(ContentName{}, content);
}

Added addShape(Scene scene, const Shape& shape, const Transform& transform, Id material) {
  return addObject(std::move(scene), Geometry{shape, material}, transform);
}

Added addLight(Scene scene, const Light& light, const Transform& transform) {
  return addObject(std::move(scene), light, transform);
}

Added addCamera(Scene scene, const Camera& camera, const Transform& transform) {
  const bool first = std::none_of(scene.objects.begin(), scene.objects.end(),
                                  [](const Object& o) { return std::holds_alternative<Camera>(o.content); });
  Added added = addObject(std::move(scene), camera, transform);
  if (first) added.scene.activeCamera = added.id;
  return added;
}

Added addGroup(Scene scene, const Transform& transform) {
  return addObject(std::move(scene), Group{}, transform);
}

Scene remove(Scene scene, std::span<const Id> objects, Children children) {
  if (children == Children::remove) {
    const IdSet gone = withDescendants(scene, objects);
    return withoutObjects(std::move(scene), gone);
  }
  const IdSet gone(objects.begin(), objects.end());
  return withoutObjects(reparentAround(std::move(scene), gone), gone);
}

AddedMany duplicate(Scene scene, std::span<const Id> objects) {
  const IdSet copied = withDescendants(scene, objects);
  std::unordered_map<Id, Id> copyOf;
  std::unordered_set<std::string> names;
  for (const Object& object : scene.objects) names.insert(object.name);
  std::unordered_set<std::string_view> taken(names.begin(), names.end());
  AddedMany added;
  std::vector<Object> copies;
  for (const Object& object : scene.objects) {
    if (!copied.count(object.id)) continue;
    Object copy = object;
    copy.id = takeId(scene);
    copy.name = freeName(object.name, taken);
    taken.insert(*names.insert(copy.name).first);
    copyOf.emplace(object.id, copy.id);
    if (!copied.count(object.parent)) added.ids.push_back(copy.id);
    copies.push_back(std::move(copy));
  }
  for (Object& copy : copies)
    if (const auto parent = copyOf.find(copy.parent); parent != copyOf.end()) copy.parent = parent->second;
  scene.objects.insert(scene.objects.end(), copies.begin(), copies.end());
  const std::vector<Channel> channels = scene.animation.channels;
  for (Channel channel : channels) {
    const auto target = copyOf.find(channel.target);
    if (target == copyOf.end()) continue;
    channel.target = target->second;
    scene.animation.channels.push_back(std::move(channel));
  }
  added.scene = std::move(scene);
  return added;
}

Scene rename(Scene scene, Id object, std::string_view name) {
  Object* found = findMutable(scene, object);
  if (found && !name.empty()) found->name = freeObjectName(scene, name, object);
  return scene;
}

Scene setVisible(Scene scene, std::span<const Id> objects, bool visible) {
  for (const Id id : objects)
    if (Object* object = findMutable(scene, id)) object->visible = visible;
  return scene;
}

Scene setParent(Scene scene, std::span<const Id> objects, Id parent) {
  const Object* target = find(scene, parent);
  if (target && withDescendants(scene, objects).count(parent))
    throw Error(ExitCode::failed,
                "'" + target->name + "' is itself moved or lies inside what is moved; choose another parent");
  const Id newParent = target ? parent : Id::none;
  const glm::dmat4 parentFromWorld = glm::inverse(target ? worldFromObject(scene, parent) : glm::dmat4(1.0));
  // All worlds are taken before anything moves: one moved object may lie inside another.
  const Scene before = scene;
  for (const Id id : objects) {
    Object* object = findMutable(scene, id);
    if (!object || object->parent == newParent) continue;
    object->transform = transformOf(parentFromWorld * worldFromObject(before, id));
    object->parent = newParent;
  }
  return scene;
}

Scene setTransform(Scene scene, Id object, const Transform& transform) {
  if (Object* found = findMutable(scene, object)) found->transform = transform;
  return scene;
}

}  // namespace steradian::edits
