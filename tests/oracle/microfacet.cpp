// SPDX-License-Identifier: MIT
#include "tests/oracle/microfacet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steradian::oracle {
namespace {

constexpr double pi = std::numbers::pi;

double tangentSquared(double cosTheta) {
  return std::max(0.0, 1.0 - cosTheta * cosTheta) / (cosTheta * cosTheta);
}

AlbedoTable::Row mirror(double mu, double ior) {
  const double outside = fresnelDielectric(mu, 1.0, ior), inside = fresnelDielectric(mu, ior, 1.0);
  return {1.0, schlickWeight(mu), outside, inside, 1.0 - outside, 1.0 - inside};
}

/// What of the light along the refraction of mu at a facet gets out between the others: 0 where it is
/// reflected totally or stays above the horizon; eta = index here / index there.
double passed(double alpha, double mu, double cosH, double c, double eta) {
  const double cosT2 = 1.0 - eta * eta * (1.0 - c * c);
  if (cosT2 <= 0.0) return 0.0;
  const double cosI = eta * mu - (eta * c - std::sqrt(cosT2)) * cosH;
  if (cosI <= 0.0) return 0.0;
  return (1.0 - fresnelDielectric(c, eta, 1.0)) /
         ((1.0 + smithLambda(alpha, mu)) * (1.0 + smithLambda(alpha, cosI)));
}

AlbedoTable::Row sum(const AlbedoTable::Row& a, double u, const AlbedoTable::Row& b, double v) {
  return {u * a.white + v * b.white,
          u * a.grazing + v * b.grazing,
          u * a.exactOutside + v * b.exactOutside,
          u * a.exactInside + v * b.exactInside,
          u * a.passedOutside + v * b.passedOutside,
          u * a.passedInside + v * b.passedInside};
}

}  // namespace

double ggxD(double alpha, double cosTheta) {
  if (cosTheta <= 0.0) return 0.0;
  const double cos2 = cosTheta * cosTheta;
  const double e = 1.0 + tangentSquared(cosTheta) / (alpha * alpha);
  return 1.0 / (pi * alpha * alpha * cos2 * cos2 * e * e);
}

double smithLambda(double alpha, double cosTheta) {
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangentSquared(cosTheta)) - 1.0);
}

double smithG2(double alpha, double cosO, double cosI) {
  return 1.0 / (1.0 + smithLambda(alpha, cosO) + smithLambda(alpha, cosI));
}

double schlickWeight(double cosTheta) {
  const double x = 1.0 - std::min(cosTheta, 1.0);
  return x * x * x * x * x;
}

double fresnelDielectric(double cosTheta, double etaO, double etaT) {
  const double sinT = etaO / etaT * std::sqrt(std::max(0.0, 1.0 - cosTheta * cosTheta));
  if (sinT >= 1.0) return 1.0;
  const double cosT = std::sqrt(1.0 - sinT * sinT);
  const double s = (etaO * cosTheta - etaT * cosT) / (etaO * cosTheta + etaT * cosT);
  const double p = (etaT * cosTheta - etaO * cosT) / (etaT * cosTheta + etaO * cosT);
  return 0.5 * (s * s + p * p);
}

glm::dvec3 fresnelF82(const glm::dvec3& f0, const glm::dvec3& edgeTint, double cosTheta) {
  constexpr double edge = 1.0 / 7.0;
  const auto schlick = [&](double c) { return f0 + (1.0 - f0) * schlickWeight(c); };
  const glm::dvec3 a = schlick(edge) * (1.0 - edgeTint) / (edge * std::pow(1.0 - edge, 6.0));
  return schlick(cosTheta) - a * (cosTheta * std::pow(1.0 - std::min(cosTheta, 1.0), 6.0));
}

AlbedoTable::AlbedoTable(double alpha, double ior) : alpha_(alpha), ior_(ior) {
  constexpr int points = 4096;
  for (int i = 0; i < points; ++i) {  // 2 cos d(cos) = d(cos^2)
    const double cos2 = (i + 0.5) / points;
    meanFromAir_ += (1.0 - fresnelDielectric(std::sqrt(cos2), 1.0, ior)) / points;
  }
  if (alpha < kMirrorAlpha) return;
  constexpr int last = 128;
  for (int i = 0; i <= last; ++i) {
    const double root = std::max(double(i), 0.01) / last;
    rows_.push_back(integrate(root * root));
  }
}

// Over half vectors h with density D cos(theta_h), that is tan^2(theta_h) = alpha^2 s / (1 - s) for even s:
// albedo = E[F G2 (wo.h) / (mu cos(theta_h))], as d(wi) = 4 (wo.h) d(h). Midpoint rule in v, s = 1 - v^3,
// which looks closely at the long tail.
AlbedoTable::Row AlbedoTable::integrate(double mu) const {
  constexpr int nS = 160, nPhi = 96;
  const double sinO = std::sqrt(std::max(0.0, 1.0 - mu * mu));
  Row total{0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < nS; ++i) {
    const double v = (i + 0.5) / nS, tail = v * v * v;
    const double cosH = 1.0 / std::sqrt(1.0 + alpha_ * alpha_ * (1.0 - tail) / tail);
    const double sinH = std::sqrt(1.0 - cosH * cosH);
    for (int j = 0; j < nPhi; ++j) {  // half the circle, by symmetry
      const double c = mu * cosH + sinO * sinH * std::cos(pi * (j + 0.5) / nPhi);
      if (c <= 0.0) continue;
      const double weight = c / (mu * cosH) * 3.0 * v * v / (nS * nPhi);
      total.passedOutside += weight * passed(alpha_, mu, cosH, c, 1.0 / ior_);
      total.passedInside += weight * passed(alpha_, mu, cosH, c, ior_);
      const double cosI = 2.0 * c * cosH - mu;
      if (cosI <= 0.0) continue;
      Row mirrored = mirror(c, ior_);
      mirrored.passedOutside = mirrored.passedInside = 0.0;
      total = sum(total, 1.0, mirrored, weight * smithG2(alpha_, mu, cosI));
    }
  }
  return total;
}

AlbedoTable::Row AlbedoTable::at(double mu) const {
  if (rows_.empty()) return mirror(mu, ior_);
  const double x = std::sqrt(std::clamp(mu, 0.0, 1.0)) * double(rows_.size() - 1);
  const std::size_t i = std::min(std::size_t(x), rows_.size() - 2);
  return sum(rows_[i], 1.0 - (x - double(i)), rows_[i + 1], x - double(i));
}

}  // namespace steradian::oracle
