// SPDX-License-Identifier: MIT
// Material libraries (MTL): Phong's terms turned into metallic and roughness.
#pragma once
#include <deque>
#include <map>
#include <set>
#include <string>

#include "lines.hpp"

namespace obj {

/// Reads libraries, pushes their materials and textures, and finds them by name.
class Materials {
 public:
  Materials(steradian::sdk::Host& host, steradian::sdk::SceneSink& sink) : host_(host), sink_(sink) {}

  /// `names`: the rest of a mtllib line, one file with spaces or several files.
  void read(const std::string& names);
  /// The material's id, pushed into the sink at first use; 0 and a line in the report when there is none.
  std::uint32_t id(const std::string& name);
  std::uint32_t count() const { return nextId_ - 1; }

 private:
  /// A texture statement: options and file.
  struct Map {
    std::string file;
    float scale[2] = {1, 1}, offset[2] = {0, 0};
    float strength = 1;  // -bm
    bool clamp = false;
  };
  struct Phong {
    float diffuse[3] = {0.8f, 0.8f, 0.8f}, specular[3] = {0, 0, 0}, emission[3] = {0, 0, 0};
    float shininess = -1, roughness = -1, metallic = -1, opacity = 1, ior = 1.5f, clearcoat = 0,
          clearcoatRoughness = 0;
    int illumination = 2;
    std::map<std::string, Map> maps;  // by statement, lower case
  };

  void parse(const std::string& file, std::string_view bytes);
  void statement(Phong& material, std::string_view key, Words& words, std::size_t line);
  static Map mapOf(Words& words);
  void reflection(const Phong& phong, const std::string& where, steradian::sdk::MaterialRecord& out);
  void maps(const Phong& phong, const std::string& where, steradian::sdk::MaterialRecord& out);
  steradian::sdk::TextureSlotRecord slot(const Map& map, const std::string& where);
  std::uint32_t texture(const std::string& file, const std::string& where);

  steradian::sdk::Host& host_;
  steradian::sdk::SceneSink& sink_;
  std::map<std::string, Phong> known_;
  std::map<std::string, std::uint32_t> ids_, textures_;
  std::uint32_t nextId_ = 1;
};

}  // namespace obj
