// SPDX-License-Identifier: MIT
// What the files that hold the rules of a sound scene share: limits, and the collector of problems.
#pragma once
#include <cmath>
#include <cstdio>
#include <string>
#include <unordered_set>
#include <vector>

#include "renderer/scene/scene.hpp"
#include "renderer/scene/validate.hpp"

namespace steradian {

// Lengths and factors beyond these have squares that leave the range of float on the device.
inline constexpr double kSmallest = 1e-12, kLargest = 1e12;
// Light beyond this overflows the half-precision files that it is saved to long before float does.
inline constexpr double kBrightest = 1e12;

inline std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", value);
  return buffer;
}

/// Collects problems under a place name such as "object 'Lamp'".
class Checker {
 public:
  explicit Checker(std::vector<Problem>& problems) : problems_(problems) {}
  void at(std::string place) { place_ = std::move(place); }

  void fail(const std::string& field, std::string what) {
    problems_.push_back(
        {place_.empty() || field.empty() ? place_ + field : place_ + "." + field, std::move(what)});
  }
  void range(const std::string& field, double value, double low, double high) {
    if (!(value >= low && value <= high))  // NaN fails too
      fail(field, "is " + text(value) + "; expected a number from " + text(low) + " to " + text(high));
  }
  void inside(const std::string& field, double value, double low, double high) {
    if (!(value > low && value < high))
      fail(field,
           "is " + text(value) + "; expected a number above " + text(low) + " and below " + text(high));
  }
  void finite(const std::string& field, double value) {
    if (!std::isfinite(value)) fail(field, "is " + text(value) + "; expected a finite number");
  }
  void above(const std::string& field, double value, double low, double high) {
    if (!(value > low && value <= high))
      fail(field,
           "is " + text(value) + "; expected a number above " + text(low) + " and up to " + text(high));
  }
  void length(const std::string& field, double value) { range(field, value, kSmallest, kLargest); }
  template <class Vector>
  void each(const std::string& field, const Vector& v, double low, double high) {
    for (int i = 0; i < Vector::length(); ++i) range(field + "." + "xyzw"[i], double(v[i]), low, high);
  }

 private:
  std::vector<Problem>& problems_;
  std::string place_;
};

// The rules of one object's content and of one material; `check` stands at the object.
void checkContent(Checker& check, const Object& object, const std::unordered_set<Id>& materials);
void checkMaterial(Checker& check, const Material& material);

std::string place(const Object& object);  // "object 'Lamp'", "object '#7'"
std::string place(const Material& material);

}  // namespace steradian
