// SPDX-License-Identifier: MIT
// @id org.steradian.tonemap.reinhard_luminance
// @name Reinhard (luminance)
// @param float whitePoint 4 0.5 64 "" "Luminance that becomes pure white"
// Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", eq. 4, with hue kept by scaling.
vec3 tonemap(vec3 sceneLinear) {
  vec3 c = clamp(sceneLinear, 0.0, 65504.0);
  float luminance = dot(c, vec3(0.2126, 0.7152, 0.0722));
  float scale = (1.0 + luminance / (whitePoint * whitePoint)) / (1.0 + luminance);
  return min(c * scale, 1.0);
}
