// SPDX-License-Identifier: MIT
// Warps from the unit square to the directions under which a point sees a light, and their densities per solid angle.
// A density of 0 means that the point sees nothing of the light. Binding-free.
#ifndef LIGHT_SAMPLING_GLSL
#define LIGHT_SAMPLING_GLSL
#include "sampling.glsl"

// Rects of a smaller or larger solid angle are sampled by area: there the spherical warp rounds badly.
const float SMALL_SOLID_ANGLE = 1e-4;
const float LARGE_SOLID_ANGLE = 6.2;

struct LightDirection {
  vec3 wi;         // unit
  float distance;  // to the light
  float pdf;       // per solid angle
};

// 1 - cos from sin^2, for angles up to a right one, without cancellation.
float oneMinusCos(float sin2) { return sin2 / (1.0 + sqrt(1.0 - sin2)); }

// Direction at x = 1 - cos from a unit axis.
vec3 coneDirection(vec3 axis, float x, float turn) {
  CosSin azimuth = cosSinTurn(turn);
  float sine = sqrt(x * (2.0 - x));
  Frame frame = frameAround(axis);
  return frame.t * (azimuth.c * sine) + frame.b * (azimuth.s * sine) + axis * (1.0 - x);
}

// Density of uniform directions in the cone that ends at x = 1 - cos; 2 is the whole sphere.
float conePdf(float x) { return 1.0 / (2.0 * PI * x); }

// A sphere as a point sees it: the cone that it fills, which is everything from inside. On its own surface rounding
// would decide between outside and inside: there the cone is the hemisphere towards the centre, right for both.
struct SphereView {
  vec3 axis;
  float distance2;  // to the centre
  float cone;       // 1 - cos of its half angle
  bool inside;
  bool touching;
};

SphereView sphereView(vec3 p, vec3 centre, float radius) {
  vec3 f = centre - p;
  float d2 = dot(f, f);
  float inv = inversesqrt(max(d2, 1e-36));
  float rounding = 1e-5 * radius + 5e-7 * (abs(centre.x) + abs(centre.y) + abs(centre.z));
  SphereView view;
  view.axis = d2 > 1e-36 ? f * inv : vec3(0.0, 0.0, 1.0);
  view.distance2 = d2;
  view.inside = d2 * inv < radius - rounding;
  view.touching = !view.inside && d2 <= radius * radius;
  float seen = view.touching ? 1.0 : oneMinusCos(min(radius * radius * inv * inv, 1.0));
  view.cone = view.inside ? 2.0 : seen;
  return view;
}

LightDirection sampleSphere(vec3 p, vec3 centre, float radius, float u, float v) {
  SphereView view = sphereView(p, centre, radius);
  float x = u * view.cone;
  float along = sqrt(view.distance2) * (1.0 - x);
  float chord = sqrt(max(radius * radius - view.distance2 * x * (2.0 - x), 0.0));
  float t = view.inside ? along + chord : max(along - chord, 0.0);
  return LightDirection(coneDirection(view.axis, x, v), t, conePdf(view.cone));
}

// Density of sampleSphere() for a direction that meets the sphere.
float spherePdf(vec3 p, vec3 centre, float radius, vec3 wi) {
  SphereView view = sphereView(p, centre, radius);
  bool sampled = !view.touching || dot(wi, view.axis) > 0.0;
  return sampled ? conePdf(view.cone) : 0.0;
}

// Angle of the point (x, y), y >= 0, from the x axis, in [0, pi]: reduced to an eighth turn, then a minimax polynomial
// (Moshier, Cephes atanf). Vulkan's own atan may err by 4096 ulp.
float angleOf(float x, float y) {
  float low = min(abs(x), y);
  float high = max(abs(x), y);
  bool wide = low > 0.41421356 * high;
  float t = (wide ? low - high : low) / max(wide ? low + high : high, 1e-36);
  float t2 = t * t;
  float series = (((8.05374449538e-2 * t2 - 1.38776856032e-1) * t2 + 1.99777106478e-1) * t2 - 3.33329491539e-1) * t2 * t + t;
  float angle = wide ? series + 0.25 * PI : series;
  angle = y > abs(x) ? 0.5 * PI - angle : angle;
  return x < 0.0 ? PI - angle : angle;
}

