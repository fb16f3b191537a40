// SPDX-License-Identifier: MIT
// Vertices and faces -> one mesh.
#pragma once
#include <array>
#include <steradian/polygon.hpp>

#include "elements.hpp"

namespace ply {

class Builder {
 public:
  explicit Builder(steradian::sdk::Host& host) : host_(host) {}

  /// Reads all elements; what is not rendered goes to the report. Throws BadInput.
  void read(const Header& header, Values& values);
  void push(steradian::sdk::SceneSink& sink) const;

 private:
  using Vec3 = std::array<float, 3>;

  void everyRow(const Element& element, Values& values, std::uint64_t row);
  void skip(const Element& element, Values& values);
  void vertices(const Element& element, Values& values);
  void put(std::uint64_t row, int role, std::size_t component, Type type, Values& values);
  void faces(const Element& element, Values& values);
  void face(const Property& list, Values& values);
  void completeNormals();

  steradian::sdk::Host& host_;
  std::vector<Vec3> positions_, normals_;
  std::vector<std::array<float, 2>> uvs_;
  std::vector<std::array<float, 4>> colors_;  // linear RGBA
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> corners_;  // of the face being read
  std::vector<Vec3> points_;
  steradian::sdk::Triangulator triangulate_;
  std::uint64_t tooSmall_ = 0;
};

}  // namespace ply
