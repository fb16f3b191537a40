// SPDX-License-Identifier: MIT
// Camera rays: from the origin (the scene is camera-relative), jittered by sampling the pixel filter itself, so
// that every sample has weight 1.
#ifndef CAMERA_GLSL
#define CAMERA_GLSL
#include "scene.glsl"

struct CameraRows {
  vec3 right;
  vec3 up;
  vec3 forward;
};

CameraRows fetchCamera() {
  return CameraRows(fetchRow(0u).xyz, fetchRow(1u).xyz, fetchRow(2u).xyz);
}

// Offset from the pixel centre, in pixels: box of 1 pixel, or the tabulated inverse CDF.
float filterOffset(float u) {
  if (kFilterTable) {
    float x = u * float(FILTER_ROWS);
    vec4 row = fetchRow(CAMERA_ROWS + uint(x));
    return row.x + row.y * fract(x);
  }
  return u - 0.5;
}

vec3 cameraDirection(CameraRows camera, uvec2 pixel, float u, float v) {
  float x = (float(pixel.x) + 0.5 - 0.5 * float(params.width) + filterOffset(u)) * params.pixelScale;
  float y = (0.5 * float(params.height) - float(pixel.y) - 0.5 - filterOffset(v)) * params.pixelScale;
  return normalize(camera.right * x + camera.up * y + camera.forward);
}

#endif
