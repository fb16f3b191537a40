// SPDX-License-Identifier: MIT
// Model only what a scene needs: each kind is a boolean specialization constant, set by what the scene holds, never
// by a value. The defaults are the generic variant. Small scenes may bake their primitive counts too.
#ifndef FEATURES_GLSL
#define FEATURES_GLSL
#include "gpu_types.h"

layout(constant_id = 0) const bool kSpheres = true;
layout(constant_id = 1) const bool kPlanes = true;
layout(constant_id = 2) const bool kLargeSpheres = true;
layout(constant_id = 3) const bool kBoxes = true;
layout(constant_id = 4) const bool kRects = true;
layout(constant_id = 5) const bool kDisks = true;
layout(constant_id = 6) const bool kCylinders = true;
layout(constant_id = 7) const bool kEllipsoids = true;
layout(constant_id = 8) const bool kPointLights = true;
layout(constant_id = 9) const bool kSpotLights = true;
layout(constant_id = 10) const bool kDirectionalLights = true;
layout(constant_id = 11) const bool kEmission = true;
layout(constant_id = 12) const bool kDiffuse = true;
layout(constant_id = 13) const bool kGlossy = true;
layout(constant_id = 14) const bool kMirror = true;
layout(constant_id = 15) const bool kAlpha = true;
layout(constant_id = 16) const bool kAreaLights = true;
layout(constant_id = 17) const bool kSuns = true;
layout(constant_id = 18) const bool kEnvironment = true;
layout(constant_id = 19) const bool kSampledSky = true;
layout(constant_id = 20) const bool kLightTree = true;
layout(constant_id = 21) const bool kTransmission = true;
layout(constant_id = 22) const bool kAbsorption = true;
layout(constant_id = 23) const bool kClearcoat = true;
layout(constant_id = 24) const bool kEdgeTint = true;
layout(constant_id = 25) const bool kCompensation = true;
layout(constant_id = 26) const bool kLens = true;
layout(constant_id = 27) const bool kOrthographic = true;
layout(constant_id = 28) const bool kRoulette = true;
layout(constant_id = 29) const bool kClamp = true;
layout(constant_id = 30) const bool kMeshes = true;
layout(constant_id = 31) const bool kTextures = true;
layout(constant_id = 32) const uint kFixedSpheres = 0;
layout(constant_id = 33) const uint kFixedPlanes = 0;
layout(constant_id = 34) const uint kFixedLights = 0;
layout(constant_id = 35) const bool kAblation = false;
// Bounded analytic shapes lie in the hierarchy over the scene (TRACE_SHAPE_HIERARCHY), not in flat lists.
layout(constant_id = 41) const bool kShapeHierarchy = false;
// Meshes and solids among the lights.
layout(constant_id = 42) const bool kMeshLights = false;
layout(constant_id = 43) const bool kBoxLights = false;
layout(constant_id = 44) const bool kCylinderLights = false;
layout(constant_id = 45) const bool kEllipsoidLights = false;
// What baked planes face, 3 bits each: 0 = any direction, else 1 + the axis, and 3 more for its negative side.
layout(constant_id = 46) const uint kPlaneAxes = 0u;

const bool kSolidLights = kBoxLights || kCylinderLights || kEllipsoidLights;
const bool kLights = kPointLights || kSpotLights || kDirectionalLights || kAreaLights;
// Lights that paths meet as well: both ways are weighed against each other.
const bool kMetLights = kAreaLights || kSuns || kSampledSky;
// Lights without a place of their own have none to tell planes from.
const bool kOnlyPoints = !kDirectionalLights && !kAreaLights && !kSampledSky;
const bool kAffine = kBoxes || kRects || kDisks || kCylinders || kEllipsoids;

// Material feature bits that this variant lacks must not occur: the sample is counted as a fault.
uint missingFeatures(uint needed) {
  uint have = (kEmission ? FEATURE_EMISSION : 0u) | (kDiffuse ? FEATURE_DIFFUSE : 0u) |
              (kGlossy ? FEATURE_GLOSSY : 0u) | (kMirror ? FEATURE_MIRROR : 0u) |
              (kTransmission ? FEATURE_TRANSMISSION : 0u) | (kAbsorption ? FEATURE_ABSORPTION : 0u) |
              (kClearcoat ? FEATURE_CLEARCOAT : 0u) | (kEdgeTint ? FEATURE_EDGE_TINT : 0u) | (kAlpha ? FEATURE_ALPHA : 0u) |
              (kTextures ? FEATURE_TEXTURES : 0u);
  return needed & ~(have | MATERIAL_OWN_BITS);
}

#endif
