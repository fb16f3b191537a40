// SPDX-License-Identifier: MIT
#include "renderer/facet_albedo.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steradian {

namespace {

struct LegendreValue {
  double value, slope;
};
LegendreValue legendre(int degree, double x) {
  double before = 1.0, value = x;
  for (int k = 2; k <= degree; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, degree * (x * value - before) / (x * x - 1.0)};
}

// sqrt(alpha^2 + (1 - alpha^2) cos^2): Smith's Lambda = (length / cos - 1) / 2.
double stretched(double cosine, double alpha) {
  return std::sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
}

// Facets as visible-normal sampling draws them from one view: c evenly over a cap of the unit sphere, h = c +
// v stretched by alpha.
class View {
 public:
  View(double alpha, double mu)
      : alpha_(alpha), cosO_(mu), sinO_(std::sqrt(1.0 - mu * mu)), lengthO_(stretched(mu, alpha)) {}

  double lowest() const { return -cosO_ / lengthO_; }  // of the cap

  struct Facet {
    double cosH, cosI;  // to wo; of the direction reflected
    double upright;     // cosine to the normal
  };
  Facet facet(double z, double cosPhi) const {
    const double vx = alpha_ * sinO_ / lengthO_, r = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double x = alpha_ * (r * cosPhi + vx), hz = z - lowest();
    const double y2 = alpha_ * alpha_ * r * r * (1.0 - cosPhi * cosPhi);
    const double length2 = x * x + y2 + hz * hz, cosine = x * sinO_ + hz * cosO_;
    const double length = std::sqrt(length2);
    return {cosine / length, 2.0 * cosine * hz / length2 - cosO_, hz / length};
  }
  // Where light reflected at this azimuth dips below the horizon: there the integrand has a kink.
  double horizon(double cosPhi) const {
    return edge(cosPhi, [](const Facet& f) { return f.cosI > 0.0; });
  }
  // Where facets begin to reflect totally, from this cosine down, if they do: another kink.
  double crease(double cosPhi, double critical) const {
    return edge(cosPhi, [critical](const Facet& f) { return f.cosH > critical; });
  }
  // Of the direction that the facet refracts to, below the surface if negative; cosT = its cosine to the
  // facet.
  double refracted(const Facet& f, double cosT, double eta) const {
    return f.upright * (f.cosH / eta - cosT) - cosO_ / eta;
  }
  // G1 of one direction
  double masking(double cosI) const { return 2.0 * cosI / (cosI + stretched(cosI, alpha_)); }
  // G2 / G1(wo)
  double weight(double cosI) const {
    const double lengthI = stretched(cosI, alpha_);
    return cosI * (cosO_ + lengthO_) / (cosI * lengthO_ + cosO_ * lengthI);
  }

 private:
  template <class Above>
  double edge(double cosPhi, const Above& isAbove) const {
    double below = lowest(), above = 1.0;
    for (int i = 0; i < 16; ++i) {
      const double middle = 0.5 * (below + above);
      (isAbove(facet(middle, cosPhi)) ? above : below) = middle;
    }
    return above;
  }

  double alpha_, cosO_, sinO_, lengthO_;
};

}  // namespace

Quadrature gaussLegendre(int points) {
  Quadrature made;
  for (int i = 0; i < points; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5));
    for (int step = 0; step < 8; ++step) x -= legendre(points, x).value / legendre(points, x).slope;
    const double slope = legendre(points, x).slope;
    made.x.push_back(0.5 * (1.0 - x));
    made.w.push_back(1.0 / ((1.0 - x * x) * slope * slope));
  }
  return made;
}

