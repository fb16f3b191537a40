// SPDX-License-Identifier: MIT
// Directions and the equirectangular map: its centre column along -Z, +Y up, +X to the right. Binding-free.
#ifndef SPHERE_MAP_GLSL
#define SPHERE_MAP_GLSL
#include "sampling.glsl"

// Angle of (x, y) from the x axis, in turns, [-1/2, 1/2]; within 4 units in the last place of a quarter turn. Vulkan's
// own atan may err by 4096 of them. Folded to an eighth turn, then Moshier's polynomial (Cephes, atanf).
float turnOf(float y, float x) {
  float shorter = min(abs(x), abs(y));
  float longer = max(max(abs(x), abs(y)), 1e-37);
  bool steep = shorter > 0.41421356237 * longer;
  float slope = steep ? (shorter - longer) / (shorter + longer) : shorter / longer;
  float s2 = slope * slope;
  float series = ((8.05374449538e-2 * s2 - 1.38776856032e-1) * s2 + 1.99777106478e-1) * s2 - 3.33329491539e-1;
  float turn = (slope + slope * s2 * series) * (0.5 / PI) + (steep ? 0.125 : 0.0);
  turn = abs(y) > abs(x) ? 0.25 - turn : turn;
  turn = x < 0.0 ? 0.5 - turn : turn;
  return y < 0.0 ? -turn : turn;
}

struct MapCell {
  uint column;
  uint row;
};

// The cell of a map of columns x rows that unit direction d points into. The polar angle comes from its sine and cosine,
// which keeps cells at the poles apart; an arc cosine would not.
MapCell mapCell(vec3 d, float columns, float rows) {
  float across = 0.5 + turnOf(d.x, -d.z);
  float down = 2.0 * turnOf(sqrt(d.x * d.x + d.z * d.z), d.y);
  return MapCell(uint(clamp(floor(across * columns), 0.0, columns - 1.0)), uint(clamp(floor(down * rows), 0.0, rows - 1.0)));
}

// The direction `across` of a turn from the map's left edge, at height +-(1 - fromPole): the distance from the nearer
// pole keeps its digits where the height has none left.
vec3 mapDirection(float across, float fromPole, bool upper) {
  CosSin azimuth = cosSinTurn(across);
  // Else a compiler that knows where fromPole came from may round in other places than one that does not.
  precise float height = 1.0 - fromPole;
  precise float square = fromPole * (1.0 + height);
  float r = sqrt(max(0.0, square));
  return vec3(-r * azimuth.s, upper ? height : -height, r * azimuth.c);
}

// t in [0, 1] with density in proportion to mix(a, b, t), which must not be 0 all over. The inverse without cancellation
// (Heitz, "Can't Invert the CDF?", 2020).
float sampleLinear(float u, float a, float b) {
  return min(1.0, u * (a + b) / max(a + sqrt(mix(a * a, b * b, u)), 1e-37));
}

#endif
