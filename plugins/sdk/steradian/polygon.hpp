// SPDX-License-Identifier: MIT
// For importers: polygons into triangles, and numbers of text files in any locale. Nothing of it crosses the
// border.
#pragma once
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace steradian::sdk {

/// The whole of `text` as a number: 1, +1.5, -1e-3, .5, nan, inf; too small ones are 0. Nothing when it is
/// none or does not fit.
inline std::optional<double> numberIn(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  if (error == std::errc()) return value;
  const bool tiny = text.find("e-") != text.npos || text.find("E-") != text.npos;
  return error == std::errc::result_out_of_range && tiny ? std::optional(0.0) : std::nullopt;
}

/// Triangles of simple polygons, planar or nearly: convex ones as a fan, others by ear clipping (Meisters
/// 1975) in the plane of Newell's normal (Sutherland et al. 1974). Keeps the winding. One object for many
/// polygons saves allocation.
class Triangulator {
 public:
  using Point = std::array<float, 3>;
  static constexpr std::size_t kMostClipped =
      512;  // clipping costs up to the cube of the corners: larger ones are fans

  /// Triples of indices into `corners`, valid until the next call; empty for fewer than three.
  std::span<const std::uint32_t> operator()(std::span<const Point> corners) {
    out_.clear();
    flatten(corners);
    if (corners.size() > 3 && corners.size() <= kMostClipped && !convex())
      clipEars();
    else
      for (std::uint32_t i = 2; i < corners.size(); ++i) out_.insert(out_.end(), {0, i - 1, i});
    return out_;
  }

  /// Newell's normal: twice the area long, of no direction for a polygon without area.
  static std::array<double, 3> normal(std::span<const Point> corners) {
    std::array<double, 3> n{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
        n[k] += (double(a[u]) - b[u]) * (double(a[v]) + b[v]);
      }
    }
    return n;
  }

 private:
  struct Flat {
    double x, y;
  };

  /// Drops the axis that the normal follows most, so that the polygon turns counter-clockwise.
  void flatten(std::span<const Point> corners) {
    const auto n = normal(corners);
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (std::abs(n[k]) > std::abs(n[axis])) axis = k;
    std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (n[axis] < 0) std::swap(u, v);
    flat_.clear();
    for (const Point& p : corners) flat_.push_back({p[u], p[v]});
  }

  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Flat &p = flat_[a], &q = flat_[b], &r = flat_[c];
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }

  bool convex() const {
    const auto count = std::uint32_t(flat_.size());
    for (std::uint32_t i = 0; i < count; ++i)
      if (turn(i, (i + 1) % count, (i + 2) % count) < 0) return false;
    return true;
  }

  /// No other corner that is left lies inside of the triangle at `at`.
  bool isEar(std::size_t at) const {
    const std::size_t count = left_.size();
    const std::uint32_t a = left_[(at + count - 1) % count], b = left_[at], c = left_[(at + 1) % count];
    if (turn(a, b, c) <= 0) return false;
    for (const std::uint32_t p : left_)
      if (p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0)
        return false;
    return true;
  }

  void clipEars() {
    left_.resize(flat_.size());
    for (std::uint32_t i = 0; i < left_.size(); ++i) left_[i] = i;
    for (std::size_t at = 0, misses = 0; left_.size() > 3;) {
      const std::size_t count = left_.size();
      at %= count;
      // A polygon that crosses itself may have no ear: then any corner goes.
      if (!isEar(at) && ++misses <= count) {
        ++at;
        continue;
      }
      out_.insert(out_.end(), {left_[(at + count - 1) % count], left_[at], left_[(at + 1) % count]});
      left_.erase(left_.begin() + std::ptrdiff_t(at));
      misses = 0;
    }
    out_.insert(out_.end(), left_.begin(), left_.end());
  }

  std::vector<Flat> flat_;
  std::vector<std::uint32_t> left_, out_;
};

}  // namespace steradian::sdk
