// SPDX-License-Identifier: MIT
// The gates: round figures at least four times above what llvmpipe shows in well-conditioned vertices of the
// stock projects. Elsewhere Finding::sensitivity widens them.
#include "renderer/reference/comparison.hpp"

namespace steradian::reference {

const QuantityInfo& infoOf(Quantity quantity) {
  static constexpr QuantityInfo infos[std::size_t(Quantity::count)] = {
      {"camera", "ray direction", 1e-6},
      {"intersection", "primitive", 0.0},
      {"intersection", "distance", 1e-4},
      {"normal", "point", 1e-5},
      {"normal", "normal", 1e-5},
      {"normal", "local direction", 1e-5},
      {"light", "met radiance", 1e-4},
      {"light", "choice", 0.0},
      {"light", "direction", 1e-5},
      {"light", "distance", 1e-5},
      {"light", "illuminance", 1e-4},
      {"light", "pdf", 1e-4},
      {"BSDF", "f cos", 1e-3},
      {"BSDF", "pdf", 1e-3},
      {"light", "visibility", 0.0},
      {"light", "reflected", 1e-3},
      {"BSDF", "sampled direction", 1e-4},
      {"BSDF", "sample weight", 1e-3},
      {"BSDF", "sample pdf", 1e-3},
      {"throughput", "throughput", 1e-3},
  };
  return infos[std::size_t(quantity)];
}

void Summary::add(std::span<const Finding> findings) {
  for (const Finding& f : findings) {
    const std::size_t q = std::size_t(f.quantity);
    compared[q] += 1;
    parted[q] += f.parts() ? 1 : 0;
    if (!worst[q] || !(f.relative <= worst[q]->relative)) worst[q] = &f;
  }
}

}  // namespace steradian::reference
