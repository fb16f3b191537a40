// SPDX-License-Identifier: MIT
// The undo history: a list of named snapshots and an index into it.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/scene.hpp"

namespace steradian {

using Snapshot = std::shared_ptr<const Scene>;

class History {
 public:
  struct Step {
    std::string name;  // "Move Lamp"; the first step is how the document began
    Snapshot scene;
  };

  /// `byteLimit`: the oldest steps are forgotten beyond it (but never the last 32).
  explicit History(Snapshot start, std::string name = "Open", std::size_t byteLimit = std::size_t(512) << 20);

  const Snapshot& current() const { return steps_[index_].scene; }
  const std::vector<Step>& steps() const { return steps_; }
  std::size_t index() const { return index_; }

  /// Drops the steps that were undone, then appends.
  void push(Snapshot next, std::string name);
  void goTo(std::size_t index);                 // of steps()
  std::optional<std::string> undoName() const;  // what undo would take back; nullopt at the start
  std::optional<std::string> redoName() const;

 private:
  void forgetOldest();

  std::vector<Step> steps_;
  std::size_t index_ = 0;
  std::size_t byteLimit_;
};

}  // namespace steradian
