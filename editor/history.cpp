// SPDX-License-Identifier: MIT
// Undo as an index into snapshots.
#include "editor/history.hpp"

#include <algorithm>
#include <cassert>

namespace steradian {

namespace {

/// About what a snapshot costs; good enough to bound the memory of a long session.
std::size_t approximateBytes(const Scene& scene) {
  std::size_t bytes =
      sizeof(Scene) + scene.objects.size() * sizeof(Object) + scene.materials.size() * sizeof(Material);
  for (const Object& object : scene.objects) bytes += object.name.capacity() + object.extras.capacity();
  for (const Channel& channel : scene.animation.channels) bytes += channel.keys.size() * sizeof(Keyframe);
  return bytes;
}

constexpr std::size_t kAlwaysKept = 32;

}  // namespace

History::History(Snapshot start, std::string name, std::size_t byteLimit) : byteLimit_(byteLimit) {
  assert(start);
  steps_.push_back({std::move(name), std::move(start)});
}

void History::push(Snapshot next, std::string name) {
  assert(next);
  steps_.resize(index_ + 1);
  steps_.push_back({std::move(name), std::move(next)});
  ++index_;
  forgetOldest();
}

void History::forgetOldest() {
  // Snapshots differ little from each other: the newest stands for all.
  const std::size_t perStep = approximateBytes(*steps_.back().scene);
  const std::size_t affordable = std::max(kAlwaysKept, byteLimit_ / perStep);
  if (steps_.size() <= affordable) return;
  const std::size_t surplus = steps_.size() - affordable;
  steps_.erase(steps_.begin(), steps_.begin() + std::ptrdiff_t(surplus));
  index_ -= surplus;
}

void History::goTo(std::size_t index) {
  assert(index < steps_.size());
  index_ = index;
}

std::optional<std::string> History::undoName() const {
  if (index_ == 0) return std::nullopt;
  return steps_[index_].name;
}

std::optional<std::string> History::redoName() const {
  if (index_ + 1 >= steps_.size()) return std::nullopt;
  return steps_[index_ + 1].name;
}

}  // namespace steradian
