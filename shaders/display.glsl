// SPDX-License-Identifier: MIT
// Mean radiance -> what is seen: exposure, tonemapper, transfer. The same text serves the window and the PNG.
// Completed at run time: `#version`, gpu_types.h and the tonemapper's text (with its parameters) stand before
// this, display.frag or display.comp after it.

layout(set = 0, binding = 5) readonly buffer Resolved { vec4 resolved[]; };

// IEC 61966-2-1, piecewise.
float srgbEncode(float x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055; }

// min, max and clamp hide NaN differently everywhere: test the bits first.
float safeInput(float x) {
  uint bits = floatBitsToUint(x);
  bool nan = (bits & 0x7f800000u) == 0x7f800000u && (bits & 0x007fffffu) != 0u;
  return nan ? 0.0 : clamp(x, 0.0, 65504.0);
}
float safeOutput(float x) {
  return (floatBitsToUint(x) & 0x7f800000u) == 0x7f800000u ? 0.0 : clamp(x, 0.0, 1.0);
}

vec3 encodedPixel(uint pixel) {
  vec3 radiance = resolved[pixel].xyz * display.exposureScale;
  setTonemapperParameters();
  vec3 mapped = tonemap(vec3(safeInput(radiance.x), safeInput(radiance.y), safeInput(radiance.z)));
  mapped = vec3(safeOutput(mapped.x), safeOutput(mapped.y), safeOutput(mapped.z));
  vec3 srgb = vec3(srgbEncode(mapped.x), srgbEncode(mapped.y), srgbEncode(mapped.z));
  return display.transfer == 0u ? srgb : pow(mapped, vec3(display.inverseGamma));
}
