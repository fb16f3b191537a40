// SPDX-License-Identifier: MIT
// What a verification found, as text.
#pragma once
#include "renderer/reference/judge.hpp"

namespace steradian::cli {

/// One path and what was found along it.
struct VerifiedPath {
  reference::PathRecord record;
  std::vector<reference::Finding> findings;
  reference::FreeRun run;
};

/// The path's vertices, each with the largest relative difference of every stage.
void printPath(const VerifiedPath& path, const reference::TracedScene& traced, const Scene& scene);
/// Every quantity over all paths, and the verdict. True when nothing parts.
bool printVerdict(const std::vector<VerifiedPath>& paths);

}  // namespace steradian::cli
