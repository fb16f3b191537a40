// SPDX-License-Identifier: MIT
// A logarithmic axis: range, ticks and their words.
#pragma once
#include <string>
#include <vector>

namespace steradian::report {

struct Tick {
  double value = 0.0;
  bool labelled = false;  // else only a fine line of the grid
};

/// From `least` to `most`, both positive, at pixel positions `from` to `to`.
class LogAxis {
 public:
  LogAxis(double least, double most, double from, double to);
  double operator()(double value) const;  // pixel position
  double least() const { return least_; }
  double most() const { return most_; }
  double from() const { return from_; }
  double to() const { return to_; }
  /// Powers of ten are labelled, and 2 and 5 between them too on a short axis; the other digits are fine
  /// lines.
  std::vector<Tick> ticks() const;

 private:
  double least_, most_, from_, to_;
};

/// "1 ms", "0.5 s", "20 s" and "0.5 %", "10 %": one unit for the whole axis would need too many zeros.
std::string secondsLabel(double seconds);
std::string percentLabel(double fraction);
std::string countLabel(double count);  // "2000"

/// Moves positions apart so that neighbours are `gap` or more, with the smallest greatest shift kept small;
/// stays within [least, most] where there is room. Returns them in the order given.
std::vector<double> spreadApart(const std::vector<double>& wanted, double gap, double least, double most);

}  // namespace steradian::report
