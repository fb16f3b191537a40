// SPDX-License-Identifier: MIT
// Directions towards a box, a cylinder or a ball: from outside over the sides that face the point, from inside over all
// directions. Its space keeps right angles and, but for balls, proportions: what is sampled evenly there is so in the
// world. Binding-free.
#ifndef SOLID_SAMPLING_GLSL
#define SOLID_SAMPLING_GLSL
#include "disk_sampling.glsl"
#include "gpu_types.h"
#include "shapes.glsl"

// A point of the solid's own surface may lie this far off it, and is inside if it sees the solid at all.
const float SOLID_ROUNDING = 1.00001;

const float EVERYWHERE = 1.0 / (4.0 * PI);

// From a point inside a convex solid; `unit` tells the distance to the wall.
vec3 anyDirection(float u, float v) { return coneDirection(vec3(0.0, 0.0, 1.0), 2.0 * u, v); }

// A number in a part of [0, 1) as a number of its own.
float within(float u, float before, float share) { return clamp((u - before) / max(share, 1e-20), 0.0, 0.9999999); }

// ---- Box |p| <= h: its up to three faces towards p, each evenly by solid angle.

struct BoxFace {
  vec3 centre;
  vec3 u;  // half edges
  vec3 v;
};

BoxFace boxFace(vec3 p, vec3 h, uint axis) {
  vec3 x = vec3(h.x, 0.0, 0.0);
  vec3 y = vec3(0.0, h.y, 0.0);
  vec3 z = vec3(0.0, 0.0, h.z);
  BoxFace face = BoxFace(x * side(p.x), y, z);
  if (axis == 1u) face = BoxFace(y * side(p.y), z, x);
  if (axis == 2u) face = BoxFace(z * side(p.z), x, y);
  return face;
}

// Roughly the solid angle of the face across one axis: that of as much of it as lies around its nearest point. h = its
// half edges, p in the same axes, the face's own last.
float faceShare(vec3 p, vec3 h) {
  float height = abs(p.z) - h.z;
  float x = max(abs(p.x) - h.x, 0.0);
  float y = max(abs(p.y) - h.y, 0.0);
  float nearest = sqrt(x * x + y * y + height * height);
  float area = min(h.x, nearest) * min(h.y, nearest);
  return height > 0.0 ? 4.0 * area * height / max(nearest * nearest * nearest, 1e-36) : 0.0;
}

// Shares of the faces across x, y, z.
vec3 boxShares(vec3 p, vec3 h) {
  float x = faceShare(vec3(p.y, p.z, p.x), vec3(h.y, h.z, h.x));
  float y = faceShare(vec3(p.z, p.x, p.y), vec3(h.z, h.x, h.y));
  float z = faceShare(p, h);
  return vec3(x, y, z) / max(x + y + z, 1e-36);
}

bool insideBox(vec3 p, vec3 h) { return max(abs(p.x) / h.x, max(abs(p.y) / h.y, abs(p.z) / h.z)) <= SOLID_ROUNDING; }

LightDirection sampleBox(vec3 p, vec3 h, float u, float v) {
  vec3 share = boxShares(p, h);
  uint axis = u < share.x ? 0u : (u < share.x + share.y ? 1u : 2u);
  float before = axis == 0u ? 0.0 : (axis == 1u ? share.x : share.x + share.y);
  float chosen = axis == 0u ? share.x : (axis == 1u ? share.y : share.z);
  BoxFace face = boxFace(p, h, axis);
  LightDirection outside = sampleRect(p, face.centre, face.u, face.v, within(u, before, chosen), v);
  vec3 wi = anyDirection(u, v);
  bool inside = insideBox(p, h);
  float wall = hitBox(LocalRay(p / h, wi / h), true, true);
  return LightDirection(inside ? wi : outside.wi, inside ? wall : outside.distance, inside ? EVERYWHERE : outside.pdf * chosen);
}

// How far along wi the plane of the face towards p is; -INFINITE where p is not before it.
float facingPlane(float p, float h, float wi) { return abs(p) > h && p * wi < 0.0 ? (side(p) * h - p) / wi : -INFINITE; }

float boxPdf(vec3 p, vec3 h, vec3 wi) {
  float x = facingPlane(p.x, h.x, wi.x);
  float y = facingPlane(p.y, h.y, wi.y);
  float z = facingPlane(p.z, h.z, wi.z);
  uint axis = x >= y && x >= z ? 0u : (y >= z ? 1u : 2u);
  vec3 share = boxShares(p, h);
  BoxFace face = boxFace(p, h, axis);
  float outside = rectPdf(p, face.centre, face.u, face.v, wi) * (axis == 0u ? share.x : (axis == 1u ? share.y : share.z));
  return insideBox(p, h) ? EVERYWHERE : outside;
}

