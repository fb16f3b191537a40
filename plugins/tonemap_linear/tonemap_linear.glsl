// SPDX-License-Identifier: MIT
// @id org.steradian.tonemap.linear
// @name Linear (clipped)
// The smallest tonemapper. Input: scene-linear Rec. 709 in [0, 65504]; output: display-linear in [0, 1].
vec3 tonemap(vec3 sceneLinear) { return clamp(sceneLinear, 0.0, 1.0); }
