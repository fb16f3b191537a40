// SPDX-License-Identifier: MIT
#include "renderer/light_tree.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "renderer/rows.hpp"
#include "shaders/gpu_types.h"

namespace steradian {
namespace {

using namespace gpu;

constexpr int bins = 16;

// Closer to a cluster's centre than this share of its squared half diagonal, its light grows no more. Shares
// of 0.06 to 0.25 give the least variance over halls, rings and clouds of lamps seen from below and within; 1
// gives up to seven times as much.
constexpr double nearField = 0.125;

/// A light or several, as the tree sees them.
struct Cluster {
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
  double power = 0.0;  // cd, or lx for directional ones
  bool directional = false;

  glm::dvec3 centre() const { return 0.5 * (low + high); }
  double size2() const { return power > 0.0 ? glm::dot(high - low, high - low) : 0.0; }
  void add(const Cluster& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
    power += other.power;
    directional = directional || other.directional;
  }
};

double luminance(const glm::vec4& c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

/// Half extent of a flat light's box: a rect's corners, a disk's rim.
glm::dvec3 flatExtent(const glm::dvec3& u, const glm::dvec3& v, bool rect) {
  return rect ? glm::abs(u) + glm::abs(v) : glm::sqrt(u * u + v * v);
}

Cluster clusterOf(const glm::vec4* light) {
  const std::uint32_t kind = std::uint32_t(light[0].w);
  const glm::dvec3 centre(light[0]), u(light[2]), v(light[3]);
  const double radius = double(light[1].w);
  const bool flat = kind == LIGHT_RECT || kind == LIGHT_DISK;
  const double pi = std::numbers::pi;
  // Area seen head on: radiance times this is an intensity, as punctual lights state it.
  double area = 1.0;
  if (kind == LIGHT_SPHERE) area = pi * radius * radius;
  if (flat) area = (kind == LIGHT_RECT ? 4.0 : pi) * glm::length(glm::cross(u, v));
  // A convex body shows a quarter of its area on average (Cauchy).
  if (kind >= LIGHT_MESH) area = 0.25 * double(light[2].w);
  glm::dvec3 extent(kind == LIGHT_SPHERE ? radius : 0.0);
  if (kind >= LIGHT_MESH) extent = u;
  if (flat) extent = flatExtent(u, v, kind == LIGHT_RECT);
  return {centre - extent, centre + extent, luminance(light[1]) * area, kind == LIGHT_DIRECTIONAL};
}

std::uint32_t levelsFor(std::size_t lights) {
  return std::uint32_t(std::bit_width(lights - 1));
}

class Builder {
 public:
  explicit Builder(std::span<const glm::vec4> lights) : count_(lights.size() / LIGHT_ROWS) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      leaves_.push_back(clusterOf(&lights[i * LIGHT_ROWS]));
      order_.push_back(i);
      total_ += leaves_.back().power;
    }
    if (!(total_ > 0.0 && std::isfinite(total_))) total_ = 1.0;
    rows_.resize((2 * count_ - 1) * LIGHT_NODE_ROWS + count_, glm::vec4(0.0f));
    build(order_, 0, 0, 0);
  }
  std::vector<glm::vec4> rows() && { return std::move(rows_); }

 private:
  using Lights = std::span<std::uint32_t>;

  Cluster boundsOf(Lights lights) const {
    Cluster all;
    for (const std::uint32_t i : lights) all.add(leaves_[i]);
    return all;
  }

  void setNode(std::uint32_t node, const Cluster& c, std::uint32_t link) {
    const glm::dvec3 half = 0.5 * (c.high - c.low);
    const float radius2 = c.directional ? -1.0f : float(nearField * glm::dot(half, half));
    rows_[node * LIGHT_NODE_ROWS] = glm::vec4(glm::vec3(c.centre()), float(c.power / total_));
    rows_[node * LIGHT_NODE_ROWS + 1] = glm::vec4(radius2, bits(link), 0.0f, 0.0f);
  }

