// SPDX-License-Identifier: MIT
// @id org.steradian.tonemap.reinhard
// @name Reinhard (per channel)
// L / (1 + L) on each channel: keeps everything below white but shifts hues of bright colours.
// The bound keeps infinity / infinity out.
vec3 tonemap(vec3 sceneLinear) {
  vec3 c = clamp(sceneLinear, 0.0, 65504.0);
  return c / (1.0 + c);
}
