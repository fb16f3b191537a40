// SPDX-License-Identifier: MIT
#include "renderer/energy_table.hpp"

#include <cmath>
#include <functional>
#include <future>

#include "renderer/facet_albedo.hpp"
#include "shaders/gpu_types.h"

namespace steradian {

namespace {

constexpr int cells = int(gpu::ENERGY_CELLS), corners = cells + 1;

// The cosine at a place of its axis in [0, 1].
double atFourthRoot(double y) {
  return std::pow(y, 4);
}
// The same about the critical angle within glass: glassShareAxis() in shaders/material.glsl, backwards.
double aboutCrease(double y, double eta) {
  const double critical = std::sqrt(1.0 - eta * eta), away = 2.0 * y - 1.0;
  return critical + away * std::abs(away) * (away < 0.0 ? critical : 1.0 - critical);
}

// Values at the corners of the cells, cosine by cosine, evenly in the fourth root of alpha and along the axis
// of the cosine.
template <class Value, class At, class Cosine>
std::vector<Value> atCorners(const At& at, const Cosine& cosine) {
  std::vector<Value> values;
  for (int y = 0; y < corners; ++y)
    for (int x = 0; x < corners; ++x)
      values.push_back(at(std::pow(double(x) / cells, 4), cosine(double(y) / cells)));
  return values;
}

// A row per cell: its corners.
template <class Value, class Part>
std::vector<glm::vec4> cellRows(const std::vector<Value>& values, const Part& part) {
  std::vector<glm::vec4> rows;
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      glm::vec4& row = rows.emplace_back();
      for (int corner = 0; corner < 4; ++corner)
        row[corner] =
            float(std::invoke(part, values[std::size_t((y + corner / 2) * corners + x + corner % 2)]));
    }
  return rows;
}

std::vector<glm::vec4> energyRows() {
  const Quadrature rule = gaussLegendre(16);
  const auto albedos = atCorners<FacetAlbedo>(
      [&](double alpha, double mu) { return facetAlbedo(alpha, mu, rule); }, atFourthRoot);
  const auto f0 = cellRows(albedos, &FacetAlbedo::f0), f90 = cellRows(albedos, &FacetAlbedo::f90);
  std::vector<glm::vec4> rows;
  for (std::size_t i = 0; i < f0.size(); ++i) rows.insert(rows.end(), {f0[i], f90[i]});
  return rows;
}

template <class Cosine>
std::vector<GlassAlbedo> glassCorners(double eta, const Cosine& cosine, int points = 24) {
  const Quadrature rule = gaussLegendre(points);
  return atCorners<GlassAlbedo>([&](double alpha, double mu) { return glassAlbedo(alpha, mu, eta, rule); },
                                cosine);
}

std::vector<glm::vec4> glassRows(double ior) {
  const double eta = 1.0 / ior;  // seen from within
  auto whiteWithin = std::async(std::launch::async, [eta] { return glassCorners(eta, atFourthRoot); });
  auto sharesWithin = std::async(std::launch::async, [eta] {
    return glassCorners(
        eta, [eta](double y) { return aboutCrease(y, eta); }, 16);
  });
  const std::vector<GlassAlbedo> outside = glassCorners(ior, atFourthRoot);
  std::vector<glm::vec4> rows;
  for (const std::vector<glm::vec4>& more :
       {cellRows(outside, &GlassAlbedo::white), cellRows(whiteWithin.get(), &GlassAlbedo::white),
        cellRows(outside, &GlassAlbedo::reflectedShare),
        cellRows(sharesWithin.get(), &GlassAlbedo::reflectedShare),
        cellRows(outside, &GlassAlbedo::sheetShare)})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace

const std::vector<glm::vec4>& energyTable() {
  static const std::vector<glm::vec4> table = energyRows();
  return table;
}

std::shared_ptr<const std::vector<glm::vec4>> GlassTables::of(float ior) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = tables_.find(ior); known != tables_.end()) return known->second;
  }
  auto made = std::make_shared<const std::vector<glm::vec4>>(glassRows(double(ior)));
  const std::lock_guard lock(mutex_);
  constexpr std::size_t most = 64;  // a slider leaves many behind
  if (tables_.size() >= most) tables_.clear();
  return tables_[ior] = std::move(made);
}

}  // namespace steradian
