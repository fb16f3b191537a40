// SPDX-License-Identifier: MIT
// Everything that C++ and GLSL both know of the data on the device, declared once.
//
// Scene data is a list of vec4 rows in one texel buffer, relative to the camera (origin = camera position):
//   camera (CAMERA_ROWS), filter table (FILTER_ROWS), spheres (1 row each), planes (1), large spheres (2),
//   boxes, rects, disks, cylinders, ellipsoids (3 each), mesh instances (7), texture references,
//   tables of rough glass (GLASS_ROWS per index of refraction), materials (8 per primitive),
//   object ids (1 per primitive), lights (4; suns first), light tree, environment (6), top level of the
//   hierarchy (over meshes, and shapes with TRACE_SHAPE_HIERARCHY).
// What rarely changes lies in a second texel buffer, the tables: ENERGY_ROWS of albedo tables, then the image
// of the environment with its sampling tables. Meshes lie in a third (their own coordinates, relative to
// their centre: nodes, triangles, vertices), texels in a fourth. Primitive indices follow the same order.
// Rows:
//   camera       right, lens radius (0 = pinhole) | up, focus distance | forward, 1 = parallel projection
//   filter       inverse CDF at i, step to i+1, -, -   (pixels from the pixel centre)
//   sphere       centre, radius
//   plane        unit normal, D = dot(point, normal)
//   large sphere centre high part, radius high part | centre low part, radius low part
//   affine shape rows of the 3x3 unitFromWorld, each with one component of the centre in w
//   instance     rows of the 3x3 meshFromWorld as for affine shapes | bits: first node row, first triangle
//   row,
//                first vertex row, MESH_* (rows of the mesh buffer) | rows of the 3x3 worldFromMesh, -
//   top level    TOP_LEVEL_ROWS per node, the root first: low corner of child A's box, bits: node or BVH_LEAF
//   and
//                the primitive | high corner, - | the same of child B   (rows count from topLevelRow)
// Rows of the mesh buffer: see renderer/mesh/bvh.hpp for nodes and triangles, whose coordinates are grid
// cells.
//   material     albedo, metallic | alpha = roughness^2, dielectric F0, dielectric F90, bits (FEATURE_*,
//   MATERIAL_*) |
//                emission (nit), bits: light that samples this primitive or NO_LIGHT |
//                transmission, ior, coat weight, coat alpha | absorption (1/m), bits: glass row | F82
//                coefficient, 1 / meanTransmittance() | bits: texture references of albedo,
//                metallic-roughness, normal, emission (rows; 0 = none) | normal scale, opacity, alpha cutoff,
//                - (one per primitive: a shared table would cost a dependent fetch at every vertex)
//   texture ref  bits: first word, width, height, TEXEL_* | transformX, - | transformY, -
//   object id    bits, -, -, -
//   point        position, kind | intensity (cd), - | - | -
//   spot         position, kind | intensity (cd), cone scale | axis, cone offset | -
//   directional  direction to the light, kind | illuminance (lx), 1 - cos(half angle) of its disc | - | -
//   sphere light centre, kind | radiance (nit), radius | - | -, bits: its primitive
//   rect light   centre, kind | radiance (nit), 1 = both sides | half edge U, - | half edge V, bits: its
//   primitive (front: cross(U, V)) disk light   centre, kind | radiance (nit), 1 = both sides | semi-axis U,
//   - | semi-axis V, bits: its primitive (front: cross(U, V))
//   mesh light   centre, kind | radiance (nit), 1 = both sides | half extent of its box, area (m^2) | bits:
//   row of its
//                first triangle, count of them, -, its primitive
//   solid light  as a mesh light, but bits: row of its affine shape in place of the first triangle
//   light tree   2 rows per node, 2 * lights - 1
//   nodes, the root first, siblings side by side; then 1 row per light:
//                centre, power (cd; lx for directional; of all lights 1) | squared near-field radius (-1 =
//                directional), bits: first child, or LIGHT_NODE_LEAF and the light, - | bits: which child at
//                each level, -
//   environment  zenith (nit), image columns (0 = gradient only) | horizon, image rows | ground,
//                1 = sampled | 3 rows of the rotation environmentFromWorld
#ifndef STERADIAN_GPU_TYPES_H
#define STERADIAN_GPU_TYPES_H

