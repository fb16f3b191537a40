// SPDX-License-Identifier: MIT
// The rules of a sound mesh.
#include "renderer/scene/mesh.hpp"

#include <cmath>

#include "renderer/scene/validate_detail.hpp"

namespace steradian {
namespace {

template <class Vector>
bool finite(const std::vector<Vector>& values) {
  for (const Vector& v : values)
    for (int i = 0; i < Vector::length(); ++i)
      if (!(std::abs(v[i]) <= kLargest)) return false;
  return true;
}

template <class Vector>
std::string problemOfAttribute(const char* name, const std::vector<Vector>& values, std::size_t vertices) {
  if (!values.empty() && values.size() != vertices)
    return "has " + std::to_string(values.size()) + " " + name + " for " + std::to_string(vertices) +
           " vertices; expected one each or none";
  if (!finite(values))
    return std::string("has ") + name +
           " that are infinite, not a number or beyond 1e12; expected finite ones";
  return {};
}

}  // namespace

std::string problemOf(const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner)
      if (mesh.triangles[i][corner] >= vertices)
        return "has index " + std::to_string(mesh.triangles[i][corner]) + " in triangle " +
               std::to_string(i) + "; expected less than the " + std::to_string(vertices) + " vertices";
  for (const std::string& problem :
       {problemOfAttribute("positions", mesh.positions, vertices),
        problemOfAttribute("normals", mesh.normals, vertices),
        problemOfAttribute("tangents", mesh.tangents, vertices),
        problemOfAttribute("uv0", mesh.uv0, vertices), problemOfAttribute("uv1", mesh.uv1, vertices),
        problemOfAttribute("colors", mesh.colors, vertices)})
    if (!problem.empty()) return problem;
  return {};
}

std::shared_ptr<const Mesh> sharedMesh(Mesh mesh) {
  if (!mesh.positions.empty()) mesh.boxMin = mesh.boxMax = mesh.positions[0];
  for (const glm::vec3& p : mesh.positions) {
    mesh.boxMin = glm::min(mesh.boxMin, p);
    mesh.boxMax = glm::max(mesh.boxMax, p);
  }
  return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace steradian
