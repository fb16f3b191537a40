// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include "renderer/scene/validate.hpp"

/// Fails with every problem of the scene.
inline void expectSound(const steradian::Scene& scene) {
  for (const steradian::Problem& problem : problemsOf(scene))
    ADD_FAILURE() << problem.where << " " << problem.what;
}