#ifdef __cplusplus
#include <cstdint>
namespace steradian::gpu {
using uint = std::uint32_t;
#define GPU_CONST inline constexpr
#else
#define GPU_CONST const
#endif

GPU_CONST uint CAMERA_ROWS = 4u;
GPU_CONST uint FILTER_ROWS = 256u;
GPU_CONST uint LARGE_SPHERE_ROWS = 2u;
GPU_CONST uint AFFINE_ROWS = 3u;
GPU_CONST uint INSTANCE_ROWS = 7u;
GPU_CONST uint MATERIAL_ROWS = 8u;
GPU_CONST uint TEXTURE_REF_ROWS = 3u;
GPU_CONST uint LIGHT_ROWS = 4u;
GPU_CONST uint LIGHT_NODE_ROWS = 2u;
GPU_CONST uint ENVIRONMENT_ROWS = 6u;

GPU_CONST uint LIGHT_POINT = 0u;
GPU_CONST uint LIGHT_SPOT = 1u;
GPU_CONST uint LIGHT_DIRECTIONAL = 2u;
GPU_CONST uint LIGHT_SPHERE = 3u;
GPU_CONST uint LIGHT_RECT = 4u;
GPU_CONST uint LIGHT_DISK = 5u;
GPU_CONST uint LIGHT_MESH = 6u;
GPU_CONST uint LIGHT_BOX = 7u;  // and the other solids
GPU_CONST uint LIGHT_CYLINDER = 8u;
GPU_CONST uint LIGHT_ELLIPSOID = 9u;

// Hierarchies: a link is a node's first row, or BVH_LEAF, count and first triangle; BVH_END closes the stack.
GPU_CONST uint BVH_NODE_ROWS = 2u;
GPU_CONST uint BVH_TRIANGLE_ROWS = 3u;
GPU_CONST uint BVH_LEAF = 1u << 31;
GPU_CONST uint BVH_COUNT_SHIFT = 27u;
GPU_CONST uint BVH_FIRST_MASK = (1u << 27) - 1u;
GPU_CONST uint BVH_NOTHING = BVH_LEAF;  // a leaf of 0
GPU_CONST uint BVH_END = 0xffffffffu;
GPU_CONST uint BVH_DEPTH = 32u;         // nodes on any way down, and room on the stack
GPU_CONST float BVH_ORIGIN = 32704.0f;  // cells from bound 0 to the middle of the mesh
GPU_CONST uint TOP_LEVEL_ROWS = 4u;
GPU_CONST uint TOP_LEVEL_DEPTH = 24u;

// What the vertices of a mesh carry (renderer/mesh/vertex_rows.hpp).
GPU_CONST uint MESH_NORMALS = 1u << 0;
GPU_CONST uint MESH_TANGENTS = 1u << 1;
GPU_CONST uint MESH_UV0 = 1u << 2;
GPU_CONST uint MESH_UV1 = 1u << 3;
GPU_CONST uint MESH_COLORS = 1u << 4;

// A texture in one place of a material: how its texels are stored and looked up (renderer/gpu_textures.hpp).
GPU_CONST uint TEXEL_RGBA8 = 0u;
GPU_CONST uint TEXEL_RGBA16 = 1u;
GPU_CONST uint TEXEL_HALF = 2u;
GPU_CONST uint TEXEL_FORMAT_MASK = 3u;
GPU_CONST uint TEXEL_SRGB = 1u << 2;
GPU_CONST uint TEXEL_NEAREST = 1u << 3;
GPU_CONST uint TEXEL_UV1 = 1u << 4;
GPU_CONST uint TEXEL_WRAP_U_SHIFT = 5u;  // 2 bits each: WRAP_*
GPU_CONST uint TEXEL_WRAP_V_SHIFT = 7u;
GPU_CONST uint TEXEL_LEVELS_SHIFT = 9u;  // number of mip levels
GPU_CONST uint WRAP_REPEAT = 0u;
GPU_CONST uint WRAP_CLAMP = 1u;
GPU_CONST uint WRAP_MIRROR = 2u;
// The words begin with what 8-bit sRGB codes mean in linear light, as floats; then, at TEXEL_SRGB16, 16-bit
// ones.
GPU_CONST uint TEXEL_SRGB16 = 256u;

GPU_CONST uint NO_PRIMITIVE = 0xffffffffu;
GPU_CONST uint NO_LIGHT = 0xffffffffu;
GPU_CONST uint MAX_LIGHT_SAMPLES = 16u;
GPU_CONST uint LIGHT_NODE_LEAF = 1u << 31;
GPU_CONST uint MAX_LIGHT_TREE_DEPTH = 24u;

// Feature bits: kinds that a scene may or may not hold. Bit i is specialization constant i.
GPU_CONST uint FEATURE_SPHERES = 1u << 0;
GPU_CONST uint FEATURE_PLANES = 1u << 1;
GPU_CONST uint FEATURE_LARGE_SPHERES = 1u << 2;
GPU_CONST uint FEATURE_BOXES = 1u << 3;
GPU_CONST uint FEATURE_RECTS = 1u << 4;
GPU_CONST uint FEATURE_DISKS = 1u << 5;
GPU_CONST uint FEATURE_CYLINDERS = 1u << 6;
GPU_CONST uint FEATURE_ELLIPSOIDS = 1u << 7;
GPU_CONST uint FEATURE_POINT_LIGHTS = 1u << 8;
GPU_CONST uint FEATURE_SPOT_LIGHTS = 1u << 9;
GPU_CONST uint FEATURE_DIRECTIONAL_LIGHTS = 1u << 10;
GPU_CONST uint FEATURE_EMISSION = 1u << 11;
GPU_CONST uint FEATURE_DIFFUSE = 1u << 12;
GPU_CONST uint FEATURE_GLOSSY = 1u << 13;
GPU_CONST uint FEATURE_MIRROR = 1u << 14;
GPU_CONST uint FEATURE_ALPHA = 1u << 15;        // cut out or half transparent surfaces
GPU_CONST uint FEATURE_AREA_LIGHTS = 1u << 16;  // sphere, rect, disk: sampled, and met by paths
GPU_CONST uint FEATURE_SUNS = 1u << 17;         // directional lights with a disc
GPU_CONST uint FEATURE_ENVIRONMENT = 1u << 18;
GPU_CONST uint FEATURE_SAMPLED_SKY = 1u << 19;  // as a light: an image, or a gradient of contrast
GPU_CONST uint FEATURE_LIGHT_TREE = 1u << 20;   // more lights than are sampled at each vertex
GPU_CONST uint FEATURE_TRANSMISSION = 1u << 21;
GPU_CONST uint FEATURE_ABSORPTION = 1u << 22;
GPU_CONST uint FEATURE_CLEARCOAT = 1u << 23;
GPU_CONST uint FEATURE_EDGE_TINT = 1u << 24;
GPU_CONST uint FEATURE_COMPENSATION = 1u << 25;  // the setting energyCompensation
GPU_CONST uint FEATURE_LENS = 1u << 26;
GPU_CONST uint FEATURE_ORTHOGRAPHIC = 1u << 27;
GPU_CONST uint FEATURE_ROULETTE = 1u << 28;  // the setting, and bounces enough for it
GPU_CONST uint FEATURE_CLAMP = 1u << 29;
GPU_CONST uint FEATURE_MESHES = 1u << 30;
GPU_CONST uint FEATURE_TEXTURES = 1u << 31;  // or colours at vertices
GPU_CONST uint FEATURE_COUNT = 32u;
// A material's own bits, in place of the shape features, which it never needs.
GPU_CONST uint MATERIAL_THIN = 1u << 1;   // meshes: a sheet that encloses nothing
GPU_CONST uint MATERIAL_MASK = 1u << 2;   // opaque from the alpha cutoff on
GPU_CONST uint MATERIAL_ALPHA = 1u << 3;  // has an opacity to be looked up
GPU_CONST uint MATERIAL_OWN_BITS = 15u;
GPU_CONST uint MATERIAL_ONE_SIDED = 1u << 0;  // emits on the side of its normal only
// Counts baked into a special variant of a small scene; 0 = read the count from the push constants.
GPU_CONST uint CONSTANT_FIXED_SPHERES = 32u;
GPU_CONST uint CONSTANT_FIXED_PLANES = 33u;
GPU_CONST uint CONSTANT_FIXED_LIGHTS = 34u;
GPU_CONST uint CONSTANT_ABLATION = 35u;  // obey the TRACE_* flags of measurements
GPU_CONST uint CONSTANT_WHILE_WHILE =
    36u;                                // form of the loop over a mesh: true suits CPU drivers, false GPUs
GPU_CONST uint CONSTANT_ANY_HIT = 37u;  // cast_rays.comp: shadow rays
GPU_CONST uint CONSTANT_ONE_INSTANCE = 38u;     // a single mesh instance needs no hierarchy above it
GPU_CONST uint CONSTANT_SHAPE_HIERARCHY = 41u;  // as TRACE_SHAPE_HIERARCHY
GPU_CONST uint CONSTANT_MESH_LIGHTS = 42u;      // meshes are among the lights
GPU_CONST uint CONSTANT_SOLID_LIGHTS = 43u;     // boxes are; the next two: cylinders, ellipsoids
GPU_CONST uint SOLID_LIGHT_KINDS = 3u;
GPU_CONST uint CONSTANT_PLANE_AXES = 46u;  // 3 bits for each fixed plane (features.glsl)
GPU_CONST uint MAX_FIXED = 8u;             // spheres, planes
GPU_CONST uint MAX_FIXED_LIGHTS = 4u;

// Flags of TraceParams.
GPU_CONST uint TRACE_ERROR_METER = 1u;  // even samples belong to half A, odd ones to half B
GPU_CONST uint TRACE_RUSSIAN_ROULETTE = 2u;
GPU_CONST uint TRACE_HALF_B = 4u;  // which half this dispatch adds to
GPU_CONST uint TRACE_COMPENSATION = 8u;
GPU_CONST uint TRACE_ENVIRONMENT = 16u;
GPU_CONST uint TRACE_MET_LIGHTS =
    512u;  // something emits: paths go one segment past the last bounce, to meet it
GPU_CONST uint TRACE_SHAPE_HIERARCHY = 1024u;  // bounded analytic shapes lie in the top level
// Ablations for measurements (what a method is worth); all 0 in use.
GPU_CONST uint TRACE_NO_LIGHT_SAMPLING = 32u;  // area lights and environment are found by paths alone
GPU_CONST uint TRACE_NO_BSDF_HITS = 64u;       // they are sampled alone
GPU_CONST uint TRACE_PCG_SAMPLES = 128u;       // independent numbers instead of Owen-scrambled Sobol points
GPU_CONST uint TRACE_UNIFORM_LIGHTS = 256u;    // many lights: uniform choice instead of the tree
GPU_CONST uint TRACE_ALL_NORMALS = 2048u;      // facets drawn by their distribution, whether visible or not

// Push constants of path_trace.comp and pick.comp.
struct TraceParams {
  uint width, height;           // film, pixels
  uint rowBegin, rowEnd;        // rows of this dispatch
  uint sampleBegin, sampleEnd;  // indices within the half's own sequence
  uint seed, flags;
  uint maxBounces, lightSamples;
  uint materialRow, lightRow;  // first rows of these tables
  uint objectRow;
  uint sphereCount, planeCount, largeSphereCount;
  uint boxCount, rectCount, diskCount, cylinderCount, ellipsoidCount, instanceCount;
  uint topLevelRow;  // root of the hierarchy over the scene
  uint lightCount, sunCount, lightTreeRow;
  uint environmentRow;
  float clampRadiance;  // nit, 0 = off
  float pixelScale;     // metres per pixel at distance 1
  float perFilmUnit;    // 1 / FilmParams::filmUnit
  uint pickX, pickY;    // pick.comp only
};

// Push constants of resolve.comp, level.comp and meter.comp.
struct FilmParams {
  uint width, height;
  uint splitPixel;          // pixels before it already hold the pass in progress
  uint aheadA, aheadB;      // samples of each half in those
  uint samplesA, samplesB;  // and in the others
  float relativeFloor;      // 0.01: relMSE = d^2 / (light^2 + floor)
  float filmUnit;           // radiance, a power of two (renderer/film_unit.hpp)
};

// A film holds one sum of radiance per pixel, half-buffer and channel, in digits of base FILM_BASE:
// filmUnit * (high + middle / FILM_BASE + low / FILM_BASE^2). Buffers of a half: low, closest rays |
// middle, shadow rays | high, -.
GPU_CONST int FILM_DIGIT_BITS = 30;
GPU_CONST int FILM_BASE = 1 << FILM_DIGIT_BITS;  // high ends at +-FILM_BASE: a sum there is a fault
GPU_CONST uint FILM_DIGITS = 3u;

// Directional albedo of white GGX facets, split by Fresnel: cells of a grid over (roughness, sqrt(cosine)),
// two rows per cell: the part of F0 at the 4 corners | the part of F90 at the 4 corners.
GPU_CONST uint ENERGY_CELLS = 32u;
GPU_CONST uint ENERGY_ROWS = 2u * ENERGY_CELLS * ENERGY_CELLS;
// Tables of rough glass, a row per cell: the 4 corners. On the same grid what white glass gives back,
// reflected and passed together, seen from the outside and from within; then the share of it that is
// reflected: outside, within, and by a sheet. Where total reflection puts a crease into that share, its grid
// is one over square roots of the distance to the critical cosine.
GPU_CONST uint GLASS_CELLS = ENERGY_CELLS * ENERGY_CELLS;
GPU_CONST uint GLASS_SHARES = 2u * GLASS_CELLS;  // first row
GPU_CONST uint GLASS_ROWS = GLASS_SHARES + 3u * GLASS_CELLS;

// Push constants of the display pass: a film shown in a rectangle.
struct DisplayParams {
  float rectX, rectY, rectWidth, rectHeight;  // framebuffer pixels
  uint width, height;                         // film, pixels
  float exposureScale;                        // 2^stops
  uint transfer;                              // 0 sRGB, 1 plain gamma
  float inverseGamma;
  float parameters[8];  // of the tonemapper
};

// One invocation's part of the meter, over METER_PIXELS: 2 rows: sum d^2, sum d^2/(mean^2+floor), closest
// rays, shadow rays | sum of the samples' luminance (nit), -, -, -
GPU_CONST uint METER_ROWS = 2u;
GPU_CONST uint METER_GROUP = 64u;
GPU_CONST uint METER_PIXELS = 64u;

// Counters of a film (uint): samples dropped (NaN, or beyond the film), faults, luminance cut by clamping (64
// bits, CLAMPED_UNITS for what the clamp lets pass).
GPU_CONST uint COUNTER_NAN = 0u;
GPU_CONST uint COUNTER_FAULTS = 1u;
GPU_CONST uint COUNTER_CLAMPED_LOW = 2u;
GPU_CONST uint COUNTER_CLAMPED_HIGH = 3u;
GPU_CONST uint CLAMPED_UNITS = 4096u;
GPU_CONST uint COUNTERS = 4u;

// pick.comp's answer: primitive and object (bits), distance, - | position relative to the camera, - | normal,
// -
GPU_CONST uint PICK_ROWS = 3u;

#ifdef __cplusplus
static_assert(sizeof(TraceParams) <= 128 && sizeof(FilmParams) <= 128 && sizeof(DisplayParams) <= 128);
#undef GPU_CONST
}  // namespace steradian::gpu
#endif
#endif
