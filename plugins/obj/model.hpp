// SPDX-License-Identifier: MIT
// What an OBJ file and its material libraries hold, before triangles are made of it.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lines.hpp"

namespace obj {

/// Indices from 0; -1 = none.
struct Corner {
  std::int32_t position, uv, normal;
};

struct Face {
  std::size_t first, count;  // corners of the model
};

/// The faces of one group and one material, wherever they stand in the file.
struct Part {
  std::string name, material;
  std::vector<Face> faces;
};

using Vec3 = std::array<float, 3>;

struct Model {
  std::vector<Vec3> positions;
  std::vector<Vec3> colors;  // linear; as many as positions, or none
  std::vector<std::array<float, 2>> uvs;
  std::vector<Vec3> normals;
  std::vector<Corner> corners;
  std::vector<Part> parts;
  std::vector<std::string> libraries;
  bool smoothingGroups = false;
  std::map<std::string, std::size_t> leftOut;  // statements that are not rendered, and how many
};

/// Every index of the result is in range. Throws BadInput naming the line.
Model parseModel(steradian::sdk::Host& host, std::string_view bytes);

/// Pushes meshes, materials, textures and objects.
void build(steradian::sdk::Host& host, Model& model, const std::string& name,
           steradian::sdk::SceneSink& sink);

}  // namespace obj
