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
layout(constant_id = 15) const bool kFilterTable = true;
layout(constant_id = 16) const uint kFixedSpheres = 0;
layout(constant_id = 17) const uint kFixedPlanes = 0;
layout(constant_id = 18) const uint kFixedLights = 0;

const bool kLights = kPointLights || kSpotLights || kDirectionalLights;
const bool kAffine = kBoxes || kRects || kDisks || kCylinders || kEllipsoids;

// Material feature bits that this variant lacks must not occur: the sample is counted as a fault.
uint missingFeatures(uint needed) {
  uint have = (kEmission ? FEATURE_EMISSION : 0u) | (kDiffuse ? FEATURE_DIFFUSE : 0u) |
              (kGlossy ? FEATURE_GLOSSY : 0u) | (kMirror ? FEATURE_MIRROR : 0u);
  return needed & ~have;
}

#endif
