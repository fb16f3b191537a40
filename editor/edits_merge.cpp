// SPDX-License-Identifier: MIT
// The edit that takes another scene in.
#include <unordered_map>
#include <unordered_set>

#include "editor/edits.hpp"
#include "editor/edits_detail.hpp"

namespace steradian::edits {

namespace {

/// Hands out names that nothing of a scene has yet.
class FreeNames {
 public:
  template <class Named>
  explicit FreeNames(const std::vector<Named>& there) {
    for (const Named& each : there) taken_.insert(*names_.insert(each.name).first);
  }
  std::string take(std::string_view wanted) {
    std::string name = freeName(wanted, taken_);
    taken_.insert(*names_.insert(name).first);
    return name;
  }

 private:
  std::unordered_set<std::string> names_;
  std::unordered_set<std::string_view> taken_;
};

using IdMap = std::unordered_map<Id, Id>;

Id mapped(const IdMap& map, Id id, Id otherwise) {
  const auto found = map.find(id);
  return found == map.end() ? otherwise : found->second;
}

IdMap addMaterials(Scene& scene, const std::vector<Material>& materials) {
  IdMap ids;
  FreeNames names(scene.materials);
  for (Material material : materials) {
    const Id id = takeId(scene);
    ids.emplace(material.id, id);
    material.id = id;
    material.name = names.take(material.name.empty() ? "Material" : material.name);
    scene.materials.push_back(std::move(material));
  }
  return ids;
}

}  // namespace

Merged merge(Scene scene, const Scene& imported, std::string_view name) {
  Added group = addGroup(std::move(scene));
  Merged out{std::move(group.scene), group.id, {}};
  out.scene = rename(std::move(out.scene), group.id, name);
  const IdMap materials = addMaterials(out.scene, imported.materials);
  IdMap objects;
  for (const Object& object : imported.objects) objects.emplace(object.id, takeId(out.scene));
  FreeNames names(out.scene.objects);
  for (Object object : imported.objects) {
    object.id = objects.at(object.id);
    object.name = names.take(object.name.empty() ? kindName(object.content) : object.name);
    object.parent = mapped(objects, object.parent, out.group);
    if (auto* geometry = std::get_if<Geometry>(&object.content))
      geometry->material = mapped(materials, geometry->material, Id::none);
    out.objects.insert(object.id);
    out.scene.objects.push_back(std::move(object));
  }
  for (Channel channel : imported.animation.channels) {
    channel.target = objects.at(channel.target);
    out.scene.animation.channels.push_back(std::move(channel));
  }
  return out;
}

}  // namespace steradian::edits
