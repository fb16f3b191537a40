// SPDX-License-Identifier: MIT
// What a hit shows: its material with textures and colours applied, and the normal that the BSDF is to see. Only meshes
// have texture coordinates; other shapes show the plain material.
#ifndef SHADING_GLSL
#define SHADING_GLSL
#include "material.glsl"
#include "mesh_surface.glsl"
#include "texture.glsl"

struct Shading {
  SurfaceMaterial material;
  vec3 normal;  // unit, on the outer side
};

// Where and how finely textures are looked up.
struct Footprint {
  float width;   // metres on the surface
  float jitter;  // [0, 1), chooses between mip levels
};

// 1 without a texture (row 0).
vec4 textureValue(uint ref, MeshPoint point, Footprint footprint) {
  TextureRef t = fetchTextureRef(ref);
  bool second = (t.bits & TEXEL_UV1) != 0u;
  vec4 value = vec4(1.0);
  if (ref != 0u) {
    uint level = mipLevel(t, footprint.width, second ? point.uvPerMetre.y : point.uvPerMetre.x, footprint.jitter);
    value = lookUp(t, second ? point.uv.z : point.uv.x, second ? point.uv.w : point.uv.y, level);
  }
  return value;
}

// `glow`: that of the emission.
void applyTextures(inout Shading s, vec4 refs, float normalScale, MeshPoint point, Footprint footprint, Footprint glow) {
  vec4 albedo = textureValue(floatBitsToUint(refs.x), point, footprint);
  vec4 facets = textureValue(floatBitsToUint(refs.y), point, footprint);
  uint normalRef = floatBitsToUint(refs.z);
  vec4 bumps = textureValue(normalRef, point, footprint);
  s.material.albedo *= albedo.xyz * point.color.xyz;
  s.material.alpha *= facets.y * facets.y;  // roughness squared
  s.material.metallic *= facets.z;
  if (kEmission) s.material.emission *= textureValue(floatBitsToUint(refs.w), point, glow).xyz;
  float x = (bumps.x * 2.0 - 1.0) * normalScale;
  float y = (bumps.y * 2.0 - 1.0) * normalScale;
  vec3 bent = point.tangent * x + point.bitangent * y + point.normal * (bumps.z * 2.0 - 1.0);
  s.normal = normalRef != 0u ? unitOr(bent, point.normal) : s.normal;
}

// The normal next to `normal` about which d is mirrored to the facet's outer side and from which d does not come from
// behind, so that no reflection is lost to the horizon (Keller et al., The Iray Light Transport Simulation and Rendering
// System, 2017, section A.3). All on wo's side. Just above the horizon, since rounding would decide on it.
vec3 bentNormal(vec3 normal, vec3 facet, vec3 wo) {
  vec3 mirrored = normal * (2.0 * dot(wo, normal)) - wo;
  float lowest = min(0.9 * dot(wo, facet), 0.01);
  float height = dot(mirrored, facet);
  vec3 raised = mirrored + normal * ((lowest - height) / max(dot(normal, facet), 1e-3));
  return height < lowest ? unitOr(wo + unitOr(raised, facet), facet) : normal;
}

// `width`: of the ray's cone where it hits. `rivalled`: light samples look for the same emission, in full resolution, and
// can be weighed against this ray only if it sees the same.
Shading shadingAt(Surface surface, Hit hit, vec3 d, float width, bool rivalled, float jitter, Layout l) {
  Shading s = Shading(fetchMaterial(hit.primitive), surface.normal);
  if (kMeshes && hit.primitive >= l.instance && hit.primitive < l.end) {
    uint row = params.materialRow + hit.primitive * MATERIAL_ROWS;
    vec4 refs = kTextures ? fetchRow(row + 6u) : vec4(0.0);
    uint normalRef = floatBitsToUint(refs.z);
    bool second = kTextures && normalRef != 0u && (fetchTextureRef(normalRef).bits & TEXEL_UV1) != 0u;
    MeshPoint point = meshPoint(surface, hit, second, l);
    s.normal = point.normal;
    if (kTextures) {
      float slant = max(abs(dot(surface.normal, d)), 0.05);
      Footprint footprint = Footprint(width / slant, jitter);
      Footprint glow = Footprint(rivalled ? 0.0 : footprint.width, rivalled ? 0.0 : jitter);
      applyTextures(s, refs, fetchRow(row + 7u).x, point, footprint, glow);
      s.normal = onOuterSide(s.normal, surface.normal);
    }
  }
  return s;
}

#endif
