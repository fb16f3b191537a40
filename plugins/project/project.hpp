// SPDX-License-Identifier: MIT
// The two halves of the project file plugin, and the names that both use.
#pragma once
#include <steradian/plugin.hpp>
#include <string_view>

namespace project {

/// Version 2 added meshes, textures and what materials have for them; a scene without them is still written
/// as 1.
inline constexpr std::uint32_t kVersion = 2;

inline constexpr const char* kFilters[] = {"box", "blackmanHarris"};
inline constexpr const char* kTransfers[] = {"srgb", "gamma"};
inline constexpr const char* kProperties[] = {"translation", "rotation", "scale", "lightIntensity",
                                              "lightColor"};
inline constexpr std::size_t kPropertySizes[] = {3, 4, 3, 1, 3};  // numbers of a key's value
inline constexpr const char* kInterpolations[] = {"step", "linear", "cubic"};
inline constexpr const char* kContents[] = {
    "group",  "sphere",      "plane",      "box",       "rect",
    "disk",   "cylinder",    "pointLight", "spotLight", "directionalLight",
    "camera", "sphereLight", "rectLight",  "diskLight", "environmentLight",
    "mesh"};
inline constexpr const char* kAlphaModes[] = {"opaque", "mask", "blend"};
inline constexpr const char* kWraps[] = {"repeat", "clamp", "mirror"};
inline constexpr const char* kProjections[] = {"perspective", "orthographic"};

/// What an object of this kind has where the file says nothing.
inline steradian::sdk::ObjectRecord usualOf(steradian::sdk::ObjectKind kind) {
  using steradian::sdk::ObjectKind;
  steradian::sdk::ObjectRecord usual{.kind = kind};
  if (kind == ObjectKind::sphereLight) usual.radius = 0.25;
  if (kind == ObjectKind::diskLight) usual.radius = 0.5;
  if (kind == ObjectKind::rectLight) usual.dimensions[0] = usual.dimensions[1] = 1;
  return usual;
}

/// Throws BadInput with place, what was expected and what was found.
void readProject(steradian::sdk::Host& host, std::string_view bytes, steradian::sdk::SceneSink& sink);
void writeProject(steradian::sdk::Host& host, steradian::sdk::SceneView& view,
                  steradian::sdk::Writer& writer);

}  // namespace project
