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

// Values at the corners of the cells, cosine by cosine, evenly in the fourth roots of alpha and of the
// cosine.
template <class Value, class At>
std::vector<Value> atCorners(const At& at) {
  std::vector<Value> values;
  for (int y = 0; y < corners; ++y)
    for (int x = 0; x < corners; ++x)
      values.push_back(at(std::pow(double(x) / cells, 4), std::pow(double(y) / cells, 4)));
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
  const auto albedos =
      atCorners<FacetAlbedo>([&](double alpha, double mu) { return facetAlbedo(alpha, mu, rule); });
  const auto f0 = cellRows(albedos, &FacetAlbedo::f0), f90 = cellRows(albedos, &FacetAlbedo::f90);
  std::vector<glm::vec4> rows;
  for (std::size_t i = 0; i < f0.size(); ++i) rows.insert(rows.end(), {f0[i], f90[i]});
  return rows;
}

std::vector<glm::vec4> glassSide(double eta) {
  const Quadrature rule = gaussLegendre(24);
  return cellRows(
      atCorners<double>([&](double alpha, double mu) { return glassAlbedo(alpha, mu, eta, rule).white(); }),
      std::identity());
}

std::vector<glm::vec4> glassRows(double ior) {
  auto within = std::async(std::launch::async, glassSide, 1.0 / ior);
  std::vector<glm::vec4> rows = glassSide(ior);
  const std::vector<glm::vec4> more = within.get();
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
