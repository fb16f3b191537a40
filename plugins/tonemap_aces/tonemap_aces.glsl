// SPDX-License-Identifier: MIT
// @id org.steradian.tonemap.aces
// @name ACES (Hill fit)
// Stephen Hill's fit of the ACES RRT and the sRGB ODT (2017, in the BakingLab sample of M. Pettineo and D. Neubelt).
// The rows below are those of the published matrices, so vectors stand on the left.
const mat3 kAcesIn = mat3(0.59719, 0.35458, 0.04823,  // Rec. 709 -> XYZ -> D60 -> AP1 -> RRT saturation
                          0.07600, 0.90834, 0.01566,
                          0.02840, 0.13383, 0.83777);
const mat3 kAcesOut = mat3(1.60475, -0.53108, -0.07367,  // ODT saturation -> XYZ -> D65 -> Rec. 709
                           -0.10208, 1.10813, -0.00605,
                           -0.00327, -0.07276, 1.07602);

vec3 tonemap(vec3 sceneLinear) {
  vec3 v = clamp(sceneLinear, 0.0, 65504.0) * kAcesIn;
  vec3 fitted = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  return clamp(fitted * kAcesOut, 0.0, 1.0);
}
