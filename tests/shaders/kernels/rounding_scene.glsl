// SPDX-License-Identifier: MIT
// As rounding.glsl, for functions that read a scene: camera, sky, light tree, mesh light, textures.
#ifndef ROUNDING_SCENE_GLSL
#define ROUNDING_SCENE_GLSL
#include "camera.glsl"
#include "environment.glsl"
#include "light_tree.glsl"
#include "mesh_light.glsl"

vec4 scalar(float x) { return vec4(x, 0.0, 0.0, 0.0); }

// (x, y, lens u, lens v).
vec4 roundCamera(uint operation, vec4 a) {
  CameraRay ray = cameraRay(fetchCamera(), a.x, a.y, a.z, a.w);
  vec4 result = vec4(ray.d, 0.0);
  if (operation == 1u) result = vec4(ray.o, 0.0);
  if (operation == 2u) result = scalar(filterOffset(a.z));
  return result;
}

// (unit direction, -) (u, v, -, -).
vec4 roundSky(uint operation, vec4 a, vec4 b) {
  SkyValue seen = environmentAt(a.xyz);
  LightSample drawn = sampleEnvironment(b.x, b.y);
  vec4 result = vec4(seen.radiance, 0.0);
  if (operation == 11u) result = scalar(seen.pdf);
  if (operation == 12u) result = vec4(drawn.wi, 0.0);
  if (operation == 13u) result = scalar(drawn.pdf);
  return result;
}

// (p, light) (u, v, -, -).
vec4 roundLights(uint operation, vec4 a, vec4 b) {
  uint light = uint(a.w);
  vec4 result = vec4(0.0);
  if (operation == 20u) result = scalar(lightChoiceProbability(a.xyz, light));
  if (operation == 21u) {
    LightChoice choice = chooseLight(a.xyz, b.x);
    result = vec4(choice.probability, float(choice.light) * choice.probability, 0.0, 0.0);
  }
  if (operation >= 22u) {
    LightRows rows = fetchLight(light);
    LightSample s = sampleMeshLight(rows, a.xyz, b.x, b.y, primitiveLayout());
    result = vec4(s.wi, 0.0);
    if (operation == 23u) result = scalar(s.pdf);
    if (operation == 24u) result = vec4(s.illuminance * s.pdf, 0.0);
  }
  return result;
}

// (u, v, level, row of the reference) (footprint, coordinates per metre, jitter, -).
vec4 roundTexture(uint operation, vec4 a, vec4 b) {
  TextureRef t = fetchTextureRef(uint(a.w));
  vec4 result = lookUp(t, a.x, a.y, uint(a.z));
  if (operation == 31u) result = scalar(float(mipLevel(t, b.x, b.y, b.z)));
  return result;
}

vec4 roundedOfScene(uint operation, vec4 a, vec4 b) {
  vec4 result = vec4(0.0);
  if (operation < 10u) result = roundCamera(operation, a);
  else if (operation < 20u) result = roundSky(operation, a, b);
  else if (operation < 30u) result = roundLights(operation, a, b);
  else result = roundTexture(operation, a, b);
  return result;
}

#endif
