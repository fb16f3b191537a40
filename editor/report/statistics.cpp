// SPDX-License-Identifier: MIT
// Medians and straight lines in logarithms.
#include "editor/report/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace steradian::report {

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

Spread spreadOf(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {median(values), *least, *most};
}

double PowerLaw::at(double x) const {
  return factor * std::pow(x, exponent);
}

double PowerLaw::reaching(double y) const {
  return std::pow(y / factor, 1.0 / exponent);
}

std::optional<PowerLaw> fitPowerLaw(std::span<const Point> points) {
  double n = 0.0, meanX = 0.0, meanY = 0.0, xx = 0.0, xy = 0.0;
  for (const Point& p : points) {
    if (!(p.x > 0.0 && p.y > 0.0)) continue;
    const double x = std::log(p.x), y = std::log(p.y), fromMean = x - meanX;
    n += 1.0;  // running means (Welford 1962)
    meanX += fromMean / n;
    xy += fromMean * (y - meanY) * (n - 1.0) / n;
    meanY += (y - meanY) / n;
    xx += fromMean * (x - meanX);
  }
  if (n < 2.0 || !(xx > 0.0)) return std::nullopt;
  const double exponent = xy / xx;
  return PowerLaw{std::exp(meanY - exponent * meanX), exponent};
}

std::optional<Crossing> crossingOf(std::span<const Point> points, const PowerLaw& law, double y) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point &a = points[i - 1], &b = points[i];
    if (!(a.y > y && b.y <= y && b.y > 0.0)) continue;
    const double share = std::log(a.y / y) / std::log(a.y / b.y);
    return Crossing{a.x * std::pow(b.x / a.x, share), false};
  }
  if (points.empty() || points.front().y <= y) return std::nullopt;  // reached before the first look
  if (!(law.exponent < 0.0)) return std::nullopt;                    // it never comes
  return Crossing{law.reaching(y), true};
}

}  // namespace steradian::report
