// SPDX-License-Identifier: MIT
// The icons' lines.
#include "editor/ui/icons.hpp"

#include <cmath>
#include <numbers>
#include <variant>

namespace steradian::ui {

namespace {

/// Draws in units of half the icon's size around its centre.
struct Pen {
  ImDrawList& list;
  ImVec2 center;
  float half;
  ImU32 color;

  ImVec2 at(float x, float y) const { return {center.x + x * half, center.y + y * half}; }
  float width() const { return std::max(1.0f, half * 0.19f); }
  void line(float x0, float y0, float x1, float y1) const {
    list.AddLine(at(x0, y0), at(x1, y1), color, width());
  }
  void circle(float x, float y, float radius) const {
    list.AddCircle(at(x, y), radius * half, color, 0, width());
  }
  void dot(float x, float y, float radius) const { list.AddCircleFilled(at(x, y), radius * half, color); }
  void ellipse(float x, float y, float rx, float ry, float from = 0.0f,
               float to = 2.0f * std::numbers::pi_v<float>) const {
    constexpr int kSteps = 16;
    for (int i = 0; i <= kSteps; ++i) {
      const float angle = from + (to - from) * float(i) / kSteps;
      list.PathLineTo(at(x + rx * std::cos(angle), y + ry * std::sin(angle)));
    }
    list.PathStroke(color, 0, width());
  }
  void outline(std::initializer_list<ImVec2> points) const {
    for (const ImVec2 p : points) list.PathLineTo(at(p.x, p.y));
    list.PathStroke(color, ImDrawFlags_Closed, width());
  }
};

void draw(const Pen& pen, const Sphere&) {
  pen.circle(0, 0, 0.85f);
  pen.ellipse(0, 0, 0.85f, 0.3f, 0.0f, std::numbers::pi_v<float>);
}
void draw(const Pen& pen, const Plane&) {
  pen.outline({{-0.35f, -0.4f}, {1.0f, -0.4f}, {0.35f, 0.5f}, {-1.0f, 0.5f}});
  pen.line(0.05f, -0.4f, -0.35f, 0.5f);
  pen.line(-0.7f, 0.05f, 0.7f, 0.05f);
}
void draw(const Pen& pen, const Box&) {
  pen.outline({{0, -0.95f}, {0.85f, -0.5f}, {0.85f, 0.45f}, {0, 0.95f}, {-0.85f, 0.45f}, {-0.85f, -0.5f}});
  pen.line(0, 0, 0.85f, -0.5f);
  pen.line(0, 0, -0.85f, -0.5f);
  pen.line(0, 0, 0, 0.95f);
}
void draw(const Pen& pen, const Rect&) {
  pen.outline({{-0.35f, -0.4f}, {1.0f, -0.4f}, {0.35f, 0.5f}, {-1.0f, 0.5f}});
}
void draw(const Pen& pen, const Disk&) {
  pen.ellipse(0, 0, 0.95f, 0.45f);
}
void draw(const Pen& pen, const Cylinder&) {
  pen.ellipse(0, -0.6f, 0.7f, 0.28f);
  pen.ellipse(0, 0.6f, 0.7f, 0.28f, 0.0f, std::numbers::pi_v<float>);
  pen.line(-0.7f, -0.6f, -0.7f, 0.6f);
  pen.line(0.7f, -0.6f, 0.7f, 0.6f);
}
void draw(const Pen& pen, const MeshShape&) {
  pen.outline({{0, -0.9f}, {0.9f, 0.65f}, {-0.9f, 0.65f}});
  pen.outline({{0, 0.65f}, {0.45f, -0.12f}, {-0.45f, -0.12f}});
}
void draw(const Pen& pen, const PointLight&) {
  pen.circle(0, 0, 0.38f);
  for (int i = 0; i < 8; ++i) {
    const float x = std::cos(float(i) * std::numbers::pi_v<float> / 4),
                y = std::sin(float(i) * std::numbers::pi_v<float> / 4);
    pen.line(0.62f * x, 0.62f * y, 0.98f * x, 0.98f * y);
  }
}
void draw(const Pen& pen, const SpotLight&) {
  pen.outline({{-0.25f, -0.9f}, {0.25f, -0.9f}, {0.75f, 0.35f}, {-0.75f, 0.35f}});
  pen.line(-0.4f, 0.6f, -0.55f, 0.95f);
  pen.line(0, 0.6f, 0, 0.95f);
  pen.line(0.4f, 0.6f, 0.55f, 0.95f);
}
void draw(const Pen& pen, const DirectionalLight&) {
  for (const float x : {-0.6f, 0.0f, 0.6f}) {
    pen.line(x, -0.9f, x, 0.75f);
    pen.line(x, 0.85f, x - 0.22f, 0.5f);
    pen.line(x, 0.85f, x + 0.22f, 0.5f);
  }
}
void rays(const Pen& pen, float y) {
  pen.line(-0.45f, y, -0.65f, y + 0.4f);
  pen.line(0, y, 0, y + 0.45f);
  pen.line(0.45f, y, 0.65f, y + 0.4f);
}
void draw(const Pen& pen, const SphereLight&) {
  pen.circle(0, -0.25f, 0.62f);
  rays(pen, 0.5f);
}
void draw(const Pen& pen, const RectLight&) {
  pen.outline({{-0.85f, -0.75f}, {0.85f, -0.75f}, {0.85f, 0.1f}, {-0.85f, 0.1f}});
  rays(pen, 0.4f);
}
void draw(const Pen& pen, const DiskLight&) {
  pen.ellipse(0, -0.35f, 0.9f, 0.42f);
  rays(pen, 0.35f);
}
void draw(const Pen& pen, const EnvironmentLight&) {
  pen.ellipse(0, 0.35f, 0.95f, 0.95f, std::numbers::pi_v<float>, 2.0f * std::numbers::pi_v<float>);
  pen.line(-0.95f, 0.35f, 0.95f, 0.35f);
  pen.dot(0.3f, -0.05f, 0.2f);
}
void draw(const Pen& pen, const Camera&) {
  pen.outline({{-0.95f, -0.5f}, {0.35f, -0.5f}, {0.35f, 0.5f}, {-0.95f, 0.5f}});
  pen.outline({{0.35f, 0}, {0.95f, -0.45f}, {0.95f, 0.45f}});
}
void draw(const Pen& pen, const Group&) {
  pen.outline({{-0.9f, -0.65f}, {-0.2f, -0.65f}, {0, -0.4f}, {0.9f, -0.4f}, {0.9f, 0.65f}, {-0.9f, 0.65f}});
}
void draw(const Pen& pen, const Geometry& geometry) {
  std::visit([&](const auto& shape) { draw(pen, shape); }, geometry.shape);
}
void draw(const Pen& pen, const Light& light) {
  std::visit([&](const auto& kind) { draw(pen, kind); }, light.kind);
}

}  // namespace

void drawKindIcon(ImDrawList& list, ImVec2 center, float size, const edits::Content& content, ImU32 color) {
  const Pen pen{list, center, size * 0.5f, color};
  std::visit([&](const auto& kind) { draw(pen, kind); }, content);
}

void drawEye(ImDrawList& list, ImVec2 center, float size, bool open, ImU32 color) {
  const Pen pen{list, center, size * 0.5f, color};
  if (open) {
    pen.ellipse(0, 0, 1.0f, 0.58f);
    pen.dot(0, 0, 0.32f);
  } else {
    pen.ellipse(0, -0.2f, 1.0f, 0.6f, 0.15f, std::numbers::pi_v<float> - 0.15f);
  }
}

}  // namespace steradian::ui
