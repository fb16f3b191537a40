// SPDX-License-Identifier: MIT
// Chooses one of many lights about in proportion to what it sends to a point: descends a binary tree of lights
// (Conty Estevez & Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", HPG 2018, without
// orientation and without splitting). Any light has a chance, and its probability can be asked for.
#ifndef LIGHT_TREE_GLSL
#define LIGHT_TREE_GLSL
#include "scene.glsl"

struct LightChoice {
  uint light;
  float probability;
};

// Two children: where they lead to, and the probability of the first.
struct LightSplit {
  uint first;
  uint second;
  float share;
};

bool uniformLights() { return !kLightTree || (kAblation && (params.flags & TRACE_UNIFORM_LIGHTS) != 0u); }

// What power / importance is: the squared distance, in the near field a share of the cluster's own size. Directional lights
// state their illuminance instead of their intensity: distance 1.
float lightDistance2(vec4 node, float radius2, vec3 p) {
  vec3 f = node.xyz - p;
  return radius2 < 0.0 ? 1.0 : clamp(max(dot(f, f), radius2), 1e-20, 1e30);
}

LightSplit lightSplit(uint child, vec3 p) {
  uint row = params.lightTreeRow + child * LIGHT_NODE_ROWS;
  vec4 a = fetchRow(row);
  vec4 b = fetchRow(row + 1u);
  vec4 c = fetchRow(row + 2u);
  vec4 d = fetchRow(row + 3u);
  float first = a.w * lightDistance2(c, d.x, p);
  float second = c.w * lightDistance2(a, b.x, p);
  float sum = first + second;
  // No light is left out, whatever underflows.
  float share = clamp(sum > 0.0 ? first / sum : 0.5, 1e-5, 1.0 - 1e-5);
  return LightSplit(floatBitsToUint(b.y), floatBitsToUint(d.y), share);
}

// The root's link; a leaf when all lights are sampled anyway, so that no step is taken.
uint lightTreeRoot() {
  bool needed = params.lightCount > params.lightSamples;
  return needed ? floatBitsToUint(fetchRow(params.lightTreeRow + 1u).y) : LIGHT_NODE_LEAF;
}

// u in [0, 1).
LightChoice chooseLight(vec3 p, float u) {
  float count = float(params.lightCount);
  if (uniformLights()) return LightChoice(min(uint(u * count), params.lightCount - 1u), 1.0 / count);
  uint link = lightTreeRoot();
  float probability = 1.0;
  for (uint level = 0u; level < MAX_LIGHT_TREE_DEPTH && link < LIGHT_NODE_LEAF; ++level) {
    LightSplit split = lightSplit(link, p);
    bool first = u < split.share;
    float share = first ? split.share : 1.0 - split.share;
    u = min((first ? u : u - split.share) / share, 0.99999994);
    probability *= share;
    link = first ? split.first : split.second;
  }
  return LightChoice(min(link & ~LIGHT_NODE_LEAF, params.lightCount - 1u), probability);
}

// Probability of chooseLight() for this light: the same descent along its trail, one bit a level.
float lightChoiceProbability(vec3 p, uint light) {
  if (uniformLights()) return 1.0 / float(params.lightCount);
  uint trail = floatBitsToUint(fetchRow(params.lightTreeRow + (2u * params.lightCount - 1u) * LIGHT_NODE_ROWS + light).x);
  uint link = lightTreeRoot();
  float probability = 1.0;
  for (uint level = 0u; level < MAX_LIGHT_TREE_DEPTH && link < LIGHT_NODE_LEAF; ++level) {
    LightSplit split = lightSplit(link, p);
    bool first = ((trail >> level) & 1u) == 0u;
    probability *= first ? split.share : 1.0 - split.share;
    link = first ? split.first : split.second;
  }
  return probability;
}

#endif
