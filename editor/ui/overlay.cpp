// SPDX-License-Identifier: MIT
// Projection of outlines and marks with ImGui's lines.
#include "editor/ui/overlay.hpp"

#include <cmath>
#include <numbers>

#include "editor/ui/icons.hpp"
#include "editor/ui/style.hpp"

namespace steradian::ui {

namespace {

constexpr int kCircleSteps = 96;  // half a pixel from round at a radius of 1000

/// Draws one object's outline in its own coordinates.
class Wire {
 public:
  Wire(ImDrawList& list, const Projection& projection, const glm::dmat4& world, const CameraView& view,
       ImU32 color, float width)
      : list_(list), projection_(projection), world_(world), view_(view), color_(color), width_(width) {}

  void operator()(const Group&) const { axes(0.3); }
  void operator()(const Geometry& geometry) const { std::visit(*this, geometry.shape); }
  void operator()(const Light& light) const { std::visit(*this, light.kind); }
  void operator()(const steradian::Camera& camera) const { frustum(camera); }

  void operator()(const Sphere& sphere) const { silhouette(sphere.radius); }
  void operator()(const Plane&) const {
    for (int i = -2; i <= 2; ++i) {
      line({i, 0, -2}, {i, 0, 2});
      line({-2, 0, i}, {2, 0, i});
    }
    line({0, 0, 0}, {0, 0.8, 0});
  }
  void operator()(const Box& box) const { edges(-0.5 * box.size, 0.5 * box.size); }
  void operator()(const MeshShape& s) const { edges(s.mesh->boxMin, s.mesh->boxMax); }
  void edges(const glm::dvec3& low, const glm::dvec3& high) const {
    for (const double y : {low.y, high.y})
      for (const double z : {low.z, high.z}) line({low.x, y, z}, {high.x, y, z});
    for (const double x : {low.x, high.x}) {
      for (const double z : {low.z, high.z}) line({x, low.y, z}, {x, high.y, z});
      for (const double y : {low.y, high.y}) line({x, y, low.z}, {x, y, high.z});
    }
  }
  void operator()(const Rect& rect) const {
    const glm::dvec2 h = 0.5 * rect.size;
    line({-h.x, 0, -h.y}, {h.x, 0, -h.y});
    line({h.x, 0, -h.y}, {h.x, 0, h.y});
    line({h.x, 0, h.y}, {-h.x, 0, h.y});
    line({-h.x, 0, h.y}, {-h.x, 0, -h.y});
  }
  void operator()(const Disk& disk) const { circle({0, 0, 0}, {disk.radius, 0, 0}, {0, 0, disk.radius}); }
  void operator()(const Cylinder& c) const {
    for (const double y : {-0.5 * c.height, 0.5 * c.height})
      circle({0, y, 0}, {c.radius, 0, 0}, {0, 0, c.radius});
    for (int i = 0; i < 4; ++i) {
      const double x = c.radius * std::cos(i * std::numbers::pi / 2),
                   z = c.radius * std::sin(i * std::numbers::pi / 2);
      line({x, -0.5 * c.height, z}, {x, 0.5 * c.height, z});
    }
  }

  void operator()(const PointLight&) const {}
  void operator()(const SpotLight& spot) const {
    const double length = 1.0, radius = length * std::tan(std::min(spot.outerConeAngle, 1.5f));
    circle({0, 0, -length}, {radius, 0, 0}, {0, radius, 0});
    for (const auto& [x, y] : {std::pair{radius, 0.0}, {-radius, 0.0}, {0.0, radius}, {0.0, -radius}})
      line({0, 0, 0}, {x, y, -length});
  }
  void operator()(const DirectionalLight&) const { line({0, 0, 0}, {0, 0, -1.2}); }
  void operator()(const SphereLight& light) const { silhouette(light.radius); }
  void operator()(const RectLight& light) const {
    const glm::dvec2 h = 0.5 * light.size;
    const glm::dvec3 corners[] = {{-h.x, -h.y, 0}, {h.x, -h.y, 0}, {h.x, h.y, 0}, {-h.x, h.y, 0}};
    for (int i = 0; i < 4; ++i) line(corners[i], corners[(i + 1) % 4]);
    line({0, 0, 0}, {0, 0, -std::max(h.x, h.y)});  // the side that shines
  }
  void operator()(const DiskLight& light) const {
    circle({0, 0, 0}, {light.radius, 0, 0}, {0, light.radius, 0});
    line({0, 0, 0}, {0, 0, -light.radius});
  }
  void operator()(const EnvironmentLight&) const { axes(0.5); }

