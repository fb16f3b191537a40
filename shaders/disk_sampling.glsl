// SPDX-License-Identifier: MIT
// Directions towards a disk. Seen from anywhere, its rim spans an elliptic cone whose axes have closed forms (Guillen et
// al., Area-Preserving Parameterizations for Spherical Ellipses, CGF 36(4), 2017). Binding-free.
#ifndef DISK_SAMPLING_GLSL
#define DISK_SAMPLING_GLSL
#include "light_sampling.glsl"

// An affine map to a shape's unit coordinates, in which the shape is sampled; densities follow by its Jacobian.
struct UnitSpace {
  vec3 p;  // the point that looks at the shape
  vec3 row0;  // of unitFromWorld
  vec3 row1;
  vec3 row2;
  vec3 axis0;  // columns of worldFromUnit
  vec3 axis1;
  vec3 axis2;
  float scale;  // |determinant| of unitFromWorld
};

vec3 toUnitSpace(UnitSpace s, vec3 v) { return vec3(dot(s.row0, v), dot(s.row1, v), dot(s.row2, v)); }

LightDirection toWorldSpace(UnitSpace s, LightDirection d) {
  vec3 wi = s.axis0 * d.wi.x + s.axis1 * d.wi.y + s.axis2 * d.wi.z;
  float inv = inversesqrt(max(dot(wi, wi), 1e-36));
  float len = 1.0 / inv;
  vec3 toLight = wi * inv;
  float pdf = d.pdf * (s.scale * len) * (len * len);
  // At sizes beyond float's range nothing is seen; comparisons with what is not a number fail.
  bool seen = dot(toLight, toLight) < 2.0 && pdf > 0.0 && pdf < INFINITE;
  return LightDirection(seen ? toLight : vec3(0.0, 0.0, 1.0), seen ? d.distance * len : 1.0, seen ? pdf : 0.0);
}

// Density in the world of a direction whose unit vector in the space has density `pdf`; inv = 1 / its length there.
float pdfInWorld(UnitSpace s, float pdf, float inv) {
  float made = pdf * (s.scale * inv) * (inv * inv);
  return made > 0.0 && made < INFINITE ? made : 0.0;
}

// The unit disk x^2 + y^2 <= 1 in z = 0 as p sees it.
struct DiskView {
  vec3 a;  // unit axes of the cone: across,
  vec3 b;  // across and level with the disk,
  vec3 axis;
  float sineA;  // of the half angles
  float sineB;
  float height;  // of p
};

// With l1, l2 the distances of the rim's nearest and farthest points, half angle b has the sine 2 / (l1 + l2); n is
// (l1 + l2)^2 / 2 - 2, formed without cancellation.
DiskView diskView(vec3 p) {
  float d = sqrt(p.x * p.x + p.y * p.y);
  float h = abs(p.z);
  float ex = d > 1e-18 ? -p.x / d : 1.0;
  float ey = d > 1e-18 ? -p.y / d : 0.0;
  float k = (d - 1.0) * (d + 1.0) + h * h;
  float g = sqrt((d - 1.0) * (d - 1.0) + h * h) * sqrt((d + 1.0) * (d + 1.0) + h * h);
  float n = k > 0.0 ? g + k : 4.0 * h * h / max(g - k, 1e-30);
  float along = d * (n / (n + 2.0));
  float inv = inversesqrt(max(along * along + h * h, 1e-36));
  float across = along * inv;
  float down = p.z > 0.0 ? -h * inv : h * inv;
  DiskView view;
  view.axis = vec3(ex * across, ey * across, down);
  view.a = vec3(ex * down, ey * down, -across);
  view.b = vec3(-ey, ex, 0.0);
  view.sineA = 2.0 * h * inversesqrt(max(n * n + 4.0 * h * h, 1e-36));
  view.sineB = sqrt(2.0 / (n + 2.0));
  view.height = h;
  return view;
}

// Within a factor of two; the cone is this large or larger.
float leastSolidAngle(DiskView view) { return PI * view.sineA * view.sineB; }

