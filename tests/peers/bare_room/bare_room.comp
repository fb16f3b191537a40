#version 460
// SPDX-License-Identifier: MIT
// The thesis room of projects/thesis-room and nothing else: three spheres, six planes and two point lights as constants, GGX
// and Lambert, four path segments, light sampled at every vertex. What a renderer has to offer beyond that is left out, so
// that rays per second of the full tracer have a bar on the same machine. Branch-free inside the loop: CPU drivers run both
// sides of a branch anyway.
layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant) uniform Push {
  uint width;
  uint height;
  uint sampleBegin;
  uint sampleCount;
};
// Read as texels, written as storage: CPU drivers read those several times as fast.
layout(set = 0, binding = 0) uniform samplerBuffer filmBefore;
layout(set = 0, binding = 8) uniform samplerBuffer rows;  // two for each primitive, Surface
layout(set = 0, binding = 1) buffer Film { vec4 film[]; };  // sum of radiance (nit); w: shadow rays
layout(set = 0, binding = 2) buffer Rays { uint closestRays[]; };

const float PI = 3.14159265;
const float EPSILON = 1e-4;  // metres
const float FAR = 1e30;
const uint SEGMENTS = 4u;

const vec4 SPHERES[3] = vec4[](vec4(-1.3, 0.9, -0.9, 0.9), vec4(0.35, 0.65, -1.7, 0.65), vec4(1.4, 0.55, 0.25, 0.55));
const vec3 ROOM_MIN = vec3(-3.2, 0.0, -3.2);
const vec3 ROOM_MAX = vec3(3.2, 3.2, 4.2);
const vec3 LAMP_PLACE[2] = vec3[](vec3(1.6137, 2.5396, 0.8718), vec3(-1.9378, 2.2281, 0.5958));
const vec3 LAMP_POWER[2] = vec3[](vec3(17.0, 14.62, 11.56), vec3(7.92, 9.46, 11.0));  // candela
const vec3 EYE = vec3(0.0, 1.55, 3.9);
const vec3 EYE_UP = vec3(0.0, 0.99599729, -0.08938437);
const vec3 EYE_FORWARD = vec3(0.0, -0.08938437, -0.99599729);
const float TAN_HALF_FOV = 0.46468665;

uint state;

