// SPDX-License-Identifier: MIT
// What the shaders should answer, in long double, written from the papers by other formulas than the GLSL.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>

namespace steradian::oracle {

using Real = long double;
using Vec = glm::vec<3, Real>;

inline Vec vec(glm::dvec3 v) {
  return Vec(v);
}

/// Distances (in units of the length of d) at which a ray enters and leaves a convex shape.
struct Interval {
  Real enter, leave;
};

/// By the point of closest approach. Absent = miss.
std::optional<Interval> sphere(Vec o, Vec d, Vec centre, Real radius);
/// Unit shapes; what the ray's line has in common with each.
std::optional<Interval> box(Vec o, Vec d);
std::optional<Interval> cylinder(Vec o, Vec d);
/// Nearest positive distance of an interval; absent = behind.
std::optional<Real> nearest(std::optional<Interval> interval);

/// GGX in the tan^2 form (Walter et al. 2007, eq. 33); m of any length.
Real ggxD(Vec m, Real alpha);
/// Smith's Lambda and masking (Walter et al. 2007, eq. 34; Heitz 2014, eq. 72 and 99).
Real lambda(Vec v, Real alpha);
Real g1(Vec v, Real alpha);
Real g2(Vec o, Vec i, Real alpha);
/// Density of visible-normal sampling over half vectors, then over reflected directions (Heitz 2014, eq. 2).
Real visiblePdf(Vec wo, Vec m, Real alpha);
Real reflectedPdf(Vec wo, Vec wi, Real alpha);
Real schlick(Real f0, Real f90, Real cosine);
/// Fresnel's equations for unpolarized light by angles; eta = n transmitted / n incident.
Real fresnel(Real cosine, Real eta);

/// Gauss-Legendre nodes on [0, 1] and their weights.
template <std::size_t N>
struct Gauss {
  std::array<double, N> x, w;
};
Gauss<8> gauss8();
Gauss<16> gauss16();

/// Chi-square survival function by Wilson and Hilferty's cube root (good to 1e-3 beyond 30 degrees of
/// freedom).
double chiSquareP(double statistic, double degrees);

}  // namespace steradian::oracle
