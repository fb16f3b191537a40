// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "tests/oracle/path.hpp"

namespace steradian::oracle {
namespace {

/// Offset from the pixel's centre along one axis, as likely as the filter weighs it.
double filterOffset(PixelFilter filter, Random& random) {
  if (filter == PixelFilter::box) return random.uniform() - 0.5;
  for (;;) {  // 4-term Blackman-Harris window (Harris 1978) over 4 pixels, by rejection
    const double x = random.uniform(), w = 2.0 * std::numbers::pi * x;
    const double window =
        0.35875 - 0.48829 * std::cos(w) + 0.14128 * std::cos(2.0 * w) - 0.01168 * std::cos(3.0 * w);
    if (random.uniform() < window) return 4.0 * x - 2.0;
  }
}

}  // namespace

Ray cameraRay(const Scene& scene, const CameraView& view, const dvec2& pixel, const dvec2& film,
              Random& random) {
  const PixelFilter filter = scene.render.filter;
  const dvec2 offset(filterOffset(filter, random), filterOffset(filter, random));
  const dvec2 p = (pixel + 0.5 + offset) / film * 2.0 - 1.0;  // [-1, 1], y down
  const dvec2 onSensor(p.x * film.x / film.y, -p.y);          // half height 1
  dvec3 origin(0.0), direction(0.0, 0.0, -1.0);
  if (view.lens.projection == Projection::orthographic) {
    origin = dvec3(onSensor * (0.5 * view.lens.orthographicHeight), 0.0);
  } else {
    direction = dvec3(onSensor * std::tan(0.5 * view.fovY), -1.0);
    Camera lens = view.lens;
    lens.fovY = view.fovY;
    const dvec3 focus = direction * lens.focusDistance;
    origin = dvec3(random.inDisc() * apertureRadius(lens), 0.0);
    direction = focus - origin;
  }
  const dmat4& m = view.worldFromCamera;
  return {dvec3(m * glm::dvec4(origin, 1.0)), glm::normalize(dmat3(m) * direction)};
}

}  // namespace steradian::oracle