  void build(Lights lights, std::uint32_t node, std::uint32_t level, std::uint32_t trail) {
    const Cluster bounds = boundsOf(lights);
    if (lights.size() == 1) {
      setNode(node, bounds, LIGHT_NODE_LEAF | lights[0]);
      const std::size_t trailRow = (2 * count_ - 1) * LIGHT_NODE_ROWS + lights[0];
      rows_[trailRow].x = bits(trail);
      return;
    }
    const std::uint32_t child = next_;
    next_ += 2;
    setNode(node, bounds, child);
    const std::size_t middle = split(lights, bounds, lightTreeDepth(std::uint32_t(count_)) - level - 1);
    build(lights.first(middle), child, level + 1, trail);
    build(lights.subspan(middle), child + 1, level + 1, trail | 1u << level);
  }

  /// Orders the lights so that the first `returned` go to the first child; either side fits into
  /// `levelsLeft`.
  std::size_t split(Lights lights, const Cluster& bounds, std::uint32_t levelsLeft) {
    const auto directional = [&](std::uint32_t i) { return leaves_[i].directional; };
    auto middle = lights.begin();
    if (bounds.directional) {
      middle = std::partition(lights.begin(), lights.end(), std::not_fn(directional));
    } else {
      middle = cheapestSplit(lights);
    }
    const std::size_t first = std::size_t(middle - lights.begin()), second = lights.size() - first;
    if (first > 0 && second > 0 && levelsFor(first) <= levelsLeft && levelsFor(second) <= levelsLeft)
      return first;
    return halves(lights, bounds);
  }

  static int widestAxis(const Cluster& c) {
    const glm::dvec3 size = c.high - c.low;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  std::size_t halves(Lights lights, const Cluster& bounds) {
    const int axis = widestAxis(bounds);
    const auto middle = lights.begin() + std::ptrdiff_t(lights.size() / 2);
    std::nth_element(lights.begin(), middle, lights.end(), [&](std::uint32_t a, std::uint32_t b) {
      return leaves_[a].centre()[axis] < leaves_[b].centre()[axis];
    });
    return lights.size() / 2;
  }

  /// Along the axis on which the centres spread most.
  Lights::iterator cheapestSplit(Lights lights) {
    Cluster centres;
    for (const std::uint32_t i : lights) centres.add({leaves_[i].centre(), leaves_[i].centre()});
    const int axis = widestAxis(centres);
    const double low = centres.low[axis], size = centres.high[axis] - low;
    const auto binOf = [&](std::uint32_t i) {
      const double at = size > 0.0 ? (leaves_[i].centre()[axis] - low) / size : 0.0;
      return std::min(int(at * bins), bins - 1);
    };
    std::array<Cluster, bins> content;
    for (const std::uint32_t i : lights) content[std::size_t(binOf(i))].add(leaves_[i]);
    const int last = lastBinOfFirst(content);
    return std::partition(lights.begin(), lights.end(), [&](std::uint32_t i) { return binOf(i) <= last; });
  }

  static int lastBinOfFirst(const std::array<Cluster, bins>& content) {
    std::array<double, bins> after{};  // cost of the bins after each
    Cluster gathered;
    for (int i = bins - 1; i > 0; --i) {
      gathered.add(content[std::size_t(i)]);
      after[std::size_t(i - 1)] = gathered.power * gathered.size2();
    }
    gathered = {};
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < bins - 1; ++i) {
      gathered.add(content[std::size_t(i)]);
      const double cost = gathered.power * gathered.size2() + after[std::size_t(i)];
      if (cost < least) {
        least = cost;
        best = i;
      }
    }
    return best;
  }

  std::size_t count_;
  std::vector<Cluster> leaves_;
  std::vector<std::uint32_t> order_;
  double total_ = 0.0;
  std::uint32_t next_ = 1;
  std::vector<glm::vec4> rows_;
};

}  // namespace

std::vector<glm::vec4> lightTreeRows(std::span<const glm::vec4> lights) {
  if (lights.empty()) return {};
  return Builder(lights).rows();
}

std::uint32_t lightTreeDepth(std::uint32_t lightCount) {
  if (lightCount < 2) return 0;
  constexpr std::uint32_t slack = 4;  // for uneven clusters, and for the branch of directional lights
  const std::uint32_t depth = std::min(levelsFor(lightCount) + slack, MAX_LIGHT_TREE_DEPTH);
  assert(levelsFor(lightCount) <= depth);
  return depth;
}

}  // namespace steradian
