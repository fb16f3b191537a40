// SPDX-License-Identifier: MIT
// Everything that C++ and GLSL both know of the data on the device, declared once.
//
// Scene data is a list of vec4 rows in one texel buffer, relative to the camera (origin = camera position):
//   camera (3 rows), filter table (FILTER_ROWS), spheres (1 row each), planes (1), large spheres (2),
//   boxes, rects, disks, cylinders, ellipsoids (3 each), materials (3 per primitive), object ids (1 per
//   primitive), lights (3).
// Primitive indices follow the same order. Rows:
//   camera       right, - | up, - | forward, -
//   filter       inverse CDF at i, step to i+1, -, -   (pixels from the pixel centre)
//   sphere       centre, radius
//   plane        unit normal, D = dot(point, normal)
//   large sphere centre high part, radius high part | centre low part, radius low part
//   affine shape rows of the 3x3 unitFromWorld, each with one component of the centre in w
//   material     albedo, metallic | alpha = roughness^2, dielectric F0, dielectric F90, feature bits |
//                emission (nit), -     (one per primitive: a shared table would cost a dependent fetch at
//                every vertex)
//   object id    bits, -, -, -
//   light        position or direction to the light, kind | intensity (cd or lx), cone scale | axis, cone
//   offset
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

GPU_CONST uint CAMERA_ROWS = 3u;
GPU_CONST uint FILTER_ROWS = 256u;
GPU_CONST uint LARGE_SPHERE_ROWS = 2u;
GPU_CONST uint AFFINE_ROWS = 3u;
GPU_CONST uint MATERIAL_ROWS = 3u;
GPU_CONST uint LIGHT_ROWS = 3u;

GPU_CONST uint LIGHT_POINT = 0u;
GPU_CONST uint LIGHT_SPOT = 1u;
GPU_CONST uint LIGHT_DIRECTIONAL = 2u;

GPU_CONST uint NO_PRIMITIVE = 0xffffffffu;
GPU_CONST uint MAX_LIGHT_SAMPLES = 16u;

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
GPU_CONST uint FEATURE_FILTER_TABLE = 1u << 15;
GPU_CONST uint FEATURE_COUNT = 16u;
// Counts baked into a special variant of a small scene; 0 = read the count from the push constants.
GPU_CONST uint CONSTANT_FIXED_SPHERES = 16u;
GPU_CONST uint CONSTANT_FIXED_PLANES = 17u;
GPU_CONST uint CONSTANT_FIXED_LIGHTS = 18u;
GPU_CONST uint MAX_FIXED = 8u;  // spheres, planes
GPU_CONST uint MAX_FIXED_LIGHTS = 4u;

// Flags of TraceParams.
GPU_CONST uint TRACE_ERROR_METER = 1u;  // even samples belong to half A, odd ones to half B
GPU_CONST uint TRACE_RUSSIAN_ROULETTE = 2u;
GPU_CONST uint TRACE_HALF_B = 4u;  // which half this dispatch adds to

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
  uint boxCount, rectCount, diskCount, cylinderCount, ellipsoidCount;
  uint lightCount;
  float pixelScale;   // metres per pixel at distance 1
  uint pickX, pickY;  // pick.comp only
};

// Push constants of resolve.comp and meter.comp.
struct FilmParams {
  uint width, height;
  uint splitRow;            // rows above it already hold the pass in progress
  uint aheadA, aheadB;      // samples of each half in those rows
  uint samplesA, samplesB;  // and in the others
  float relativeFloor;      // 0.01: relMSE = d^2 / (mean^2 + floor)
};

// Push constants of the display pass: a film shown in a rectangle.
struct DisplayParams {
  float rectX, rectY, rectWidth, rectHeight;  // framebuffer pixels
  uint width, height;                         // film, pixels
  float exposureScale;                        // 2^stops
  uint transfer;                              // 0 sRGB, 1 plain gamma
  float inverseGamma;
  float parameters[8];  // of the tonemapper
};

// One work group's part of the meter: sum d^2, sum d^2/(mean^2+floor), closest rays, shadow rays over
// METER_PIXELS.
GPU_CONST uint METER_GROUP = 64u;
GPU_CONST uint METER_PIXELS = 1024u;

// Counters of a film (uint): NaN samples, faults.
GPU_CONST uint COUNTER_NAN = 0u;
GPU_CONST uint COUNTER_FAULTS = 1u;
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