// PCG-RXS-M-XS (O'Neill 2014).
uint randomBits() {
  state = state * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

float randomFloat() { return float(int(randomBits() >> 8)) * 5.9604644775390625e-8; }

// A point of the unit circle: half of it by the sine (Abramowitz & Stegun 4.3.97), the side by a bit that is left.
vec2 randomTurn() {
  uint bits = randomBits();
  float y = float(int(bits) >> 7) * (PI / 33554432.0);
  float y2 = y * y;
  float s = y * (1.0 + y2 * (-0.1666666664 + y2 * (0.0083333315 + y2 * (-0.0001984090 + y2 * 0.0000027526))));
  float c = sqrt(max(1.0 - s * s, 0.0));
  return vec2((bits & 1u) != 0u ? c : -c, s);
}

void nearer(inout float best, inout int which, float t, int primitive) {
  bool closer = t > EPSILON && t < best;
  best = closer ? t : best;
  which = closer ? primitive : which;
}

// Entering root only: no path is ever inside a sphere.
float sphereDistance(vec3 o, vec3 d, vec4 sphere) {
  vec3 f = o - sphere.xyz;
  float b = dot(f, d);
  float disc = b * b - dot(f, f) + sphere.w * sphere.w;
  return disc > 0.0 ? -b - sqrt(disc) : -1.0;
}

bool sphereBlocks(vec3 o, vec3 d, float length2, vec4 sphere) {
  vec3 f = sphere.xyz - o;
  float b = dot(f, d);
  return b > 0.0 && b < length2 && (dot(f, f) - sphere.w * sphere.w) * length2 < b * b;
}

bool planeBlocks(float t) { return t > EPSILON && t < 1.0; }

float closestHit(vec3 o, vec3 d, out int which) {
  float best = FAR;
  which = -1;
  vec3 inverse = 1.0 / d;
  vec3 low = (ROOM_MIN - o) * inverse;
  vec3 high = (ROOM_MAX - o) * inverse;
  for (int i = 0; i < 3; ++i) nearer(best, which, sphereDistance(o, d, SPHERES[i]), i);
  nearer(best, which, low.y, 3);
  nearer(best, which, high.y, 4);
  nearer(best, which, low.x, 5);
  nearer(best, which, high.x, 6);
  nearer(best, which, low.z, 7);
  nearer(best, which, high.z, 8);
  return best;
}

// Whether anything lies between o and o + d.
bool occluded(vec3 o, vec3 d, float length2) {
  bool blocked = false;
  for (int i = 0; i < 3; ++i) blocked = sphereBlocks(o, d, length2, SPHERES[i]) || blocked;
  vec3 inverse = 1.0 / d;
  vec3 low = (ROOM_MIN - o) * inverse;
  vec3 high = (ROOM_MAX - o) * inverse;
  bvec3 crossed = bvec3(planeBlocks(low.x) || planeBlocks(high.x), planeBlocks(low.y) || planeBlocks(high.y),
                        planeBlocks(low.z) || planeBlocks(high.z));
  blocked = blocked || any(crossed);
  return blocked;
}

struct Surface {
  vec3 normal;
  vec3 diffuse;
  vec3 f0;
  float alpha;
};

// Rows: normal = p * a.w + a.xyz (a plane's a.w is 0); albedo, and alpha with the sign of "dielectric".
Surface surfaceAt(vec3 p, int which) {
  vec4 a = texelFetch(rows, 2 * which);
  vec4 b = texelFetch(rows, 2 * which + 1);
  bool metal = b.w < 0.0;
  return Surface(p * a.w + a.xyz, metal ? vec3(0.0) : b.xyz, metal ? b.xyz : vec3(0.04), abs(b.w));
}

float pow5(float x) {
  float x2 = x * x;
  return x2 * x2 * x;
}

// sqrt(alpha^2 + (1 - alpha^2) cos^2), for Smith's masking (Heitz, JCGT 3(2), 2014).
float smith(float cosine, float a2) { return sqrt(a2 + (1.0 - a2) * cosine * cosine); }

// BRDF times cosine: Lambert below Schlick's reflectance, and GGX with height-correlated masking. h = wo + wi, whose digits
// 2 + 2 wo.wi would lose at grazing angles.
vec3 reflected(Surface s, float a2, float cosO, float smithO, float cosI, vec3 h) {
  float length2 = max(dot(h, h), 1e-12);
  vec3 f = s.f0 + (1.0 - s.f0) * pow5(1.0 - min(0.5 * sqrt(length2), 1.0));
  float sum = cosO + cosI;
  float spread = length2 - (1.0 - a2) * min(sum * sum, length2);
  float facets = 0.5 * a2 * length2 * length2 / (spread * spread * (cosI * smithO + cosO * smith(cosI, a2)));
  return ((1.0 - f.x) * s.diffuse + f * facets) * (cosI / PI);
}

vec3 cameraDirection(uvec2 pixel) {
  vec2 at = vec2(pixel) + vec2(randomFloat(), randomFloat());
  vec2 plane = (at - 0.5 * vec2(width, height)) * (2.0 * TAN_HALF_FOV / float(height));
  return normalize(EYE_FORWARD - EYE_UP * plane.y + vec3(plane.x, 0.0, 0.0));
}

// What one vertex knows of the way it was reached.
struct View {
  vec3 p;
  vec3 d;  // of the ray that met it
  float cosO;
  float smithO;
};

// What both lamps send to wo; counts the shadow rays that are wanted.
vec3 lampLight(Surface s, View v, float a2, bool met, inout int shadowRays) {
  vec3 light = vec3(0.0);
  for (int i = 0; i < 2; ++i) {
    vec3 away = LAMP_PLACE[i] - v.p;
    float length2 = dot(away, away);
    float inverse = inversesqrt(length2);
    float cosI = dot(s.normal, away) * inverse;
    vec3 f = reflected(s, a2, v.cosO, v.smithO, cosI, away * inverse - v.d);
    bool wanted = met && cosI > 0.0;
    shadowRays += wanted ? 1 : 0;
    bool arrives = wanted && !occluded(v.p, away, length2);
    light += arrives ? f * LAMP_POWER[i] * (inverse * inverse) : vec3(0.0);
  }
  return light;
}

// Chance to draw the facets, by their share of what is reflected.
float facetChance(Surface s, float cosO) {
  const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);
  float f0 = dot(s.f0, LUMINANCE);
  float facets = f0 + (1.0 - f0) * pow5(1.0 - cosO);
  float below = dot(s.diffuse, LUMINANCE);
  return below > 0.0 ? clamp(facets / (facets + below), 0.1, 0.9) : 1.0;
}

