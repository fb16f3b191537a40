// SPDX-License-Identifier: MIT
// @id org.steradian.tonemap.agx
// @name AgX
// Troy Sobotka's AgX in the minimal form of Benjamin Wrensch ("Minimal AgX Implementation", 2022): inset matrix,
// log2 over 16.5 stops, a sixth-degree polynomial for the contrast curve, outset matrix. The curve's result is
// display-encoded with a power of 2.2, which is undone here because the display pass applies the transfer itself.
const mat3 kAgxInset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051,
                            0.0784335999999992, 0.878468636469772, 0.0784336,
                            0.0792237451477643, 0.0791661274605434, 0.879142973793104);
const mat3 kAgxOutset = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438,
                             -0.0980208811401368, 1.15190312990417, -0.0980434501171241,
                             -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
const float kAgxMinEv = -12.47393;
const float kAgxMaxEv = 4.026069;

vec3 agxContrast(vec3 x) {  // Horner form
  return ((((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x - 0.00232);
}

vec3 tonemap(vec3 sceneLinear) {
  vec3 c = kAgxInset * clamp(sceneLinear, 0.0, 65504.0);
  vec3 stops = clamp(log2(max(c, 1e-10)), kAgxMinEv, kAgxMaxEv);
  vec3 encoded = kAgxOutset * agxContrast((stops - kAgxMinEv) / (kAgxMaxEv - kAgxMinEv));
  return pow(clamp(encoded, 0.0, 1.0), vec3(2.2));
}
