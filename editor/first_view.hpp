// SPDX-License-Identifier: MIT
// What a model without camera or light is first seen with.
#pragma once
#include <string>

#include "renderer/scene/scene.hpp"

namespace steradian {

struct FirstView {
  Scene scene;
  std::string added;  // "a camera that sees everything and a soft sky", one of them, or empty
};

/// Gives a scene without camera one that sees everything in a picture of its own format, and one in which
/// nothing shines a soft sky of 1 nit. For files that hold models; a project is meant as it is.
FirstView withFirstView(Scene scene);

}  // namespace steradian
