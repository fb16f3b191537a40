// SPDX-License-Identifier: MIT
// Closed forms in long double.
#include "tests/shaders/oracle.hpp"

#include <algorithm>
#include <cmath>

namespace steradian::oracle {
namespace {

constexpr Real pi = 3.141592653589793238462643383279502884L;

std::optional<Interval> slab(Real o, Real d, std::optional<Interval> so) {
  if (!so) return so;
  if (d == 0) return std::fabs(o) <= 1 ? so : std::nullopt;
  const Real a = (-1 - o) / d, b = (1 - o) / d;
  const Interval cut{std::max(so->enter, std::min(a, b)), std::min(so->leave, std::max(a, b))};
  return cut.enter <= cut.leave ? std::optional(cut) : std::nullopt;
}

Real tan2(Vec v) {
  return (v.x * v.x + v.y * v.y) / (v.z * v.z);
}

template <std::size_t N>
Gauss<N> gauss() {
  Gauss<N> g;
  for (std::size_t i = 0; i < N; ++i) {
    double x = std::cos(double(pi) * (double(i) + 0.75) / (double(N) + 0.5)), slope = 1.0;
    for (int newton = 0; newton < 20; ++newton) {
      double p0 = 1.0, p1 = x;
      for (std::size_t k = 2; k <= N; ++k) {
        const double p2 = (double(2 * k - 1) * x * p1 - double(k - 1) * p0) / double(k);
        p0 = p1, p1 = p2;
      }
      slope = double(N) * (x * p1 - p0) / (x * x - 1.0);
      x -= p1 / slope;
    }
    g.x[i] = 0.5 * (1.0 - x);
    g.w[i] = 1.0 / ((1.0 - x * x) * slope * slope);
  }
  return g;
}

}  // namespace

std::optional<Interval> sphere(Vec o, Vec d, Vec centre, Real radius) {
  const Real length2 = glm::dot(d, d), middle = glm::dot(centre - o, d) / length2;
  const Vec closest = o + d * middle - centre;
  const Real half2 = (radius - glm::length(closest)) * (radius + glm::length(closest)) / length2;
  if (half2 < 0) return std::nullopt;
  return Interval{middle - std::sqrt(half2), middle + std::sqrt(half2)};
}

std::optional<Interval> box(Vec o, Vec d) {
  std::optional<Interval> all = Interval{-1e300L, 1e300L};
  for (int axis = 0; axis < 3; ++axis) all = slab(o[axis], d[axis], all);
  return all;
}

std::optional<Interval> cylinder(Vec o, Vec d) {
  const std::optional<Interval> tube =
      d.x == 0 && d.z == 0
          ? (o.x * o.x + o.z * o.z <= 1 ? std::optional(Interval{-1e300L, 1e300L}) : std::nullopt)
          : sphere(Vec(o.x, 0, o.z), Vec(d.x, 0, d.z), Vec(0), 1);
  return slab(o.y, d.y, tube);
}

std::optional<Real> nearest(std::optional<Interval> interval) {
  if (!interval || interval->leave <= 0) return std::nullopt;
  return interval->enter > 0 ? interval->enter : interval->leave;
}

Real ggxD(Vec m, Real alpha) {
  const Real cos2 = m.z * m.z / glm::dot(m, m), k = alpha * alpha + tan2(m);
  return alpha * alpha / (pi * cos2 * cos2 * k * k);
}

Real lambda(Vec v, Real alpha) {
  const Real x = alpha * alpha * tan2(v);
  return x / (2 * (1 + std::sqrt(1 + x)));
}

Real g1(Vec v, Real alpha) {
  return 1 / (1 + lambda(v, alpha));
}
Real g2(Vec o, Vec i, Real alpha) {
  return 1 / (1 + lambda(o, alpha) + lambda(i, alpha));
}

Real visiblePdf(Vec wo, Vec m, Real alpha) {
  return g1(wo, alpha) * std::max(Real(0), glm::dot(wo, m)) * ggxD(m, alpha) / wo.z;
}

Real reflectedPdf(Vec wo, Vec wi, Real alpha) {
  const Vec m = glm::normalize(wo + wi);
  return visiblePdf(wo, m, alpha) / (4 * glm::dot(wo, m));
}

Real schlick(Real f0, Real f90, Real cosine) {
  return f0 + (f90 - f0) * std::pow(1 - cosine, 5.0L);
}

Real fresnel(Real cosine, Real eta) {
  const Real incident = std::acos(cosine), sine = std::sin(incident) / eta;
  if (sine >= 1) return 1;
  if (incident < 1e-6L) return (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
  const Real refracted = std::asin(sine);
  const Real s = std::sin(incident - refracted) / std::sin(incident + refracted);
  const Real p = std::tan(incident - refracted) / std::tan(incident + refracted);
  return (s * s + p * p) / 2;
}

Gauss<8> gauss8() {
  return gauss<8>();
}
Gauss<16> gauss16() {
  return gauss<16>();
}

double chiSquareP(double statistic, double degrees) {
  const double v = 2.0 / (9.0 * degrees);
  return 0.5 * std::erfc((std::cbrt(statistic / degrees) - (1.0 - v)) / std::sqrt(v) / std::sqrt(2.0));
}

}  // namespace steradian::oracle
