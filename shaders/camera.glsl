// SPDX-License-Identifier: MIT
// Camera rays: from the origin (the scene is camera-relative), a point of the lens around it, or in parallel; jittered by
// sampling the pixel filter itself, so that every sample has weight 1.
#ifndef CAMERA_GLSL
#define CAMERA_GLSL
#include "sampling.glsl"
#include "scene.glsl"

struct CameraRows {
  vec4 right;    // w: lens radius, 0 = pinhole
  vec4 up;       // w: focus distance
  vec4 forward;  // w: 1 = parallel projection
  vec3 absorption;  // 1/m, of the solids that hold the camera
};

CameraRows fetchCamera() {
  return CameraRows(fetchRow(0u), fetchRow(1u), fetchRow(2u), kAbsorption ? fetchRow(3u).xyz : vec3(0.0));
}

// Offset from the pixel centre, in pixels, by the tabulated inverse CDF of the filter.
float filterOffset(float u) {
  float x = u * float(FILTER_ROWS);
  vec4 row = fetchRow(CAMERA_ROWS + uint(x));
  return row.x + row.y * fract(x);
}

// Where a camera ray starts and points to.
struct CameraRay {
  vec3 o;
  vec3 d;  // unit
};

// (x, y) in pixels from the top left; (lensU, lensV) in [0, 1)^2, (0, 0) the middle of the lens. A thin lens sends all rays
// of one pixel through one point of the plane in focus (Kolb, Mitchell, Hanrahan 1995, section 2).
CameraRay cameraRay(CameraRows camera, float x, float y, float lensU, float lensV) {
  float right = (x - 0.5 * float(params.width)) * params.pixelScale;
  float up = (0.5 * float(params.height) - y) * params.pixelScale;
  // `precise`: a variant that needs this sum once more must not round `d` in another way.
  precise vec3 inPlane = camera.right.xyz * right + camera.up.xyz * up;
  vec3 o = vec3(0.0);
  vec3 d = inPlane + camera.forward.xyz;
  if (kLens) {
    CosSin turn = cosSinTurn(lensV);
    float r = camera.right.w * sqrt(lensU);
    vec3 lens = camera.right.xyz * (r * turn.c) + camera.up.xyz * (r * turn.s);
    bool open = camera.right.w > 0.0;
    o = open ? lens : o;
    d = open ? d - lens / camera.up.w : d;
  }
  if (kOrthographic) {
    bool parallel = camera.forward.w > 0.0;
    o = parallel ? inPlane : o;
    d = parallel ? camera.forward.xyz : d;
  }
  return CameraRay(o, unit(d));
}

// The ray of one sample of a pixel, its place drawn from the filter.
CameraRay filteredCameraRay(CameraRows camera, uvec2 pixel, float u, float v, float lensU, float lensV) {
  return cameraRay(camera, float(pixel.x) + 0.5 + filterOffset(u), float(pixel.y) + 0.5 + filterOffset(v), lensU, lensV);
}

#endif
