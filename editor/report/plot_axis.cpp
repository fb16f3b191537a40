// SPDX-License-Identifier: MIT
// Logarithmic axes and labels that do not overlap.
#include "editor/report/plot_axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace steradian::report {

namespace {

std::string withUnit(double value, const char* unit) {
  char text[32];
  std::snprintf(text, sizeof text, "%g %s", value, unit);
  return text;
}

}  // namespace

LogAxis::LogAxis(double least, double most, double from, double to)
    : least_(least), most_(std::max(most, least * 1.0001)), from_(from), to_(to) {}

double LogAxis::operator()(double value) const {
  return from_ + (to_ - from_) * std::log(value / least_) / std::log(most_ / least_);
}

std::vector<Tick> LogAxis::ticks() const {
  std::vector<Tick> out;
  const bool brief = std::log10(most_ / least_) < 2.6;
  for (int e = int(std::floor(std::log10(least_))); e <= int(std::ceil(std::log10(most_))); ++e)
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, e);
      if (value < least_ * 0.9999 || value > most_ * 1.0001) continue;
      out.push_back({value, digit == 1 || (brief && (digit == 2 || digit == 5))});
    }
  return out;
}

std::string secondsLabel(double seconds) {
  return seconds < 0.0999 ? withUnit(seconds * 1e3, "ms") : withUnit(seconds, "s");
}

std::string percentLabel(double fraction) {
  return withUnit(fraction * 100.0, "%");
}

std::string countLabel(double count) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", count);
  return text;
}

std::vector<double> spreadApart(const std::vector<double>& wanted, double gap, double least, double most) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
  // Blocks of touching labels, each around the mean of what its labels want (pool adjacent violators).
  struct Block {
    double sum;  // of wanted - offset within the block
    std::size_t count;
    double start() const { return sum / double(count); }
  };
  std::vector<Block> blocks;
  for (const std::size_t i : order) {
    blocks.push_back({wanted[i], 1});
    while (blocks.size() > 1) {
      const Block last = blocks.back();
      Block& before = blocks[blocks.size() - 2];
      if (before.start() + double(before.count) * gap <= last.start()) break;
      before.sum += last.sum - double(last.count * before.count) * gap;
      before.count += last.count;
      blocks.pop_back();
    }
  }
  std::vector<double> placed(wanted.size());
  std::size_t at = 0;
  double free = least;
  for (const Block& block : blocks) {
    const double room = most - double(block.count - 1) * gap;
    double y = std::max(std::min(block.start(), room), free);
    for (std::size_t k = 0; k < block.count; ++k, y += gap) placed[order[at++]] = y;
    free = y;
  }
  return placed;
}

}  // namespace steradian::report
