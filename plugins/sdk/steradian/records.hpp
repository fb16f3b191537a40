// SPDX-License-Identifier: MIT
// Plain records that cross the plugin border: what a scene consists of.
// Every record begins with its byte size and only ever grows at its end, so old and new sides understand each
// other. Text and arrays belong to the side that fills the record and stay valid during the call they are
// part of. Axes and units as glTF: right-handed, Y up, metres, radians, photometric SI, linear Rec. 709.
#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace steradian::sdk {

inline constexpr std::uint32_t kMagic = 0x53545244;  // "STRD"
inline constexpr std::uint32_t kMajor = 1;           // a host loads exactly its own major ...
inline constexpr std::uint32_t kMinor = 2;           // ... and every minor up to its own

enum class Status : std::uint32_t { ok = 0, badInput = 1, failed = 2, cancelled = 3 };

/// UTF-8 with a length; need not end in a zero byte. Never owns.
struct Text {
  const char* data = "";
  std::uint64_t size = 0;

  constexpr Text() = default;
  constexpr Text(const char* text) : data(text), size(std::char_traits<char>::length(text)) {}
  constexpr Text(std::string_view text) : data(text.data()), size(text.size()) {}
  Text(const std::string& text) : data(text.data()), size(text.size()) {}
  constexpr std::string_view view() const { return size ? std::string_view(data, size) : std::string_view(); }
  std::string str() const { return std::string(view()); }
};

enum class ObjectKind : std::uint32_t {
  group = 0,
  sphere = 1,
  plane = 2,
  box = 3,
  rect = 4,
  disk = 5,
  cylinder = 6,
  pointLight = 7,
  spotLight = 8,
  directionalLight = 9,
  camera = 10,
  // since 1.1
  sphereLight = 11,
  rectLight = 12,
  diskLight = 13,
  environmentLight = 14,
  // since 1.2
  mesh = 15
};

/// One node of the scene. Fields that its kind does not name are ignored.
struct ObjectRecord {
  std::uint32_t size = sizeof(ObjectRecord);
  std::uint32_t id = 0;      // > 0, unique over objects and materials
  std::uint32_t parent = 0;  // object id; 0 = none. Parents may follow children.
  ObjectKind kind = ObjectKind::group;
  std::uint32_t visible = 1;   // 0 hides its children too
  std::uint32_t material = 0;  // shapes: material id; 0 = the default material
  Text name = {};
  Text extras = {};  // keys that only a file format knows, a JSON object or empty; handed back to exporters
  double translation[3] = {0, 0, 0};  // metres; parentFromLocal = T * R * S
  double rotation[4] = {0, 0, 0, 1};  // unit quaternion x, y, z, w
  double scale[3] = {1, 1, 1};        // not 0
  double radius = 1;                  // sphere, disk, cylinder; sphere and disk light
  double height = 2;                  // cylinder
  double dimensions[3] = {2, 2, 2};  // box: full edge lengths; rect: x and z in [0] and [1]; rect light: x, y
  double fovY = 0.7853982;           // camera: full vertical angle
  float color[3] = {1, 1, 1};        // lights, >= 0
  float intensity = 10;              // lights: cd (point, spot), lx (directional), nit (the others)
  float innerConeAngle = 0;          // spot: half angle of full intensity
  float outerConeAngle = 0.7853982f;  // spot: half angle where it ends
  // since 1.1
  Text imageFile = {};            // environment: relative to the project's folder; empty = none
  double orthographicHeight = 2;  // camera: full height of the view in metres
  double fNumber = 0;             // camera: focal length / aperture diameter; 0 = pinhole
  double focusDistance = 5;       // camera: metres along the view axis
  std::uint32_t projection = 0;   // camera: 0 perspective, 1 orthographic
  float temperature = 0;          // lights: kelvin, 1000..40000; 0 = off
  float angularDiameter = 0;      // directional: radians
  float horizon[3] = {1, 1, 1};   // environment: factors of its colour; the zenith has 1
  float ground[3] = {1, 1, 1};
  std::uint32_t mesh = 0;  // since 1.2: mesh id; 1.1 left 0 here to keep the end free of padding
};
static_assert(sizeof(ObjectRecord) == 288);