struct Scattered {
  vec3 wi;
  vec3 weight;
  float cosI;  // below 0 the path ends
};

// A direction from the lobe that u falls into, around the normal: a point of the sphere, or of the cap whose sum with the
// stretched view is a visible facet (Dupuy & Benyoub, CGF 42(8), 2023).
Scattered scatter(Surface s, View v, float a2) {
  vec3 n = s.normal;
  float specular = facetChance(s, v.cosO);
  float u = randomFloat();
  vec2 turn = randomTurn();
  bool glossy = u < specular;
  float chance = glossy ? specular : 1.0 - specular;
  u = min((glossy ? u : u - specular) / chance, 0.99999994);
  float side = n.z >= 0.0 ? 1.0 : -1.0;
  float fa = -1.0 / (side + n.z);
  float fb = n.x * n.y * fa;
  vec3 tangent = vec3(1.0 + side * n.x * n.x * fa, side * fb, -side * n.x);
  vec3 bitangent = vec3(fb, side + n.y * n.y * fa, -n.y);
  float stretched = 1.0 / v.smithO;
  float top = glossy ? v.cosO * stretched : 1.0;
  float z = 1.0 - u * (1.0 + top);
  float r = sqrt(max(1.0 - z * z, 0.0)) * (glossy ? s.alpha : 1.0);
  float k = glossy ? a2 * stretched : 0.0;
  vec3 m = tangent * (r * turn.x) + bitangent * (r * turn.y) - v.d * k + n * (z + top - k * v.cosO);
  float inverse = 1.0 / max(dot(m, m), 1e-20);
  float along = glossy ? -2.0 * dot(v.d, m) * inverse : sqrt(inverse);
  vec3 wi = m * along + (glossy ? v.d : vec3(0.0));
  float cosI = dot(n, wi);
  float cosH = min(sqrt(max(0.5 - 0.5 * dot(v.d, wi), 0.0)), 1.0);
  vec3 f = s.f0 + (1.0 - s.f0) * pow5(1.0 - cosH);
  float masking = cosI * (v.cosO + v.smithO) / (cosI * v.smithO + v.cosO * smith(cosI, a2));
  return Scattered(wi, (glossy ? f * masking : (1.0 - f.x) * s.diffuse) / chance, cosI);
}

// Interleaved by rows of groups: some CPU drivers give each thread a fixed half of the groups, and the floor is not the wall.
uvec2 pixelOfInvocation() {
  uint firstHalf = (gl_NumWorkGroups.y + 1u) / 2u;
  uint group = gl_WorkGroupID.y;
  uint row = group < firstHalf ? 2u * group : 2u * (group - firstHalf) + 1u;
  return uvec2(gl_GlobalInvocationID.x, row * gl_WorkGroupSize.y + gl_LocalInvocationID.y);
}

void main() {
  uvec2 pixel = pixelOfInvocation();
  if (pixel.x >= width || pixel.y >= height) return;
  uint at = pixel.y * width + pixel.x;
  vec4 before = texelFetch(filmBefore, int(at));
  uint closest = closestRays[at];
  state = (at * 0x9e3779b9u) ^ (sampleBegin * 0x85ebca6bu);
  randomBits();
  uint samplesLeft = sampleCount;
  vec3 sum = vec3(0.0);
  int shadowRays = 0;
  uint segment = 0u;
  vec3 o = EYE;
  vec3 d = cameraDirection(pixel);
  vec3 throughput = vec3(1.0);
  while (samplesLeft > 0u) {
    int which;
    float t = closestHit(o, d, which);
    closest += 1u;
    bool met = which >= 0;
    vec3 p = o + d * t;
    Surface s = surfaceAt(p, max(which, 0));
    float a2 = s.alpha * s.alpha;
    float cosO = clamp(-dot(s.normal, d), 1e-5, 1.0);
    View v = View(p, d, cosO, smith(cosO, a2));
    sum += throughput * lampLight(s, v, a2, met, shadowRays);
    Scattered next = scatter(s, v, a2);
    throughput *= next.weight;

    segment += 1u;
    bool ended = !met || segment >= SEGMENTS || next.cosI <= 0.0;
    vec3 fresh = cameraDirection(pixel);
    o = ended ? EYE : p;
    d = ended ? fresh : next.wi;
    throughput = ended ? vec3(1.0) : throughput;
    segment = ended ? 0u : segment;
    samplesLeft -= ended ? 1u : 0u;
  }
  film[at] = before + vec4(sum, float(shadowRays));
  closestRays[at] = closest;
}
