// SPDX-License-Identifier: MIT
// What is compared of two paths, how, and how far the device may be off before it is more than rounding.
#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace steradian::reference {

enum class Quantity {
  camera,     // direction of the first ray
  primitive,  // that a ray meets
  distance,   // to it
  point,      // on its surface
  normal,
  outgoing,  // direction towards the viewer in the local frame
  met,       // radiance that the path met by itself
  light,     // that a slot chose
  lightDirection,
  lightDistance,
  illuminance,
  lightPdf,
  bsdf,  // towards the light, times the cosine
  bsdfPdf,
  visibility,
  reflected,  // light that the slot sends along the path
  nextDirection,
  nextWeight,
  nextPdf,
  throughput,
  count
};

/// The stage that a quantity belongs to, as messages name it: intersection, normal, BSDF, light ...
struct QuantityInfo {
  const char* stage;
  const char* name;
  double gate;  // largest relative difference that rounding explains where the stage is well conditioned
};
const QuantityInfo& infoOf(Quantity quantity);

/// One quantity at one vertex: the device against double, both from the device's own inputs.
struct Finding {
  Quantity quantity;
  int vertex = 0;
  int slot = -1;                  // of a light; -1 = none
  double relative = 0.0;          // |device - double| / the larger; 1 for a discrete difference
  std::string device, reference;  // as text
  glm::dvec3 value{0.0};          // the reference, to be compared with others
  double scale = 1.0;             // what `relative` is relative to
  double sensitivity = 0.0;  // how far inputs that are off by 4 units in the last place move the reference

  /// More than the stage's gate, and more than the rounding of its inputs can explain (Higham, Accuracy and
  /// Stability of Numerical Algorithms, 2002, section 1.5: forward error <= condition * backward error).
  double allowed() const { return infoOf(quantity).gate + allowedSensitivity * sensitivity; }
  bool parts() const { return !(relative <= allowed()); }
  static constexpr double allowedSensitivity = 8.0;
};

/// The largest of each quantity over many findings; `of` is null where none was compared.
struct Summary {
  std::array<const Finding*, std::size_t(Quantity::count)> worst{};
  std::array<std::size_t, std::size_t(Quantity::count)> compared{}, parted{};
  void add(std::span<const Finding> findings);  // which must stay alive
};

}  // namespace steradian::reference