/// Triangles with attributes that are one per vertex, or absent (null). Counter-clockwise faces outward.
struct MeshRecord {
  std::uint32_t size = sizeof(MeshRecord);
  std::uint32_t id = 0;  // > 0, unique over meshes
  Text name = {};
  std::uint64_t vertexCount = 0;
  std::uint64_t triangleCount = 0;
  const float* positions = nullptr;          // 3 per vertex, metres
  const std::uint32_t* triangles = nullptr;  // 3 vertex indices per triangle
  const float* normals = nullptr;            // 3, unit; absent = flat facets
  const float* tangents = nullptr;           // 4: unit xyz along +u, w = sign of cross(normal, tangent)
  const float* uv0 = nullptr;                // 2; (0, 0) = top left of a texture
  const float* uv1 = nullptr;                // 2
  const float* colors = nullptr;             // 4: linear RGBA in [0, 1]
};

/// An image for materials: a file beside the project, or the bytes of one (PNG, JPEG, HDR, EXR).
struct TextureRecord {
  std::uint32_t size = sizeof(TextureRecord);
  std::uint32_t id = 0;  // > 0, unique over textures
  Text name = {};
  Text file = {};  // relative to the imported file's folder; empty = bytes
  const void* bytes = nullptr;
  std::uint64_t byteCount = 0;
};

/// A texture in one place of a material. Part of a record: never grows.
struct TextureSlotRecord {
  std::uint32_t texture = 0;                // id; 0 = none
  std::uint32_t uvSet = 0;                  // 0 or 1
  std::uint32_t wrapU = 0, wrapV = 0;       // 0 repeat, 1 clamp, 2 mirror
  std::uint32_t nearest = 0;                // 1: texels as blocks
  float transform[6] = {1, 0, 0, 0, 1, 0};  // textureU = [0] u + [1] v + [2], textureV = [3] u + [4] v + [5]
};

/// glTF 2.0 metallic-roughness with KHR_materials_specular's weight.
struct MaterialRecord {
  std::uint32_t size = sizeof(MaterialRecord);
  std::uint32_t id = 0;  // > 0, unique over objects and materials
  Text name = {};
  Text extras = {};  // as in ObjectRecord
  float albedo[3] = {0.8f, 0.8f, 0.8f};
  float metallic = 0;
  float roughness = 0.5f;  // perceptual; alpha = roughness^2
  float specular = 1;      // weight of the dielectric lobe; 0 = pure Lambert
  float ior = 1.5f;        // >= 1
  float emissionColor[3] = {1, 1, 1};
  float emissionLuminance = 0;  // nit
  // since 1.1
  std::uint32_t reserved = 0;             // was padding in 1.0, where old plugins leave anything
  float transmission = 0;                 // share of the dielectric base
  float attenuationColor[3] = {1, 1, 1};  // left of white light after attenuationDistance, (0, 1]
  float attenuationDistance = 0;          // metres; 0 = clear
  float clearcoat = 0;
  float clearcoatRoughness = 0;
  float edgeTint[3] = {1, 1, 1};  // metals: reflectance at 82 degrees beside Schlick's
  // since 1.2: on meshes only
  TextureSlotRecord albedoTexture;             // sRGB; RGB times albedo, A times opacity
  TextureSlotRecord metallicRoughnessTexture;  // G times roughness, B times metallic
  TextureSlotRecord normalTexture;             // tangent space, x and y times normalScale
  TextureSlotRecord emissionTexture;           // sRGB; RGB times emissionColor
  float normalScale = 1;
  float opacity = 1;
  std::uint32_t alphaMode = 0;   // 0 opaque, 1 mask, 2 blend
  float alphaCutoff = 0.5f;      // mask: opaque from here on
  std::uint32_t thinWalled = 0;  // 1: transmission through a sheet that encloses nothing
  std::uint32_t padding = 0;     // what comes next starts at its end
};
static_assert(sizeof(MaterialRecord) == 328);

