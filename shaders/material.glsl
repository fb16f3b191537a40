// SPDX-License-Identifier: MIT
// The material of a primitive, and the lobes it shows to one direction.
#ifndef MATERIAL_GLSL
#define MATERIAL_GLSL
#include "bsdf_sampling.glsl"
#include "scene.glsl"

struct SurfaceMaterial {
  vec3 albedo;
  float metallic;
  float alpha;
  float dielectricF0;
  float dielectricF90;
  uint bits;      // FEATURE_* that this material needs, and MATERIAL_*
  vec3 emission;  // nit
  uint light;     // that samples this primitive, or NO_LIGHT
  vec3 absorption;  // 1/m
};

SurfaceMaterial fetchMaterial(uint primitive) {
  uint row = params.materialRow + primitive * MATERIAL_ROWS;
  vec4 a = fetchRow(row);
  vec4 b = fetchRow(row + 1u);
  vec4 c = kEmission ? fetchRow(row + 2u) : vec4(0.0);
  SurfaceMaterial m;
  m.albedo = a.xyz;
  m.metallic = a.w;
  m.alpha = b.x;
  m.dielectricF0 = b.y;
  m.dielectricF90 = b.z;
  m.bits = floatBitsToUint(b.w);
  m.emission = c.xyz;
  m.light = kAreaLights ? floatBitsToUint(c.w) : NO_LIGHT;
  m.absorption = kAbsorption ? fetchRow(row + 4u).xyz : vec3(0.0);
  return m;
}

LobeKinds lobeKinds() {
  bool allNormals = kAblation && (params.flags & TRACE_ALL_NORMALS) != 0u;
  return LobeKinds(kDiffuse, kGlossy, kMirror, kTransmission, kClearcoat, kEdgeTint, allNormals);
}

// Directional albedo of single-scatter facets: F0 * f0 + F90 * f90. The table's axes are fourth roots of alpha and of
// the cosine: smooth facets change within a cosine of alpha.
struct FacetAlbedo {
  float f0;
  float f90;
};

// Between the corners of one cell of such a table.
struct TableCell {
  uint at;
  vec4 weights;
};

// By the places on both axes, in [0, 1].
TableCell cellAt(float alongAlpha, float alongCosine) {
  float cells = float(ENERGY_CELLS);
  float x = alongAlpha * cells;
  float y = alongCosine * cells;
  float column = min(floor(x), cells - 1.0);
  float line = min(floor(y), cells - 1.0);
  float fx = x - column;
  float fy = y - line;
  vec4 weights = vec4((1.0 - fx) * (1.0 - fy), fx * (1.0 - fy), (1.0 - fx) * fy, fx * fy);
  return TableCell(uint(line) * ENERGY_CELLS + uint(column), weights);
}

TableCell tableCell(float alpha, float cosO) { return cellAt(sqrt(sqrt(alpha)), sqrt(sqrt(cosO))); }

FacetAlbedo facetAlbedo(float alpha, float cosO, TableCell cell) {
  float f0 = dot(fetchTable(2u * cell.at), cell.weights);
  float f90 = dot(fetchTable(2u * cell.at + 1u), cell.weights);
  float grazing = pow5(1.0 - cosO);
  bool mirror = alpha < MIRROR_ALPHA;
  return FacetAlbedo(mirror ? 1.0 - grazing : f0, mirror ? grazing : f90);
}

// Turquin 2019: facets of reflectance F0 gain 1 + F0 * this by light scattered more than once.
float multipleScattering(FacetAlbedo albedo) { return 1.0 / (albedo.f0 + albedo.f90) - 1.0; }

// What rough glass (its first row) gives back, reflected and passed. Facets of a sheet lose as those that only reflect
// do.
float glassAlbedo(Lobes lobes, uint table, TableCell cell, FacetAlbedo facets, bool inside) {
  uint first = table + (inside ? GLASS_CELLS : 0u);
  float solid = passesUnscattered(lobes) ? 1.0 : dot(fetchRow(first + cell.at), cell.weights);
  return lobes.thin ? facets.f0 + facets.f90 : solid;
}

// Total reflection begins with a vertical slope: the axis is finest there.
float glassShareAxis(float cosO, float eta) {
  float critical = sqrt(max(1.0 - eta * eta, 0.0));
  float away = cosO - critical;
  float span = away < 0.0 ? critical : 1.0 - critical;
  float root = 0.5 * sqrt(min(abs(away) / span, 1.0));
  return eta < 1.0 ? (away < 0.0 ? 0.5 - root : 0.5 + root) : sqrt(sqrt(cosO));
}

// The share of it that is reflected, which a diffuse lobe below the facets does not see.
float glassReflectedShare(Lobes lobes, uint table, float cosO, bool inside) {
  TableCell cell = cellAt(sqrt(sqrt(lobes.alpha)), glassShareAxis(cosO, lobes.eta));
  uint first = table + GLASS_SHARES + (lobes.thin ? 2u * GLASS_CELLS : inside ? GLASS_CELLS : 0u);
  float share = passesUnscattered(lobes) ? glassReflectance(lobes, cosO) : dot(fetchRow(first + cell.at), cell.weights);
  return min(share, 1.0);
}

