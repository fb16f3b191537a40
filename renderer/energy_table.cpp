// SPDX-License-Identifier: MIT
#include "renderer/energy_table.hpp"

#include <array>
#include <cmath>

#include "renderer/facet_albedo.hpp"
#include "shaders/gpu_types.h"

namespace steradian {

namespace {

constexpr int cells = int(gpu::ENERGY_CELLS), corners = cells + 1;

// At the corners of the cells, cosine by cosine, evenly in the fourth roots of alpha and of the cosine.
std::vector<FacetAlbedo> albedosAtCorners() {
  const Quadrature rule = gaussLegendre(16);
  std::vector<FacetAlbedo> albedos;
  for (int y = 0; y < corners; ++y)
    for (int x = 0; x < corners; ++x) {
      albedos.push_back(facetAlbedo(std::pow(double(x) / cells, 4), std::pow(double(y) / cells, 4), rule));
    }
  return albedos;
}

std::vector<glm::vec4> cellRows() {
  const std::vector<FacetAlbedo> albedos = albedosAtCorners();
  std::vector<glm::vec4> rows;
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      glm::vec4 f0, f90;
      for (int corner = 0; corner < 4; ++corner) {
        const FacetAlbedo& at = albedos[std::size_t((y + corner / 2) * corners + x + corner % 2)];
        f0[corner] = float(at.f0);
        f90[corner] = float(at.f90);
      }
      rows.insert(rows.end(), {f0, f90});
    }
  return rows;
}

}  // namespace

const std::vector<glm::vec4>& energyTable() {
  static const std::vector<glm::vec4> table = cellRows();
  return table;
}

}  // namespace steradian