struct RenderSettingsRecord {
  std::uint32_t size = sizeof(RenderSettingsRecord);
  std::int32_t width = 1280;  // pixels
  std::int32_t height = 720;
  std::int32_t maxBounces = 8;
  std::int32_t lightSamples = 8;
  std::uint32_t russianRoulette = 1;
  std::uint32_t errorMeter = 1;
  std::uint32_t filter = 1;  // 0 box, 1 Blackman-Harris
  std::uint32_t seed = 0;
  // since 1.1
  std::uint32_t energyCompensation = 1;
  float clamp = 0;  // most radiance of one sample beyond its first hit; 0 = off
};

/// One value of one parameter of a tonemapper. An array element: never grows.
struct ParameterValue {
  Text id = {};
  double value = 0;
};

struct DisplaySettingsRecord {
  std::uint32_t size = sizeof(DisplaySettingsRecord);
  float exposure = 0;  // stops
  Text tonemapper = "org.steradian.tonemap.khronos_pbr_neutral";
  std::uint32_t transfer = 0;  // 0 sRGB, 1 power law
  float gamma = 2.2f;
  const ParameterValue* parameters = nullptr;
  std::uint64_t parameterCount = 0;
  // since 1.1
  std::uint32_t physical = 0;  // 1: exposure by ev100, before the stops
  float ev100 = 0;             // exposure value at ISO 100
};

/// An array element: never grows.
struct Key {
  double time = 0;                 // seconds
  double value[4] = {0, 0, 0, 0};  // xyz; rotation: x, y, z, w; intensity: x
};

struct ChannelRecord {
  std::uint32_t size = sizeof(ChannelRecord);
  std::uint32_t target = 0;         // object id
  std::uint32_t property = 0;       // 0 translation, 1 rotation, 2 scale, 3 light intensity, 4 light colour
  std::uint32_t interpolation = 1;  // 0 step, 1 linear, 2 cubic
  const Key* keys = nullptr;        // strictly increasing times
  std::uint64_t keyCount = 0;
};

/// What belongs to the scene as a whole.
struct SceneRecord {
  std::uint32_t size = sizeof(SceneRecord);
  std::uint32_t activeCamera = 0;  // object id; 0 = the first camera
  std::uint32_t nextId = 0;        // 0 = the highest id + 1
  std::uint32_t reserved = 0;
  double framesPerSecond = 24;
  Text name = {};
  Text extras = {};  // as in ObjectRecord
};

enum class ParameterType : std::uint32_t { real = 0, integer = 1, boolean = 2 };

/// A parameter as data: the host draws it, stores it and offers it as `--param id=value`. An array element:
/// never grows.
struct ParameterInfo {
  Text id = {}, name = {}, unit = {}, help = {};
  ParameterType type = ParameterType::real;
  double defaultValue = 0, minimum = 0, maximum = 1;
};

/// What an importer or exporter is. Text and arrays live as long as the plugin is loaded (string literals
/// do).
struct FormatInfo {
  std::uint32_t size = sizeof(FormatInfo);
  Text id = {};                  // reverse domain, never changes: "org.steradian.exr"
  Text name = {};                // for people: "OpenEXR"
  Text version = {};             // of this plugin: "1.2.0"; the highest of one id wins
  Text extensions = {};          // lower case with dots, space between: ".jpg .jpeg"
  std::uint64_t maxBytes = 0;    // importers: larger files are refused before they are read; 0 = 4 GiB
  std::uint32_t takesImage = 0;  // exporters: 1 = images, 0 = scenes
  std::uint32_t parameterCount = 0;
  const ParameterInfo* parameters = nullptr;
};

/// The file to import: whole in memory, owned by the host, valid during the call.
struct SourceFile {
  std::uint32_t size = sizeof(SourceFile);
  Text path;  // for messages only
  const char* bytes = nullptr;
  std::uint64_t byteCount = 0;
};

/// A record as this side knows it: fields that the other side's version lacks keep their defaults.
template <class Record>
Record adopt(const Record& theirs) {
  Record ours;
  std::memcpy(static_cast<void*>(&ours), &theirs,
              theirs.size < sizeof(Record) ? theirs.size : sizeof(Record));
  ours.size = sizeof(Record);
  return ours;
}

}  // namespace steradian::sdk