bool compensated() { return kCompensation && (params.flags & TRACE_COMPENSATION) != 0u; }

// The coat's lobe; what is left for the base below it.
float applyCoat(inout Lobes lobes, float weight, float alpha, float cosO) {
  float gain = 1.0;
  float reflected = coatReflectance(1.0, pow5(1.0 - cosO));
  if (kCompensation) {
    FacetAlbedo albedo = facetAlbedo(alpha, cosO, tableCell(alpha, cosO));
    bool on = compensated();
    gain = on ? 1.0 + COAT_F0 * multipleScattering(albedo) : gain;
    reflected = on ? gain * (COAT_F0 * albedo.f0 + albedo.f90) : reflected;
  }
  precise float gained = weight * gain;
  lobes.coat = gained;
  lobes.coatAlpha = alpha;
  precise float left = 1.0 - weight * reflected;
  return left;
}

// The lobes seen from wo: cosO its cosine, `inside` a solid or not, `thin` for a sheet that encloses nothing.
Lobes lobesAt(SurfaceMaterial m, uint primitive, float cosO, bool inside, bool thin) {
  Lobes lobes = noLobes();
  uint row = params.materialRow + primitive * MATERIAL_ROWS;
  vec4 glassAndCoat = vec4(0.0, 1.5, 0.0, 1.0);
  if (kTransmission || kClearcoat) glassAndCoat = fetchRow(row + 3u);
  float transmission = kTransmission ? glassAndCoat.x : 0.0;
  bool glass = transmission > 0.0;
  lobes.alpha = m.alpha;
  lobes.thin = thin;
  lobes.eta = inside && !thin ? 1.0 / glassAndCoat.y : glassAndCoat.y;

  // What facets give back: nothing more without compensation.
  float dielectric = 1.0 - m.metallic;
  float schlick = glass ? 0.0 : dielectric;
  float gain = 0.0;      // by multiple scattering, times F0
  float glassGain = 1.0; // the same for what glass reflects and passes, which keep their proportion
  float reflected = 0.0; // albedo of the dielectric's facets, for the diffuse lobe below them
  float mirrored = kTransmission ? glassReflectance(lobes, cosO) : 0.0;  // by glass, of what it gives back
  float least = 0.1;     // chance of a lobe
  if (kCompensation) {
    TableCell cell = tableCell(m.alpha, cosO);
    FacetAlbedo albedo = facetAlbedo(m.alpha, cosO, cell);
    float single = m.dielectricF0 * albedo.f0 + m.dielectricF90 * albedo.f90;
    gain = compensated() ? multipleScattering(albedo) : 0.0;
    reflected = single * (1.0 + m.dielectricF0 * gain);
    if (kTransmission && glass && compensated()) {
      uint table = floatBitsToUint(fetchRow(row + 4u).w);
      glassGain = 1.0 / glassAlbedo(lobes, table, cell, albedo, inside);
      if (kDiffuse) {
        // With the shares known, light that goes round in a solid keeps its weight.
        mirrored = glassReflectedShare(lobes, table, cosO, inside);
        reflected = mirrored;
        least = 0.01;
      }
    }
    reflected = compensated() ? reflected : 0.0;
  }
  float below = kClearcoat ? applyCoat(lobes, glassAndCoat.z, glassAndCoat.w, cosO) : 1.0;
  // `precise`: all variants must round these alike, whatever they know to be 0 or 1.
  precise vec3 metal = (vec3(1.0) + m.albedo * gain) * (m.metallic * below);
  precise float plastic = schlick * ((1.0 + m.dielectricF0 * gain) * below);
  precise vec3 f0 = vec3(plastic * m.dielectricF0) + metal * m.albedo;
  precise vec3 f90 = vec3(plastic * m.dielectricF90) + metal;
  precise vec3 diffuse = m.albedo * (dielectric * (1.0 - transmission) * (1.0 - reflected) * below);
  lobes.f0 = f0;
  lobes.f90 = f90;
  lobes.diffuse = diffuse;
  if (kEdgeTint) lobes.edge = metal * fetchRow(row + 5u).xyz;
  bool atHalfVector = !compensated();
  if (kTransmission && kDiffuse) lobes.diffusePassed = glass && !thin && !atHalfVector ? fetchRow(row + 5u).w : 0.0;
  lobes.dielectricF0 = atHalfVector && !glass ? m.dielectricF0 : 0.0;
  lobes.dielectricF90 = atHalfVector && !glass ? m.dielectricF90 : 0.0;
  lobes.exactLoss = atHalfVector && glass ? 1.0 : 0.0;
  precise float passing = dielectric * below * glassGain;
  lobes.exact = glass ? passing : 0.0;
  precise vec3 transmit = m.albedo * (transmission * passing);
  lobes.transmit = glass ? transmit : vec3(0.0);
  bool facets = kGlossy || kMirror || kTransmission || kClearcoat;
  bool several = kTransmission || kClearcoat || (kDiffuse && facets);
  lobes.chance = facets ? 1.0 : 0.0;
  return several ? withChances(lobes, cosO, mirrored, least, lobeKinds()) : lobes;
}

#endif
