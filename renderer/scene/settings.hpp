// SPDX-License-Identifier: MIT
// Settings saved with the project: how light is simulated, and how the result is shown.
#pragma once
#include <cstdint>
#include <map>
#include <string>

namespace steradian {

enum class PixelFilter : std::uint32_t { box = 0, blackmanHarris = 1 };

/// Everything here changes the radiance: the renderer starts over when it differs.
struct RenderSettings {
  int width = 1280;  // pixels of a still
  int height = 720;
  int maxBounces = 8;  // surface interactions after the camera ray's first hit, 0..64; 0 = direct light only
  int lightSamples = 8;  // lights sampled at each vertex: all of them while they are no more than this, 1..16
  bool russianRoulette = true;  // after the third bounce
  bool errorMeter =
      true;  // two half-buffers with independent scrambles; off = one joint sequence, no error figure
  bool energyCompensation = true;  // light scattered more than once between microfacets; off = single scatter
  float clamp =
      0.0f;  // most radiance (nit) that one sample may carry beyond its first hit; 0 = off, unbiased
  PixelFilter filter = PixelFilter::blackmanHarris;  // box: 1 pixel wide; Blackman-Harris: 4 pixels wide
  std::uint32_t seed = 0;
  bool operator==(const RenderSettings&) const = default;
};

enum class Transfer : std::uint32_t { srgb = 0, gamma = 1 };

/// Everything here changes only how radiance is shown.
struct DisplaySettings {
  float exposure = 0.0f;  // stops
  bool physical = false;  // exposure by EV100: 1 / (1.2 * 2^ev100) of the luminance, before the stops
  float ev100 = 0.0f;     // exposure value at ISO 100, for `physical`
  std::string tonemapper = "org.steradian.tonemap.khronos_pbr_neutral";  // plugin id
  std::map<std::string, float> parameters;  // of the tonemapper, by id; absent = its default
  Transfer transfer = Transfer::srgb;
  float gamma = 2.2f;  // for Transfer::gamma
  bool operator==(const DisplaySettings&) const = default;
};

}  // namespace steradian
