// SPDX-License-Identifier: MIT
// A scene's rows and push constants with one primitive, written by the layout in shaders/gpu_types.h.
#pragma once
#include "shaders/gpu_types.h"
#include "shaders/kernel_scene.comp.h"
#include "shaders/kernel_shapes.comp.h"
#include "tests/shaders/kernel.hpp"

namespace steradian::kernel {

inline const Kernel shapes{kernel_shapes_spirv, "shapes"};
inline const Kernel sceneKernel{kernel_scene_spirv, "scene"};

/// Which kind the single primitive of a scene is.
using Count = std::uint32_t gpu::TraceParams::*;

/// Camera and filter rows (a box filter, looking down -Z, in clear air), then `shape`.
inline Rows sceneRows(const Rows& shape) {
  Rows rows = {{1, 0, 0, 0.0f}, {0, 1, 0, 0}, {0, 0, -1, 0}, {0, 0, 0, 0}};
  for (std::uint32_t i = 0; i < gpu::FILTER_ROWS; ++i)
    rows.emplace_back(i / float(gpu::FILTER_ROWS) - 0.5f, 1.0f / gpu::FILTER_ROWS, 0, 0);
  rows.insert(rows.end(), shape.begin(), shape.end());
  return rows;
}

/// kernel_scene.comp: 0 hit and surface (2 rows in, 3 out), 1 hit and bounce (2 in, 1 out).
inline Task sceneTask(std::uint32_t operation, Count kind, const Rows& shape) {
  gpu::TraceParams params{};
  params.width = params.height = 64;
  params.*kind = 1;
  const Rows rows = sceneRows(shape);
  params.materialRow = params.lightRow = params.objectRow = std::uint32_t(rows.size());
  return {.operation = operation,
          .rowsIn = 2,
          .rowsOut = operation == 0 ? 3u : 1u,
          .push = pushBytes(params),
          .scene = rows};
}

}  // namespace steradian::kernel
