// SPDX-License-Identifier: MIT
// Adds floating-point numbers without any rounding, so that order and grouping cannot matter.
#pragma once
#include <vector>

namespace steradian {

/// The exact sum of what was added, as doubles whose bits do not overlap (Shewchuk, "Adaptive Precision
/// Floating-Point Arithmetic", 1997, grow-expansion). Finite terms only, and no partial sum may overflow.
class ExactSum {
 public:
  void add(double term);
  /// The double nearest to the sum, ties to even: a function of the exact value alone.
  double rounded() const;

  void clear() { parts_.clear(); }

 private:
  std::vector<double> parts_;  // from the smallest to the largest, none zero
};

/// Takes from `sum` the float nearest to it (by way of the nearest double) and leaves the rest: repeated
/// until 0 comes out, the floats say the value in one way only. At most 13 are ever needed, 2 or 3 in
/// practice.
float takeFloat(ExactSum& sum);

}  // namespace steradian
