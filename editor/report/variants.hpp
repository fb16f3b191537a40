// SPDX-License-Identifier: MIT
// What a report switches off to find out what it is worth: a list, one line each.
#pragma once
#include <functional>
#include <span>
#include <string>

#include "renderer/renderer.hpp"

namespace steradian::report {

struct Variant {
  std::string id, label;
  std::function<void(RenderSettings&)> settings = {};  // may be empty
  std::function<void(Ablation&)> ablation = {};        // may be empty
  bool specialized = true;
  bool anotherPicture = false;  // the expected picture differs: needs a reference of its own
  bool onlySpeed = false;       // the samples stay the same
};

/// The renderer as it is.
const Variant& baseline();
/// Everything that can be switched off, one thing at a time.
std::span<const Variant> ablations();

/// Makes `renderer` trace `scene` as the variant says, from the first sample, with this seed; compiles what
/// it needs, so that no timing sees a compiler.
void prepare(Renderer& renderer, const Variant& variant, Scene scene, const CameraView& view, Extent film,
             std::uint32_t seed);

}  // namespace steradian::report