namespace {

View viewOf(double alpha, double mu) {
  return View(std::max(alpha, 1e-4), std::clamp(mu, 1e-6, 1.0));
}

// One facet: the share of light that it reflects, and of that and of the rest what is not masked.
struct GlassFacet {
  double reflectance, above, below;
};
GlassFacet throughFacet(const View& view, const View::Facet& facet, double eta) {
  const double cosH = std::clamp(facet.cosH, 0.0, 1.0), cosT2 = 1.0 - (1.0 - cosH * cosH) / (eta * eta);
  const double cosT = std::sqrt(std::max(cosT2, 0.0));
  const double s = (cosH - eta * cosT) / (cosH + eta * cosT), p = (eta * cosH - cosT) / (eta * cosH + cosT);
  const double reflectance = cosT2 > 0.0 ? 0.5 * (s * s + p * p) : 1.0;
  const double below = -view.refracted(facet, cosT, eta);
  return {reflectance, facet.cosI > 0.0 ? view.weight(facet.cosI) : 0.0,
          below > 0.0 ? view.masking(below) : 0.0};
}

}  // namespace

FacetAlbedo facetAlbedo(double alpha, double mu, const Quadrature& rule) {
  const View view = viewOf(alpha, mu);
  const std::size_t turns = rule.x.size();
  FacetAlbedo sum{0.0, 0.0};
  for (std::size_t k = 0; k < turns; ++k) {  // half a turn: the other is its mirror image
    const double cosPhi = std::cos(std::numbers::pi * (double(k) + 0.5) / double(turns));
    const double horizon = view.horizon(cosPhi);
    const double share = (1.0 - horizon) / (1.0 - view.lowest()) / double(turns);
    for (std::size_t i = 0; i < rule.x.size(); ++i) {
      // Smoothstep: even at the pole of the cap, where the radius is a square root, and at the kink.
      const double t = rule.x[i], z = horizon + t * t * (3.0 - 2.0 * t) * (1.0 - horizon);
      const View::Facet facet = view.facet(z, cosPhi);
      const double away = std::max(0.0, 1.0 - facet.cosH), grazing = away * away * away * away * away;
      const double weight = 6.0 * t * (1.0 - t) * rule.w[i] * share * view.weight(std::max(facet.cosI, 0.0));
      sum.f0 += weight * (1.0 - grazing);
      sum.f90 += weight * grazing;
    }
  }
  return sum;
}

GlassAlbedo glassAlbedo(double alpha, double mu, double eta, const Quadrature& rule) {
  const View view = viewOf(alpha, mu);
  const std::size_t turns = rule.x.size();
  const double critical = std::sqrt(std::max(1.0 - eta * eta, 0.0));
  GlassAlbedo sum;
  double facets = 0.0;  // if they reflected all
  for (std::size_t k = 0; k < turns; ++k) {
    const double cosPhi = std::cos(std::numbers::pi * (double(k) + 0.5) / double(turns));
    // Apart on the sides of the kinks; smoothstep as above.
    const double horizon = view.horizon(cosPhi),
                 crease = critical > 0.0 ? view.crease(cosPhi, critical) : 1.0;
    const double ends[] = {view.lowest(), std::min(horizon, crease), std::max(horizon, crease), 1.0};
    for (std::size_t i = 0; i < 3 * rule.x.size(); ++i) {
      const double low = ends[i % 3], high = ends[i % 3 + 1], t = rule.x[i / 3];
      if (low >= high) continue;
      const double z = low + t * t * (3.0 - 2.0 * t) * (high - low);
      const double share = (high - low) / (1.0 - view.lowest()) / double(turns);
      const GlassFacet facet = throughFacet(view, view.facet(z, cosPhi), eta);
      const double weight = 6.0 * t * (1.0 - t) * rule.w[i / 3] * share, r = facet.reflectance;
      sum.reflected += weight * r * facet.above;
      sum.transmitted += weight * (1.0 - r) * facet.below;
      sum.sheetShare += weight * 2.0 * r / (1.0 + r) * facet.above;
      facets += weight * facet.above;
    }
  }
  sum.sheetShare /= facets;
  return sum;
}

}  // namespace steradian
