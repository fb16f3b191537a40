// SPDX-License-Identifier: MIT
// Medians, power laws and what follows from them.
#pragma once
#include <optional>
#include <span>
#include <vector>

namespace steradian::report {

/// Of an even count the mean of the middle two; 0 of none.
double median(std::vector<double> values);

struct Spread {
  double median = 0.0, least = 0.0, most = 0.0;
};
Spread spreadOf(const std::vector<double>& values);

struct Point {
  double x = 0.0, y = 0.0;
};

/// y = factor * x^exponent.
struct PowerLaw {
  double factor = 0.0, exponent = 0.0;
  double at(double x) const;
  double reaching(double y) const;  // the x where it is y
};

/// Least squares in logarithms. Points that are not positive are left out; nothing of fewer than two.
std::optional<PowerLaw> fitPowerLaw(std::span<const Point> points);

/// Where a falling curve reaches `y`: between two points along the straight line in logarithms, or beyond the
/// last one along `law`.
struct Crossing {
  double x = 0.0;
  bool extrapolated = false;
};
std::optional<Crossing> crossingOf(std::span<const Point> points, const PowerLaw& law, double y);

}  // namespace steradian::report
