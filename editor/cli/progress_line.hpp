// SPDX-License-Identifier: MIT
// Progress of a render on stderr: one line that rewrites itself on a terminal, a plain line now and then
// otherwise.
#pragma once
#include "renderer/still.hpp"

namespace steradian::cli {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();  // wipes the line from a terminal
  void show(const StillProgress& progress);

 private:
  bool terminal_;
  double shownAt_;  // seconds of the render
};

/// "37 % 64 samples, error 2.3 %, 12 s, 20 s left".
std::string progressText(const StillProgress& progress);

}  // namespace steradian::cli
