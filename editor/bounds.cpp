// SPDX-License-Identifier: MIT
// The box around objects.
#include "editor/bounds.hpp"

namespace steradian {

namespace {

/// Half extents before the transform; nullopt for what is infinite. Lights without a size and cameras are
/// points.
struct HalfExtent {
  std::optional<glm::dvec3> operator()(const Group&) const { return std::nullopt; }
  std::optional<glm::dvec3> operator()(const Light& light) const { return std::visit(*this, light.kind); }
  std::optional<glm::dvec3> operator()(const SphereLight& l) const { return glm::dvec3(l.radius); }
  std::optional<glm::dvec3> operator()(const RectLight& l) const { return glm::dvec3(0.5 * l.size, 0.0); }
  std::optional<glm::dvec3> operator()(const DiskLight& l) const {
    return glm::dvec3(l.radius, l.radius, 0.0);
  }
  std::optional<glm::dvec3> operator()(const EnvironmentLight&) const { return std::nullopt; }
  template <class WithoutSize>
  std::optional<glm::dvec3> operator()(const WithoutSize&) const {
    return glm::dvec3(0.0);
  }
  std::optional<glm::dvec3> operator()(const Geometry& g) const { return std::visit(*this, g.shape); }
  std::optional<glm::dvec3> operator()(const Sphere& s) const { return glm::dvec3(s.radius); }
  std::optional<glm::dvec3> operator()(const Plane&) const { return std::nullopt; }
  std::optional<glm::dvec3> operator()(const Box& b) const { return 0.5 * b.size; }
  std::optional<glm::dvec3> operator()(const Rect& r) const {
    return glm::dvec3(0.5 * r.size.x, 0.0, 0.5 * r.size.y);
  }
  std::optional<glm::dvec3> operator()(const Disk& d) const { return glm::dvec3(d.radius, 0.0, d.radius); }
  std::optional<glm::dvec3> operator()(const Cylinder& c) const {
    return glm::dvec3(c.radius, 0.5 * c.height, c.radius);
  }
  std::optional<glm::dvec3> operator()(const MeshShape& s) const {
    return 0.5 * (glm::dvec3(s.mesh->boxMax) - glm::dvec3(s.mesh->boxMin));
  }
};

/// Where the half extents are measured from, in the object's coordinates.
glm::dvec3 localCenter(const Object& object) {
  const auto* geometry = std::get_if<Geometry>(&object.content);
  const auto* shape = geometry ? std::get_if<MeshShape>(&geometry->shape) : nullptr;
  return shape ? 0.5 * (glm::dvec3(shape->mesh->boxMin) + glm::dvec3(shape->mesh->boxMax)) : glm::dvec3(0.0);
}

}  // namespace

std::optional<Bounds> boundsOf(const Scene& scene, const std::set<Id>* objects) {
  std::optional<Bounds> all;
  const std::vector<glm::dmat4> worlds = worldTransforms(scene);
  const std::vector<bool> visible = hierarchyVisibility(scene);
  for (std::size_t index = 0; index < scene.objects.size(); ++index) {
    const Object& object = scene.objects[index];
    if (objects ? !objects->contains(object.id) : !visible[index]) continue;
    const std::optional<glm::dvec3> half = std::visit(HalfExtent{}, object.content);
    if (!half) continue;
    const glm::dmat4& world = worlds[index];
    const glm::dvec3 center(world * glm::dvec4(localCenter(object), 1.0));
    // |M| times the half extents bounds the transformed box (Arvo 1990).
    glm::dvec3 reach(0.0);
    for (int i = 0; i < 3; ++i) reach += glm::abs(glm::dvec3(world[i])) * (*half)[i];
    if (!all) all = Bounds{center - reach, center + reach};
    all->min = glm::min(all->min, center - reach);
    all->max = glm::max(all->max, center + reach);
  }
  return all;
}

}  // namespace steradian
