// SPDX-License-Identifier: MIT
// Error-free transformations of sums.
#include "editor/part/exact_sum.hpp"

#include <cmath>

namespace steradian {

namespace {

struct TwoSum {
  double sum, error;  // sum + error is exact
};

/// Knuth, "The Art of Computer Programming" 2, theorem 4.2.2 B.
TwoSum twoSum(double a, double b) {
  const double sum = a + b, bVirtual = sum - a, aVirtual = sum - bVirtual;
  return {sum, (a - aVirtual) + (b - bVirtual)};
}

}  // namespace

void ExactSum::add(double term) {
  std::size_t kept = 0;
  for (const double part : parts_) {
    const TwoSum s = twoSum(term, part);
    if (s.error != 0.0) parts_[kept++] = s.error;
    term = s.sum;
  }
  parts_.resize(kept);
  if (term != 0.0) parts_.push_back(term);
}

double ExactSum::rounded() const {
  if (parts_.empty()) return 0.0;
  std::size_t i = parts_.size() - 1;
  TwoSum s{parts_[i], 0.0};
  while (i > 0 && s.error == 0.0) s = twoSum(s.sum, parts_[--i]);
  // Exactly halfway so far: what lies below decides, as Python's fsum does.
  if (i > 0 && std::signbit(s.error) == std::signbit(parts_[i - 1])) {
    const double twice = 2.0 * s.error, up = s.sum + twice;
    if (up - s.sum == twice) return up;
  }
  return s.sum;
}

float takeFloat(ExactSum& sum) {
  const float taken = float(sum.rounded());
  sum.add(-double(taken));
  return taken;
}

}  // namespace steradian