 private:
  glm::dvec3 toWorld(const glm::dvec3& local) const { return glm::dvec3(world_ * glm::dvec4(local, 1.0)); }
  void line(const glm::dvec3& a, const glm::dvec3& b) const {
    projection_.line(list_, toWorld(a), toWorld(b), color_, width_);
  }
  void circle(const glm::dvec3& center, const glm::dvec3& u, const glm::dvec3& v) const {
    for (int i = 0; i < kCircleSteps; ++i) {
      const double a = 2 * std::numbers::pi * i / kCircleSteps,
                   b = 2 * std::numbers::pi * (i + 1) / kCircleSteps;
      line(center + u * std::cos(a) + v * std::sin(a), center + u * std::cos(b) + v * std::sin(b));
    }
  }
  /// The rim of the sphere as the eye sees it, found in object space where the ellipsoid is a sphere.
  void silhouette(double radius) const {
    const glm::dvec3 eye(glm::inverse(world_) * view_.worldFromCamera[3]);
    const double distance = glm::length(eye);
    if (!(distance > radius)) return;
    const glm::dvec3 axis = eye / distance;
    const glm::dvec3 helper = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, helper)), v = glm::cross(axis, u);
    const double rim = radius * std::sqrt(1.0 - radius * radius / (distance * distance));
    circle(axis * (radius * radius / distance), u * rim, v * rim);
  }
  void frustum(const steradian::Camera& camera) const {
    const bool parallel = camera.projection == steradian::Projection::orthographic;
    const double y = 0.5 * (parallel ? camera.orthographicHeight : std::tan(0.5 * camera.fovY));
    const double x = y * 16.0 / 9.0, z = -0.5;
    const glm::dvec3 corners[] = {{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}};
    for (int i = 0; i < 4; ++i) {
      line(parallel ? glm::dvec3(corners[i].x, corners[i].y, 0.0) : glm::dvec3(0.0), corners[i]);
      line(corners[i], corners[(i + 1) % 4]);
    }
    if (camera.fNumber > 0.0 && !parallel) focusCross(camera);
  }
  /// Where the plane in focus meets the view axis.
  void focusCross(const steradian::Camera& camera) const {
    const double r = 0.1 * camera.focusDistance * std::tan(0.5 * camera.fovY), z = -camera.focusDistance;
    line({-r, 0, z}, {r, 0, z});
    line({0, -r, z}, {0, r, z});
  }
  void axes(double length) const {
    for (int i = 0; i < 3; ++i) {
      glm::dvec3 end(0.0);
      end[i] = length;
      line(-end, end);
    }
  }

  ImDrawList& list_;
  const Projection& projection_;
  glm::dmat4 world_;
  const CameraView& view_;
  ImU32 color_;
  float width_;
};

bool hasMark(const Object& object, Id cameraInUse) {
  if (std::holds_alternative<Light>(object.content)) return true;
  return std::holds_alternative<steradian::Camera>(object.content) && object.id != cameraInUse;
}

glm::dvec3 placeOf(const Scene& scene, Id object) {
  return glm::dvec3(worldFromObject(scene, object)[3]);
}

}  // namespace

Projection::Projection(const CameraView& view, const ViewRect& rect)
    : cameraFromWorld_(glm::inverse(view.worldFromCamera)),
      parallel_(view.lens.projection == steradian::Projection::orthographic),
      focal_(parallel_ ? 2.0 / view.lens.orthographicHeight : 1.0 / std::tan(0.5 * view.fovY)),
      center_(rect.min.x + 0.5f * rect.size.x, rect.min.y + 0.5f * rect.size.y),
      halfHeight_(0.5f * rect.size.y) {}

ImVec2 Projection::onScreen(const glm::dvec3& c) const {
  const double scale = focal_ * halfHeight_ / (parallel_ ? 1.0 : -c.z);
  // Far outside is far enough: ImGui draws with 16-bit-safe coordinates only.
  const auto limited = [](double v) { return float(std::clamp(v, -3e4, 3e4)); };
  return {center_.x + limited(c.x * scale), center_.y - limited(c.y * scale)};
}

std::optional<ImVec2> Projection::point(const glm::dvec3& world) const {
  const glm::dvec3 c(cameraFromWorld_ * glm::dvec4(world, 1.0));
  if (!(c.z < 0.0)) return std::nullopt;
  return onScreen(c);
}

void Projection::line(ImDrawList& list, const glm::dvec3& a, const glm::dvec3& b, ImU32 color,
                      float width) const {
  glm::dvec3 p(cameraFromWorld_ * glm::dvec4(a, 1.0)), q(cameraFromWorld_ * glm::dvec4(b, 1.0));
  const double near = -1e-3 * (std::abs(p.z) + std::abs(q.z));
  if (p.z > near && q.z > near) return;
  if (p.z > near) p += (q - p) * ((near - p.z) / (q.z - p.z));
  if (q.z > near) q += (p - q) * ((near - q.z) / (p.z - q.z));
  list.AddLine(onScreen(p), onScreen(q), color, width);
}

void drawOverlay(Ui& ui, ImDrawList& list, const Document& document, const CameraView& view,
                 const ViewRect& rect, Id cameraInUse) {
  const Scene& scene = document.scene();
  const Projection projection(view, rect);
  list.PushClipRect(rect.min, {rect.min.x + rect.size.x, rect.min.y + rect.size.y}, true);
  for (const Object& object : scene.objects) {
    const bool selected = document.selection().contains(object.id);
    const ImU32 tint = !selected                        ? IM_COL32(225, 228, 232, 200)
                       : document.active() == object.id ? color::kAccent
                                                        : IM_COL32(200, 150, 96, 220);
    if (selected && object.id != cameraInUse)
      std::visit(Wire(list, projection, worldFromObject(scene, object.id), view, tint, ui.px(1.4f)),
                 object.content);
    if (!hasMark(object, cameraInUse) || !visibleInHierarchy(scene, object.id)) continue;
    if (const auto at = projection.point(placeOf(scene, object.id))) {
      list.AddCircleFilled(*at, ui.px(11), IM_COL32(20, 21, 24, 150));
      drawKindIcon(list, *at, ui.px(14), object.content, tint);
    }
  }
  list.PopClipRect();
}

Id markAt(const Ui& ui, const Scene& scene, const CameraView& view, const ViewRect& rect, ImVec2 at,
          Id cameraInUse) {
  const Projection projection(view, rect);
  Id nearest = Id::none;
  float best = ui.px(12);
  for (const Object& object : scene.objects) {
    if (!hasMark(object, cameraInUse) || !visibleInHierarchy(scene, object.id)) continue;
    const auto mark = projection.point(placeOf(scene, object.id));
    if (!mark) continue;
    const float distance = std::hypot(mark->x - at.x, mark->y - at.y);
    if (distance >= best) continue;
    best = distance;
    nearest = object.id;
  }
  return nearest;
}

}  // namespace steradian::ui
