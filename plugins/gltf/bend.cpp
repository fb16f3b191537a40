// SPDX-License-Identifier: MIT
// Morph targets and skins: vertices as they stand at one time.
#include <cmath>

#include "mesh.hpp"
#include "views.hpp"

namespace gltf {

namespace {

/// Adds weight * displacement of one attribute, where the target has it.
template <class Vector>
void displace(const Document& document, const std::map<std::string, int>& target, const char* name,
              double weight, std::vector<Vector>& values) {
  const auto found = target.find(name);
  if (found == target.end() || values.empty()) return;
  const Numbers numbers = readNumbers(document, found->second, {name, 3, 3, values.size()});
  demandFinite(numbers, found->second, name);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int c = 0; c < 3; ++c)
      values[i][c] += float(weight * double(numbers.values[i * 3 + std::size_t(c)]));
}

struct Influences {
  std::vector<std::uint32_t> joints;  // 4 per vertex
  Numbers weights;                    // 4 per vertex
};

std::vector<Influences> readInfluences(const Document& document, const tinygltf::Primitive& primitive,
                                       std::size_t vertices, std::size_t jointCount) {
  std::vector<Influences> sets;
  for (int set = 0;; ++set) {
    const auto joints = primitive.attributes.find("JOINTS_" + std::to_string(set));
    const auto weights = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
    if (joints == primitive.attributes.end() || weights == primitive.attributes.end()) return sets;
    Influences& each = sets.emplace_back();
    each.joints = readIntegers(document, joints->second, {joints->first, 4, 4, vertices});
    each.weights = readNumbers(document, weights->second, {weights->first, 4, 4, vertices});
    demandFinite(each.weights, weights->second, weights->first);
    for (std::size_t i = 0; i < each.joints.size(); ++i)
      if (each.joints[i] >= jointCount && each.weights.values[i] != 0.0f)
        throw sdk::BadInput(at("accessors", std::size_t(joints->second)) + ": expected joints below " +
                            std::to_string(jointCount) + ", got " + std::to_string(each.joints[i]));
  }
}

/// What carries normals along with `m`: its cofactors, with the sign that keeps them outward under a mirror.
glm::dmat3 normalMatrix(const glm::dmat3& m) {
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0 ? -cofactors : cofactors;
}

}  // namespace

void morph(const Document& document, const tinygltf::Primitive& primitive, const std::string& place,
           const std::vector<double>& weights, Triangles& out) {
  for (std::size_t i = 0; i < primitive.targets.size() && i < weights.size(); ++i) {
    if (weights[i] == 0) continue;
    document.demand(at(place + ".targets", i));
    displace(document, primitive.targets[i], "POSITION", weights[i], out.positions);
    displace(document, primitive.targets[i], "NORMAL", weights[i], out.normals);
    displace(document, primitive.targets[i], "TANGENT", weights[i], out.tangents);
  }
}

void skin(const Document& document, const tinygltf::Primitive& primitive,
          const std::vector<glm::dmat4>& joints, Triangles& out) {
  if (joints.empty()) return;
  const auto sets = readInfluences(document, primitive, out.positions.size(), joints.size());
  if (sets.empty()) throw sdk::BadInput("has a skin, but no JOINTS_0 and WEIGHTS_0");
  for (std::size_t v = 0; v < out.positions.size(); ++v) {
    glm::dmat4 matrix(0.0);
    double total = 0;
    for (const Influences& set : sets)
      for (std::size_t k = v * 4; k < v * 4 + 4; ++k) {
        const double weight = set.weights.values[k];
        if (weight == 0) continue;
        matrix += weight * joints[set.joints[k]];
        total += weight;
      }
    if (!(total > 1e-6))
      throw sdk::BadInput("vertex " + std::to_string(v) + " has joint weights that sum to 0");
    matrix /= total;
    out.positions[v] = glm::vec3(matrix * glm::dvec4(out.positions[v], 1.0));
    if (!out.normals.empty()) {
      const glm::dvec3 n = normalMatrix(glm::dmat3(matrix)) * glm::dvec3(out.normals[v]);
      const double length = glm::length(n);
      out.normals[v] = length > 0 ? glm::vec3(n / length) : glm::vec3(0.0f);
    }
    if (!out.tangents.empty()) {
      const glm::dvec3 t = glm::dmat3(matrix) * glm::dvec3(out.tangents[v]);
      const double length = glm::length(t);
      out.tangents[v] = glm::vec4(length > 0 ? glm::vec3(t / length) : glm::vec3(0.0f), out.tangents[v].w);
    }
  }
}

std::vector<glm::dmat4> jointsOf(const Document& document, std::size_t index, const Pose& pose) {
  document.demand(at("skins", index));
  const tinygltf::Skin& skin = document.model.skins[index];
  if (skin.joints.empty()) throw sdk::BadInput(at("skins", index) + ".joints: expected at least one");
  std::vector<glm::dmat4> out;
  for (const int joint : skin.joints) out.push_back(pose.world[std::size_t(joint)]);
  if (skin.inverseBindMatrices < 0) return out;
  const Numbers inverse = readNumbers(document, skin.inverseBindMatrices, {"inverse bind matrices", 16, 16});
  demandFinite(inverse, skin.inverseBindMatrices, "inverse bind matrices");
  if (inverse.count() < out.size())
    throw sdk::BadInput(at("accessors", std::size_t(skin.inverseBindMatrices)) +
                        ".count: expected at least the " + std::to_string(out.size()) + " joints, got " +
                        std::to_string(inverse.count()));
  for (std::size_t j = 0; j < out.size(); ++j) {
    glm::dmat4 matrix;
    for (std::size_t i = 0; i < 16; ++i) matrix[int(i / 4)][int(i % 4)] = double(inverse.values[j * 16 + i]);
    out[j] = out[j] * matrix;
  }
  return out;
}

}  // namespace gltf
