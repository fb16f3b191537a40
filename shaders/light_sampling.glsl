// SPDX-License-Identifier: MIT
// Warps from the unit square to the directions under which a point sees a light, and their densities per solid angle.
// A density of 0 means that the point sees nothing of the light. Binding-free.
#ifndef LIGHT_SAMPLING_GLSL
#define LIGHT_SAMPLING_GLSL
#include "sampling.glsl"

// Rects and triangles of a smaller or larger solid angle are sampled by area: there the spherical warp rounds badly.
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
// would decide between outside and inside: there the cone is the hemisphere towards the centre, right for both, and what is
// met along it is the far side.
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
  view.touching = !view.inside && d2 * inv <= radius + rounding;
  float seen = view.touching ? 1.0 : oneMinusCos(min(radius * radius * inv * inv, 1.0));
  view.cone = view.inside ? 2.0 : seen;
  return view;
}

LightDirection sampleSphere(vec3 p, vec3 centre, float radius, float u, float v) {
  SphereView view = sphereView(p, centre, radius);
  float x = u * view.cone;
  float along = sqrt(view.distance2) * (1.0 - x);
  float chord = sqrt(max(radius * radius - view.distance2 * x * (2.0 - x), 0.0));
  float t = view.inside || view.touching ? along + chord : max(along - chord, 0.0);
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

// A rectangle in its own axes around the point that looks at it, corners a b c d at (x0, y0), (x1, y0), (x1, y1), (x0, y1).
struct RectView {
  vec3 ex;  // unit, along its edges
  vec3 ey;
  vec3 ez;
  float x0;
  float x1;
  float y0;
  float y1;
  float z;           // of its plane
  float halfAbc;     // half of triangle abc's solid angle
  float solidAngle;  // 0 for a parallelogram without right angles
};

// Half of the solid angle of a triangle whose corners lie in these unit directions (Van Oosterom & Strackee 1983); their
// triple product is known without cancellation.
float halfSolidAngle(vec3 a, vec3 b, vec3 c, float product) {
  return angleOf(1.0 + dot(a, b) + dot(b, c) + dot(c, a), product);
}

// Adds the solid angle, of two triangles.
RectView withSolidAngle(RectView view) {
  vec3 a = vec3(view.x0, view.y0, view.z);
  vec3 b = vec3(view.x1, view.y0, view.z);
  vec3 c = vec3(view.x1, view.y1, view.z);
  vec3 d = vec3(view.x0, view.y1, view.z);
  float ia = inversesqrt(dot(a, a));
  float ib = inversesqrt(dot(b, b));
  float ic = inversesqrt(dot(c, c));
  float id = inversesqrt(dot(d, d));
  float height = abs(view.z) * ia;
  float width = (view.x1 - view.x0) * ic;
  float depth = view.y1 - view.y0;
  view.halfAbc = halfSolidAngle(a * ia, b * ib, c * ic, height * width * (depth * ib));
  view.solidAngle = 2.0 * (view.halfAbc + halfSolidAngle(a * ia, d * id, c * ic, height * width * (depth * id)));
  return view;
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
  view.halfAbc = 0.0;
  view.solidAngle = 0.0;
  bool square = abs(dot(view.ex, view.ey)) < 1e-5;
  return square ? withSolidAngle(view) : view;
}

bool sampledByArea(float solidAngle) { return solidAngle < SMALL_SOLID_ANGLE || solidAngle > LARGE_SOLID_ANGLE; }

// 1 + cosine of the angle between two unit vectors, also of nearly opposite ones.
float onePlusCos(vec3 a, vec3 b) {
  vec3 sum = a + b;
  return 0.5 * dot(sum, sum);
}

// Where on triangle (a, e, c), whose corners are seen from the origin, a direction that is uniform in its solid angle
// meets it: x of the way from e to c, then y of the way from a to there. The great circle through corner a leaves half
// solid angles of these sines beside e and beside c, by v the direction lies on it (Arvo, SIGGRAPH 1995). Van Oosterom &
// Strackee's formula, solved for the circle's end on the edge e c, is a sum of positive terms, in which no digits are lost.
vec2 placeInTriangle(vec3 a, vec3 e, vec3 c, float near, float far, float v) {
  float ia = inversesqrt(dot(a, a));
  float ie = inversesqrt(dot(e, e));
  float ic = inversesqrt(dot(c, c));
  float ec = onePlusCos(e * ie, c * ic);
  float rest = far * sqrt(2.0 * ec * onePlusCos(a * ia, c * ic) / onePlusCos(a * ia, e * ie));
  float weightE = rest * (rest + 2.0 * near) * ie;
  float weightC = 2.0 * near * (rest + near * ec) * ic;
  float across = weightC / (weightE + weightC);
  vec3 end = e + (c - e) * across;

  float iEnd = inversesqrt(dot(end, end));
  float x = 1.0 - dot(a, end) * (ia * iEnd);
  float end2 = sqrt(v * (2.0 - v * x) / (2.0 - x));
  float weightEnd = end2 * iEnd;
  float weightA = max(1.0 - v * x - (1.0 - x) * end2, 0.0) * ia;
  return vec2(across, weightEnd / (weightA + weightEnd));
}

// Uniform in the rectangle's solid angle: the great circle by u cuts off 2 near beside the neighbour e = b or d of a.
LightDirection sampleRectDirections(RectView view, float u, float v) {
  float cut = u * 0.5 * view.solidAngle;
  bool first = cut < view.halfAbc;
  vec3 a = vec3(view.x0, view.y0, view.z);
  vec3 e = vec3(first ? view.x1 : view.x0, first ? view.y0 : view.y1, view.z);
  vec3 c = vec3(view.x1, view.y1, view.z);
  float near = cosSinTurn((first ? cut : 0.5 * view.solidAngle - cut) * (0.5 / PI)).s;
  float far = cosSinTurn(abs(view.halfAbc - cut) * (0.5 / PI)).s;
  vec2 place = placeInTriangle(a, e, c, near, far, v);
  vec3 end = e + (c - e) * place.x;
  vec3 at = a + (end - a) * place.y;
  float t2 = dot(at, at);
  float inv = inversesqrt(t2);
  vec3 wi = (view.ex * at.x + view.ey * at.y + view.ez * at.z) * inv;
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
  bool area = sampledByArea(view.solidAngle);
  return LightDirection(area ? byArea.wi : byAngle.wi, area ? byArea.distance : byAngle.distance, area ? byArea.pdf : byAngle.pdf);
}

// Density of sampleRect() for a direction that meets the rectangle.
float rectPdf(vec3 p, vec3 centre, vec3 halfU, vec3 halfV, vec3 wi) {
  RectView view = rectView(p, centre, halfU, halfV);
  float byArea = areaPdf(centre - p, cross(halfU, halfV) * 4.0, wi);
  return sampledByArea(view.solidAngle) ? byArea : 1.0 / view.solidAngle;
}

// Whether wi lies within x = 1 - cos of a unit axis: by the chord, whose square is 2 (1 - cos).
bool inCone(vec3 wi, vec3 axis, float x) {
  vec3 chord = wi - axis;
  return dot(chord, chord) <= 2.0 * x;
}

#endif