// A stretched circle gives the azimuth, and the cap up to the rim is uniform in 1 - cos there: the density varies by no
// more than the cosine of the cone's half angle does along the rim, and is uniform for a circular cone.
float unitDiskDensity(DiskView view, float rim) { return (2.0 - rim) / (2.0 * PI * view.sineA * view.sineB); }

LightDirection sampleUnitDisk(DiskView view, float u, float v) {
  CosSin azimuth = cosSinTurn(v);
  float x = view.sineA * azimuth.c;
  float y = view.sineB * azimuth.s;
  float sine2 = max(x * x + y * y, 1e-36);
  float rim = oneMinusCos(min(sine2, 1.0));
  float cap = u * rim;
  float stretch = sqrt(cap * (2.0 - cap) / sine2);
  vec3 wi = view.a * (x * stretch) + view.b * (y * stretch) + view.axis * (1.0 - cap);
  return LightDirection(wi, view.height / max(abs(wi.z), 1e-30), unitDiskDensity(view, rim));
}

// Density of sampleUnitDisk() for a unit direction that meets the disk.
float unitDiskPdf(DiskView view, vec3 wi) {
  float x = dot(wi, view.a);
  float y = dot(wi, view.b);
  float sx = x / view.sineA;
  float sy = y / view.sineB;
  float sine2 = (x * x + y * y) / max(sx * sx + sy * sy, 1e-36);
  return unitDiskDensity(view, oneMinusCos(min(sine2, 1.0)));
}

// Semi-axes u, v, right angles or not: the map makes them a circle, so that a true disk is only scaled.
UnitSpace diskSpace(vec3 p, vec3 centre, vec3 axisU, vec3 axisV) {
  vec3 n = cross(axisU, axisV);
  float inv2 = 1.0 / max(dot(n, n), 1e-36);
  float inv = sqrt(inv2);
  float root = sqrt(inv);
  UnitSpace s;
  s.row0 = cross(axisV, n) * inv2;
  s.row1 = cross(n, axisU) * inv2;
  s.row2 = n * (inv * root);
  s.axis0 = axisU;
  s.axis1 = axisV;
  s.axis2 = n * root;
  s.scale = inv * root;
  s.p = toUnitSpace(s, p - centre);
  return s;
}

// In the disk's plane, too, rounding would decide whether it fills nothing or a hemisphere.
bool diskByArea(DiskView view) { return leastSolidAngle(view) < SMALL_SOLID_ANGLE || view.height < 1e-4; }

LightDirection sampleDisk(vec3 p, vec3 centre, vec3 axisU, vec3 axisV, float u, float v) {
  UnitSpace space = diskSpace(p, centre, axisU, axisV);
  DiskView view = diskView(space.p);
  LightDirection byAngle = toWorldSpace(space, sampleUnitDisk(view, u, v));
  CosSin azimuth = cosSinTurn(v);
  float r = sqrt(u);
  vec3 toPoint = (centre - p) + axisU * (r * azimuth.c) + axisV * (r * azimuth.s);
  LightDirection byArea = towardsPoint(toPoint, cross(axisU, axisV) * PI);
  bool area = diskByArea(view);
  return LightDirection(area ? byArea.wi : byAngle.wi, area ? byArea.distance : byAngle.distance, area ? byArea.pdf : byAngle.pdf);
}

// Density of sampleDisk() for a direction that meets the disk.
float diskPdf(vec3 p, vec3 centre, vec3 axisU, vec3 axisV, vec3 wi) {
  UnitSpace space = diskSpace(p, centre, axisU, axisV);
  DiskView view = diskView(space.p);
  vec3 local = toUnitSpace(space, wi);
  float inv = inversesqrt(max(dot(local, local), 1e-36));
  float byAngle = pdfInWorld(space, unitDiskPdf(view, local * inv), inv);
  return diskByArea(view) ? areaPdf(centre - p, cross(axisU, axisV) * PI, wi) : byAngle;
}

#endif
