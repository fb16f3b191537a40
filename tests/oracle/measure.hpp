// SPDX-License-Identifier: MIT
// Means of whole oracle pictures with their standard errors, for closed forms.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracle/oracle.hpp"
#include "tests/renderer/scenes.hpp"

namespace steradian::oracle {

struct PictureMean {
  double value = 0.0, sigma = 0.0;
};

inline PictureMean meanOf(const Estimate& image, int channel = 0) {
  PictureMean mean;
  for (std::size_t i = 0; i < image.mean.size(); ++i) {
    mean.value += image.mean[i][channel] / double(image.mean.size());
    mean.sigma += image.variance[i][channel] / image.samples;
  }
  mean.sigma = std::sqrt(mean.sigma) / double(image.mean.size());
  return mean;
}

/// Within 4 standard errors, which must be no more than a share of the value: else the test shows nothing.
inline void expectMean(const PictureMean& measured, double expected, double mostError = 0.005) {
  EXPECT_NEAR(measured.value, expected, 4.0 * measured.sigma + 1e-9 * std::abs(expected));
  EXPECT_LE(measured.sigma, mostError * std::abs(expected));
}

/// A view of 2 * half metres of a point on a ground, from 5 m away.
inline CameraView closeUp(const glm::dvec3& point, double half = 1e-4) {
  return scenes::lookAt(point + glm::dvec3(3.0, 0.6, 4.0), point, 2.0 * half / 5.0);
}

}  // namespace steradian::oracle
