// SPDX-License-Identifier: MIT
// A device and a renderer for a whole test suite, and the promises that every picture must keep.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "renderer/renderer.hpp"
#include "tests/measured.hpp"

namespace steradian {

/// A mean and its standard error. Pixels have independent scrambles, so their spread tells the error.
struct Mean {
  double value = 0.0, sigma = 0.0;
};

template <class Number>
Mean meanOf(const std::vector<Number>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double v : values) sum += v;
  const double n = double(values.size()), mean = sum / n;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / (n * std::max(n - 1.0, 1.0)))};
}

inline std::vector<double> channelOf(const Image& image, int channel) {
  std::vector<double> values;
  for (std::size_t i = std::size_t(channel); i < image.pixels.size(); i += 3)
    values.push_back(image.pixels[i]);
  return values;
}
inline Mean meanOf(const Image& image, int channel = 0) {
  return meanOf(channelOf(image, channel));
}

/// Mean of (a - b)^2 / (b + 0.01)^2 over pixels and channels.
inline double mrse(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < b.pixels.size(); ++i) {
    const double d = (double(a.pixels[i]) - b.pixels[i]) / (b.pixels[i] + 0.01);
    sum += d * d;
  }
  return sum / double(b.pixels.size());
}

class RendererTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    device_ = openDevice({});
    RecordProperty("device", describe(*device_).name);
    renderer_ = std::make_unique<Renderer>(device_);
  }
  static void TearDownTestSuite() {
    renderer_.reset();
    device_.reset();
  }
  void SetUp() override { renderer_->allowSpecialization(false); }
  void TearDown() override {
    expectClean();
    EXPECT_EQ(validationMessages(*device_), 0);
  }

  Renderer& renderer() { return *renderer_; }
  static bool onCpu() { return describe(*device_).type == "CPU"; }

  /// No sample lost to NaN, to a missing feature or to the loop budget.
  virtual void expectClean() {
    renderer_->measureError();
    EXPECT_EQ(renderer_->stats().nanSamples, 0u);
    EXPECT_EQ(renderer_->stats().faults, 0u);
  }
  /// The picture of exactly the samples [begin, end).
  Image render(const Scene& scene, const CameraView& view, Extent film, std::uint64_t end,
               std::uint64_t begin = 0) {
    renderer_->setScene(scene, view, film);
    renderer_->setSampleRange(begin, end);
    while (renderer_->trace(200.0)) {
    }
    expectClean();
    EXPECT_EQ(renderer_->stats().samples, end - begin);
    return renderer_->radiance();
  }

  /// The same samples through another pipeline: bit by bit on a CPU, whose compiler keeps the order of
  /// operations; a GPU's may round differently.
  static void expectSamePicture(const Image& special, const Image& generic) {
    const double difference = mrse(special, generic);
    if (onCpu()) {
      EXPECT_TRUE(special == generic) << "MRSE " << difference;
    } else {
      EXPECT_LE(difference, 1e-6);
    }
    measured("MRSE against the generic pipeline", difference, onCpu() ? 0 : 1e-6);
  }

  static inline std::shared_ptr<gpu::Device> device_;
  static inline std::unique_ptr<Renderer> renderer_;
};

/// Within a share of the expected value or three standard errors, whichever is more.
inline void expectMean(const Mean& mean, double expected, double share) {
  const double gate = std::max(share * std::abs(expected), 3.0 * mean.sigma);
  EXPECT_NEAR(mean.value, expected, gate) << "standard error " << mean.sigma;
  measured("relative error of the mean", std::abs(mean.value / expected - 1.0), gate / std::abs(expected));
}

}  // namespace steradian