// ---- Cylinder x^2 + z^2 <= 1, |y| <= h: the cap and the half of the tube that face p.

// The tube from outside: the azimuth is uniform in the angle under which it fills the horizon, the height in the sine of
// the elevation.
struct TubeView {
  float distance;   // of p from the axis
  float halfAngle;  // that the tube fills
  float low;        // of its ends over p
  float high;
};

TubeView tubeView(vec3 p, float h) {
  float r = sqrt(p.x * p.x + p.z * p.z);
  float tangent = sqrt(max((r - 1.0) * (r + 1.0), 0.0));
  return TubeView(r, angleOf(tangent, 1.0), -h - p.y, h - p.y);
}

// From p to the tube in the plane across its axis; sine of the angle from the axis.
float tubeDistance(TubeView view, float cosine, float sine) {
  float s = view.distance * sine;
  return max(view.distance * cosine - sqrt(max(1.0 - s * s, 0.0)), 1e-7);
}

// Sines of the elevations of the ends, at a horizontal distance: the lower one, and the difference without cancellation.
vec2 tubeSines(TubeView view, float distance) {
  float la = sqrt(distance * distance + view.low * view.low);
  float lb = sqrt(distance * distance + view.high * view.high);
  float direct = view.high * la - view.low * lb;
  float sum = abs(view.high) * la + abs(view.low) * lb;
  float apart = distance * distance * (view.high - view.low) * abs(view.low + view.high) / max(sum, 1e-30);
  bool between = view.low < 0.0 && view.high > 0.0;
  return vec2(view.low / la, (between ? direct : apart) / (la * lb));
}

float tubeDensity(TubeView view, float sines) { return 1.0 / max(2.0 * view.halfAngle * sines, 1e-30); }

LightDirection sampleTube(TubeView view, vec3 p, float u, float v) {
  float signedTurn = (2.0 * u - 1.0) * view.halfAngle * (0.5 / PI);
  CosSin turn = cosSinTurn(abs(signedTurn));
  float sine = signedTurn < 0.0 ? -turn.s : turn.s;
  float distance = tubeDistance(view, turn.c, sine);
  vec2 sines = tubeSines(view, distance);
  float up = clamp(sines.x + v * sines.y, -1.0, 1.0);
  float level = sqrt(max(1.0 - up * up, 1e-12));
  float ex = -p.x / view.distance;
  float ez = -p.z / view.distance;
  vec3 wi = vec3((ex * turn.c - ez * sine) * level, up, (ez * turn.c + ex * sine) * level);
  return LightDirection(wi, distance / level, tubeDensity(view, sines.y));
}

// The cap towards p, in the coordinates of a disk.
DiskView capView(vec3 p, float h) { return diskView(vec3(p.z, p.x, p.y - side(p.y) * h)); }

// Share of the cap; the tube has the rest.
float capShare(vec3 p, float h, DiskView cap, TubeView tube) {
  float capAngle = abs(p.y) > h ? leastSolidAngle(cap) : 0.0;
  float tubeAngle = tube.distance > 1.0 ? 2.0 * tube.halfAngle * tubeSines(tube, max(tube.distance - 1.0, 1e-7)).y : 0.0;
  return capAngle / max(capAngle + tubeAngle, 1e-36);
}

bool insideCylinder(vec3 p, float h) {
  return abs(p.y) <= SOLID_ROUNDING * h && p.x * p.x + p.z * p.z <= SOLID_ROUNDING * SOLID_ROUNDING;
}

LightDirection sampleCylinder(vec3 p, float h, float u, float v) {
  DiskView cap = capView(p, h);
  TubeView tube = tubeView(p, h);
  float share = capShare(p, h, cap, tube);
  LightDirection onCap = sampleUnitDisk(cap, within(u, 0.0, share), v);
  LightDirection onTube = sampleTube(tube, p, within(u, share, 1.0 - share), v);
  bool capped = u < share;
  vec3 capWi = vec3(onCap.wi.y, onCap.wi.z, onCap.wi.x);
  LightDirection outside = LightDirection(capped ? capWi : onTube.wi, capped ? onCap.distance : onTube.distance,
                                          capped ? onCap.pdf * share : onTube.pdf * (1.0 - share));
  vec3 wi = anyDirection(u, v);
  bool inside = insideCylinder(p, h);
  float wall = hitCylinder(LocalRay(vec3(p.x, p.y / h, p.z), vec3(wi.x, wi.y / h, wi.z)), true, true);
  return LightDirection(inside ? wi : outside.wi, inside ? wall : outside.distance, inside ? EVERYWHERE : outside.pdf);
}