// A rectangle in its own axes around the point that looks at it.
struct RectView {
  vec3 ex;  // unit, along its edges
  vec3 ey;
  vec3 ez;
  float x0;
  float x1;
  float y0;
  float y1;
  float z;           // of its plane
  float solidAngle;  // 0 for a parallelogram without right angles
};

// Two triangles of the same numerator (Van Oosterom & Strackee 1983), whose half angles add as complex numbers do.
float rectSolidAngle(float x0, float x1, float y0, float y1, float z) {
  vec3 a = vec3(x0, y0, z);
  vec3 b = vec3(x1, y0, z);
  vec3 c = vec3(x1, y1, z);
  vec3 d = vec3(x0, y1, z);
  float la = length(a);
  float lb = length(b);
  float lc = length(c);
  float ld = length(d);
  float ac = la * lc + dot(a, c);
  float abc = ac * lb + dot(a, b) * lc + dot(b, c) * la;
  float acd = ac * ld + dot(c, d) * la + dot(a, d) * lc;
  float volume = abs(z) * (x1 - x0) * (y1 - y0);
  float scale = 1.0 / max(max(abs(abc), abs(acd)), max(volume, 1e-36));
  abc *= scale;
  acd *= scale;
  volume *= scale;
  return 2.0 * angleOf(abc * acd - volume * volume, max(volume * (abc + acd), 0.0));
}

// Half edges u, v.
RectView rectView(vec3 p, vec3 centre, vec3 u, vec3 v) {
  float lu = length(u);
  float lv = length(v);
  RectView view;
  view.ex = u / lu;
  view.ey = v / lv;
  view.ez = cross(view.ex, view.ey);
  vec3 f = centre - p;
  float x = dot(f, view.ex);
  float y = dot(f, view.ey);
  view.x0 = x - lu;
  view.x1 = x + lu;
  view.y0 = y - lv;
  view.y1 = y + lv;
  view.z = dot(f, view.ez);
  bool square = abs(dot(view.ex, view.ey)) < 1e-5;
  view.solidAngle = square ? rectSolidAngle(view.x0, view.x1, view.y0, view.y1, view.z) : 0.0;
  return view;
}

bool sampledByArea(RectView view) {
  return view.solidAngle < SMALL_SOLID_ANGLE || view.solidAngle > LARGE_SOLID_ANGLE;
}

// The x at which the part of the rectangle before it has the share u of its solid angle (Urena, Fajardo & King, CGF
// 32(4), 2013, eq. 8-14), with sines and cosines of the inner angles in place of the angles.
float rectX(RectView view, float u) {
  float z2 = view.z * view.z;
  float a2 = 1.0 / (view.x0 * view.x0 + z2);
  float w0 = 1.0 / (view.y0 * view.y0 + z2);
  float w1 = 1.0 / (view.y1 * view.y1 + z2);
  float a = view.x0 * sqrt(a2);
  float b0 = -view.y0 * sqrt(w0);
  float b1 = view.y1 * sqrt(w1);
  float sine2 = sqrt(z2 * (a2 + a * a * w1));
  float sine3 = sqrt(z2 * (a2 + a * a * w0));
  float cosK = a * a * b0 * b1 - sine2 * sine3;
  float sinK = -a * (sine2 * b0 + sine3 * b1);
  CosSin part = cosSinTurn(u * view.solidAngle * (0.5 / PI));
  float c = cosK * part.c - sinK * part.s;
  float s = sinK * part.c + cosK * part.s;
  float q = c * b0 - b1;
  float root = sqrt(max(q * q - s * s * z2 * w0, 1e-36));
  float x = abs(view.z) * s / (q < 0.0 ? -root : root);
  return clamp(x, view.x0, view.x1);
}

