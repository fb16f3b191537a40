// SPDX-License-Identifier: MIT
// The table behind schema.hpp: one line per place in a glTF file.
#pragma once
#include <cstdint>

namespace gltf {

enum class Kind { object, text, flag, whole, number, numbers, index, word };

struct Rule {
  const char* path;  // "a[].b": b of every element of a; "a.*": every member of a
  Kind kind;
  double low = 0, high = 0;       // whole, number, numbers: of the value
  const char* among = "";         // index: the list it counts into; word: the words there are
  int shortest = 0, longest = 0;  // numbers: how many; 0 = any
  bool required = false;
  int step = 1;  // whole: a multiple of it
};

inline constexpr double kAll = 3.4e38, k53 = 9007199254740992.0, k64 = 18446744073709549568.0,
                        k31 = 2147483647.0;
inline constexpr double kFew = 1e12;  // as for all lengths of a scene
inline constexpr const char* kLights = "extensions.KHR_lights_punctual.lights";

// What a texture info and its transform may hold, at the place P.
#define STERADIAN_GLTF_TEXTURE(P)                                                         \
  {P, Kind::object}, {P ".index", Kind::index, 0, 0, "textures", 0, 0, true},             \
      {P ".texCoord", Kind::whole, 0, 1000},                                              \
      {P ".extensions.KHR_texture_transform.offset", Kind::numbers, -1e5, 1e5, "", 2, 2}, \
      {P ".extensions.KHR_texture_transform.scale", Kind::numbers, -1e5, 1e5, "", 2, 2},  \
      {P ".extensions.KHR_texture_transform.rotation", Kind::number, -1e5, 1e5}, {        \
    P ".extensions.KHR_texture_transform.texCoord", Kind::whole, 0, 1000                  \
  }

inline constexpr Rule kRules[] = {
    {"asset", Kind::object, 0, 0, "", 0, 0, true},
    {"asset.version", Kind::text, 0, 0, "", 0, 0, true},
    {"asset.minVersion", Kind::text},
    {"extensionsUsed[]", Kind::text},
    {"extensionsRequired[]", Kind::text},
    {"scene", Kind::index, 0, 0, "scenes"},

    {"buffers[]", Kind::object},
    {"buffers[].uri", Kind::text},
    {"buffers[].byteLength", Kind::whole, 1, k53, "", 0, 0, true},

    {"bufferViews[]", Kind::object},
    {"bufferViews[].buffer", Kind::index, 0, 0, "buffers", 0, 0, true},
    {"bufferViews[].byteOffset", Kind::whole, 0, k64},
    {"bufferViews[].byteLength", Kind::whole, 1, k64, "", 0, 0, true},
    {"bufferViews[].byteStride", Kind::whole, 4, 252, "", 0, 0, false, 4},
    {"bufferViews[].extensions.EXT_meshopt_compression.buffer", Kind::index, 0, 0, "buffers", 0, 0, true},
    {"bufferViews[].extensions.EXT_meshopt_compression.byteOffset", Kind::whole, 0, k64},
    {"bufferViews[].extensions.EXT_meshopt_compression.byteLength", Kind::whole, 1, k64, "", 0, 0, true},
    {"bufferViews[].extensions.EXT_meshopt_compression.byteStride", Kind::whole, 2, 256, "", 0, 0, true},
    {"bufferViews[].extensions.EXT_meshopt_compression.count", Kind::whole, 1, k53, "", 0, 0, true},
    {"bufferViews[].extensions.EXT_meshopt_compression.mode", Kind::word, 0, 0,
     " ATTRIBUTES TRIANGLES INDICES ", 0, 0, true},
    {"bufferViews[].extensions.EXT_meshopt_compression.filter", Kind::word, 0, 0,
     " NONE OCTAHEDRAL QUATERNION EXPONENTIAL "},

    {"accessors[]", Kind::object},
    {"accessors[].bufferView", Kind::index, 0, 0, "bufferViews"},
    {"accessors[].byteOffset", Kind::whole, 0, k64},
    {"accessors[].componentType", Kind::whole, 5120, 5126, "", 0, 0, true},
    {"accessors[].normalized", Kind::flag},
    {"accessors[].count", Kind::whole, 1, k64, "", 0, 0, true},
    {"accessors[].type", Kind::word, 0, 0, " SCALAR VEC2 VEC3 VEC4 MAT2 MAT3 MAT4 ", 0, 0, true},
    {"accessors[].sparse", Kind::object},
    {"accessors[].sparse.count", Kind::whole, 1, k31, "", 0, 0, true},
    {"accessors[].sparse.indices", Kind::object, 0, 0, "", 0, 0, true},
    {"accessors[].sparse.indices.bufferView", Kind::index, 0, 0, "bufferViews", 0, 0, true},
    {"accessors[].sparse.indices.byteOffset", Kind::whole, 0, k31},
    {"accessors[].sparse.indices.componentType", Kind::whole, 5121, 5125, "", 0, 0, true},
    {"accessors[].sparse.values", Kind::object, 0, 0, "", 0, 0, true},
    {"accessors[].sparse.values.bufferView", Kind::index, 0, 0, "bufferViews", 0, 0, true},
    {"accessors[].sparse.values.byteOffset", Kind::whole, 0, k31},

    {"meshes[]", Kind::object},
    {"meshes[].name", Kind::text},
    {"meshes[].weights", Kind::numbers, -kAll, kAll},
    {"meshes[].primitives[]", Kind::object},
    {"meshes[].primitives[].attributes", Kind::object, 0, 0, "", 0, 0, true},
    {"meshes[].primitives[].attributes.*", Kind::index, 0, 0, "accessors"},
    {"meshes[].primitives[].indices", Kind::index, 0, 0, "accessors"},
    {"meshes[].primitives[].material", Kind::index, 0, 0, "materials"},
    {"meshes[].primitives[].mode", Kind::whole, 0, 6},
    {"meshes[].primitives[].targets[]", Kind::object},
    {"meshes[].primitives[].targets[].*", Kind::index, 0, 0, "accessors"},
    {"meshes[].primitives[].extensions.KHR_draco_mesh_compression.bufferView", Kind::index, 0, 0,
     "bufferViews", 0, 0, true},
    {"meshes[].primitives[].extensions.KHR_draco_mesh_compression.attributes", Kind::object, 0, 0, "", 0, 0,
     true},
    {"meshes[].primitives[].extensions.KHR_draco_mesh_compression.attributes.*", Kind::whole, 0, k31},

    {"nodes[]", Kind::object},
    {"nodes[].name", Kind::text},
    {"nodes[].children[]", Kind::index, 0, 0, "nodes"},
    {"nodes[].mesh", Kind::index, 0, 0, "meshes"},
    {"nodes[].skin", Kind::index, 0, 0, "skins"},
    {"nodes[].camera", Kind::index, 0, 0, "cameras"},
    {"nodes[].matrix", Kind::numbers, -kFew / 2, kFew / 2, "", 16, 16},
    {"nodes[].translation", Kind::numbers, -kFew, kFew, "", 3, 3},
    {"nodes[].rotation", Kind::numbers, -2, 2, "", 4, 4},
    {"nodes[].scale", Kind::numbers, -kFew, kFew, "", 3, 3},
    {"nodes[].weights", Kind::numbers, -kAll, kAll},
    {"nodes[].extensions.KHR_lights_punctual.light", Kind::index, 0, 0, kLights},

    {"scenes[]", Kind::object},
    {"scenes[].name", Kind::text},
    {"scenes[].nodes[]", Kind::index, 0, 0, "nodes"},

    {"materials[]", Kind::object},
    {"materials[].name", Kind::text},
    {"materials[].pbrMetallicRoughness", Kind::object},
    {"materials[].pbrMetallicRoughness.baseColorFactor", Kind::numbers, 0, 1, "", 4, 4},
    {"materials[].pbrMetallicRoughness.metallicFactor", Kind::number, 0, 1},
    {"materials[].pbrMetallicRoughness.roughnessFactor", Kind::number, 0, 1},
    STERADIAN_GLTF_TEXTURE("materials[].pbrMetallicRoughness.baseColorTexture"),
    STERADIAN_GLTF_TEXTURE("materials[].pbrMetallicRoughness.metallicRoughnessTexture"),
    STERADIAN_GLTF_TEXTURE("materials[].normalTexture"),
    STERADIAN_GLTF_TEXTURE("materials[].occlusionTexture"),
    STERADIAN_GLTF_TEXTURE("materials[].emissiveTexture"),
    {"materials[].normalTexture.scale", Kind::number, -100, 100},
    {"materials[].occlusionTexture.strength", Kind::number, 0, 1},
    {"materials[].emissiveFactor", Kind::numbers, 0, kFew, "", 3, 3},
    {"materials[].alphaMode", Kind::word, 0, 0, " OPAQUE MASK BLEND "},
    {"materials[].alphaCutoff", Kind::number, 0, kAll},
    {"materials[].doubleSided", Kind::flag},
    {"materials[].extensions.KHR_materials_emissive_strength.emissiveStrength", Kind::number, 0, kFew},
    {"materials[].extensions.KHR_materials_ior.ior", Kind::number, 0, 1000},
    {"materials[].extensions.KHR_materials_transmission.transmissionFactor", Kind::number, 0, 1},
    {"materials[].extensions.KHR_materials_volume.thicknessFactor", Kind::number, 0, kAll},
    {"materials[].extensions.KHR_materials_volume.attenuationDistance", Kind::number, 0, kAll},
    {"materials[].extensions.KHR_materials_volume.attenuationColor", Kind::numbers, 0, 1, "", 3, 3},
    {"materials[].extensions.KHR_materials_clearcoat.clearcoatFactor", Kind::number, 0, 1},
    {"materials[].extensions.KHR_materials_clearcoat.clearcoatRoughnessFactor", Kind::number, 0, 1},
    {"materials[].extensions.KHR_materials_specular.specularFactor", Kind::number, 0, 1},
    {"materials[].extensions.KHR_materials_specular.specularColorFactor", Kind::numbers, 0, kAll, "", 3, 3},
    {"materials[].extensions.KHR_materials_sheen.sheenColorFactor", Kind::numbers, 0, 1, "", 3, 3},
    {"materials[].extensions.KHR_materials_sheen.sheenRoughnessFactor", Kind::number, 0, 1},

    {"textures[]", Kind::object},
    {"textures[].source", Kind::index, 0, 0, "images"},
    {"textures[].sampler", Kind::index, 0, 0, "samplers"},
    {"samplers[]", Kind::object},
    {"samplers[].magFilter", Kind::whole, 9728, 9729},
    {"samplers[].minFilter", Kind::whole, 9728, 9987},
    {"samplers[].wrapS", Kind::whole, 10497, 33648},
    {"samplers[].wrapT", Kind::whole, 10497, 33648},
    {"images[]", Kind::object},
    {"images[].name", Kind::text},
    {"images[].uri", Kind::text},
    {"images[].bufferView", Kind::index, 0, 0, "bufferViews"},

    {"skins[]", Kind::object},
    {"skins[].joints[]", Kind::index, 0, 0, "nodes"},
    {"skins[].inverseBindMatrices", Kind::index, 0, 0, "accessors"},

    {"cameras[]", Kind::object},
    {"cameras[].name", Kind::text},
    {"cameras[].type", Kind::word, 0, 0, " perspective orthographic ", 0, 0, true},
    {"cameras[].perspective", Kind::object},
    {"cameras[].orthographic", Kind::object},
    {"cameras[].perspective.yfov", Kind::number, 1e-6, 3.141592, "", 0, 0, true},
    {"cameras[].perspective.aspectRatio", Kind::number, 1e-6, 1e6},
    {"cameras[].perspective.znear", Kind::number, 0, kAll, "", 0, 0, true},
    {"cameras[].perspective.zfar", Kind::number, 0, kAll},
    {"cameras[].orthographic.xmag", Kind::number, -kFew, kFew, "", 0, 0, true},
    {"cameras[].orthographic.ymag", Kind::number, -kFew, kFew, "", 0, 0, true},
    {"cameras[].orthographic.znear", Kind::number, -kAll, kAll, "", 0, 0, true},
    {"cameras[].orthographic.zfar", Kind::number, -kAll, kAll, "", 0, 0, true},

    {"animations[]", Kind::object},
    {"animations[].name", Kind::text},
    {"animations[].channels[]", Kind::object},
    {"animations[].channels[].sampler", Kind::whole, 0, k31, "", 0, 0, true},
    {"animations[].channels[].target", Kind::object, 0, 0, "", 0, 0, true},
    {"animations[].channels[].target.node", Kind::index, 0, 0, "nodes"},
    {"animations[].channels[].target.path", Kind::text, 0, 0, "", 0, 0, true},
    {"animations[].samplers[]", Kind::object},
    {"animations[].samplers[].input", Kind::index, 0, 0, "accessors", 0, 0, true},
    {"animations[].samplers[].output", Kind::index, 0, 0, "accessors", 0, 0, true},
    {"animations[].samplers[].interpolation", Kind::word, 0, 0, " LINEAR STEP CUBICSPLINE "},

    {"extensions.KHR_lights_punctual.lights[]", Kind::object},
    {"extensions.KHR_lights_punctual.lights[].type", Kind::word, 0, 0, " point spot directional ", 0, 0,
     true},
    {"extensions.KHR_lights_punctual.lights[].name", Kind::text},
    {"extensions.KHR_lights_punctual.lights[].color", Kind::numbers, 0, kFew, "", 3, 3},
    {"extensions.KHR_lights_punctual.lights[].intensity", Kind::number, 0, kFew},
    {"extensions.KHR_lights_punctual.lights[].range", Kind::number, 0, kAll},
    {"extensions.KHR_lights_punctual.lights[].spot", Kind::object},
    {"extensions.KHR_lights_punctual.lights[].spot.innerConeAngle", Kind::number, 0, 1.5708},
    {"extensions.KHR_lights_punctual.lights[].spot.outerConeAngle", Kind::number, 0, 1.5708},
};
#undef STERADIAN_GLTF_TEXTURE

/// Elements that may be left out without harm to the rest, and what stands in for them.
struct Optional {
  const char* path;
  const char* standIn;
};
inline constexpr Optional kOptional[] = {
    {"accessors[]", R"({"componentType": 5126, "count": 1, "type": "SCALAR"})"},
    {"bufferViews[]", R"({"buffer": 0, "byteLength": 1})"},
    {"meshes[].primitives[]", R"({"attributes": {}})"},
    {"materials[]", "{}"},
    {"textures[]", "{}"},
    {"samplers[]", "{}"},
    {"images[]", "{}"},
    {"skins[]", R"({"joints": []})"},
    {"cameras[]", R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 1}})"},
    {"animations[].channels[]", R"({"sampler": 0, "target": {"node": 0, "path": "none"}})"},
    {"animations[].samplers[]", R"({"input": 0, "output": 0})"},
    {"extensions.KHR_lights_punctual.lights[]", R"({"type": "point"})"},
};

}  // namespace gltf