float cylinderPdf(vec3 p, float h, vec3 wi) {
  DiskView cap = capView(p, h);
  TubeView tube = tubeView(p, h);
  float share = capShare(p, h, cap, tube);
  float level = max(sqrt(wi.x * wi.x + wi.z * wi.z), 1e-20);
  float scale = 1.0 / (level * max(tube.distance, 1e-20));
  float distance = tubeDistance(tube, -(wi.x * p.x + wi.z * p.z) * scale, (wi.x * p.z - wi.z * p.x) * scale);
  float height = p.y + wi.y * (distance / level);
  bool onTube = tube.distance > 1.0 && abs(height) <= h;
  float capPdf = unitDiskPdf(cap, vec3(wi.z, wi.x, wi.y)) * share;
  float tubePdf = tubeDensity(tube, tubeSines(tube, distance).y) * (1.0 - share);
  return insideCylinder(p, h) ? EVERYWHERE : (onTube ? tubePdf : capPdf);
}

// ---- By kind.

// Which kinds a variant knows; the others are compiled out.
struct SolidKinds {
  bool box;
  bool cylinder;
  bool ellipsoid;
};

// A space, and half the size of the solid in it.
struct SolidSpace {
  UnitSpace space;
  vec3 size;
};

// Coordinates that are `stretch` times as large.
UnitSpace stretched(UnitSpace s, vec3 stretch) {
  s.p = s.p * stretch;
  s.row0 = s.row0 * stretch.x;
  s.row1 = s.row1 * stretch.y;
  s.row2 = s.row2 * stretch.z;
  s.axis0 = s.axis0 / stretch.x;
  s.axis1 = s.axis1 / stretch.y;
  s.axis2 = s.axis2 / stretch.z;
  s.scale = s.scale * (stretch.x * stretch.y * stretch.z);
  return s;
}

// From the rows of an affine shape (gpu_types.h); the columns of the inverse are cross products.
SolidSpace solidSpace(uint kind, vec3 p, vec4 row0, vec4 row1, vec4 row2) {
  UnitSpace s;
  s.p = toUnit(p, p, row0, row1, row2).o;
  s.row0 = vec3(row0.x, row0.y, row0.z);
  s.row1 = vec3(row1.x, row1.y, row1.z);
  s.row2 = vec3(row2.x, row2.y, row2.z);
  float determinant = dot(s.row0, cross(s.row1, s.row2));
  s.axis0 = cross(s.row1, s.row2) / determinant;
  s.axis1 = cross(s.row2, s.row0) / determinant;
  s.axis2 = cross(s.row0, s.row1) / determinant;
  s.scale = abs(determinant);
  vec3 size = vec3(length(s.axis0), length(s.axis1), length(s.axis2));
  if (kind == LIGHT_CYLINDER) size = vec3(1.0, size.y * inversesqrt(size.x * size.z), 1.0);
  if (kind == LIGHT_ELLIPSOID) size = vec3(1.0);
  return SolidSpace(stretched(s, size), size);
}

LightDirection sampleSolid(uint kind, SolidSpace s, float u, float v, SolidKinds kinds) {
  vec3 p = s.space.p;
  LightDirection d = LightDirection(vec3(0.0, 0.0, 1.0), 0.0, 0.0);
  if (kinds.ellipsoid && kind == LIGHT_ELLIPSOID) d = sampleSphere(p, vec3(0.0), 1.0, u, v);
  if (kinds.box && kind == LIGHT_BOX) d = sampleBox(p, s.size, u, v);
  if (kinds.cylinder && kind == LIGHT_CYLINDER) d = sampleCylinder(p, s.size.y, u, v);
  return toWorldSpace(s.space, d);
}

// Density of sampleSolid() for a direction that meets the solid.
float solidPdf(uint kind, SolidSpace s, vec3 wi, SolidKinds kinds) {
  vec3 p = s.space.p;
  vec3 stretchedWi = toUnitSpace(s.space, wi);
  float inv = inversesqrt(max(dot(stretchedWi, stretchedWi), 1e-36));
  vec3 local = stretchedWi * inv;
  float pdf = 0.0;
  if (kinds.ellipsoid && kind == LIGHT_ELLIPSOID) pdf = spherePdf(p, vec3(0.0), 1.0, local);
  if (kinds.box && kind == LIGHT_BOX) pdf = boxPdf(p, s.size, local);
  if (kinds.cylinder && kind == LIGHT_CYLINDER) pdf = cylinderPdf(p, s.size.y, local);
  return pdfInWorld(s.space, pdf, inv);
}

#endif