// Uniform in the rectangle's solid angle (the same paper).
LightDirection sampleRectDirections(RectView view, float u, float v) {
  float x = rectX(view, u);
  float d2 = x * x + view.z * view.z;
  float h0 = view.y0 * inversesqrt(d2 + view.y0 * view.y0);
  float h1 = view.y1 * inversesqrt(d2 + view.y1 * view.y1);
  float h = h0 + v * (h1 - h0);
  float y = clamp(h * sqrt(d2 / max(1.0 - h * h, 1e-12)), view.y0, view.y1);
  float t2 = d2 + y * y;
  float inv = inversesqrt(t2);
  vec3 wi = (view.ex * x + view.ey * y + view.ez * view.z) * inv;
  return LightDirection(wi, t2 * inv, 1.0 / view.solidAngle);
}

// Towards a point of a flat light that was chosen uniformly by area; `area` is its area times its normal.
LightDirection towardsPoint(vec3 toPoint, vec3 area) {
  float t2 = max(dot(toPoint, toPoint), 1e-36);
  float inv = inversesqrt(t2);
  vec3 wi = toPoint * inv;
  return LightDirection(wi, t2 * inv, t2 / max(abs(dot(wi, area)), 1e-36));
}

// Density of the same for a direction that meets the light's plane; toLight ends anywhere in that plane.
float areaPdf(vec3 toLight, vec3 area, vec3 wi) {
  float cosine = max(abs(dot(wi, area)), 1e-36);
  float t = dot(toLight, area) / cosine;
  return t * t / cosine;
}

LightDirection sampleRect(vec3 p, vec3 centre, vec3 halfU, vec3 halfV, float u, float v) {
  RectView view = rectView(p, centre, halfU, halfV);
  vec3 toPoint = (centre - p) + halfU * (2.0 * u - 1.0) + halfV * (2.0 * v - 1.0);
  LightDirection byArea = towardsPoint(toPoint, cross(halfU, halfV) * 4.0);
  LightDirection byAngle = sampleRectDirections(view, u, v);
  bool area = sampledByArea(view);
  return LightDirection(area ? byArea.wi : byAngle.wi, area ? byArea.distance : byAngle.distance, area ? byArea.pdf : byAngle.pdf);
}

// Density of sampleRect() for a direction that meets the rectangle.
float rectPdf(vec3 p, vec3 centre, vec3 halfU, vec3 halfV, vec3 wi) {
  RectView view = rectView(p, centre, halfU, halfV);
  float byArea = areaPdf(centre - p, cross(halfU, halfV) * 4.0, wi);
  return sampledByArea(view) ? byArea : 1.0 / view.solidAngle;
}

// Semi-axes u, v, right angles or not.
LightDirection sampleDisk(vec3 p, vec3 centre, vec3 axisU, vec3 axisV, float u, float v) {
  CosSin azimuth = cosSinTurn(v);
  float r = sqrt(u);
  vec3 toPoint = (centre - p) + axisU * (r * azimuth.c) + axisV * (r * azimuth.s);
  return towardsPoint(toPoint, cross(axisU, axisV) * PI);
}

// Density of sampleDisk() for a direction that meets the disk.
float diskPdf(vec3 p, vec3 centre, vec3 axisU, vec3 axisV, vec3 wi) {
  return areaPdf(centre - p, cross(axisU, axisV) * PI, wi);
}

// Whether wi lies within x = 1 - cos of a unit axis: by the chord, whose square is 2 (1 - cos).
bool inCone(vec3 wi, vec3 axis, float x) {
  vec3 chord = wi - axis;
  return dot(chord, chord) <= 2.0 * x;
}

#endif
