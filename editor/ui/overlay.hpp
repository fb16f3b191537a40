// SPDX-License-Identifier: MIT
// What is drawn over the picture: outlines of selected objects, marks for lights and cameras.
#pragma once
#include <optional>

#include <imgui.h>

#include "editor/document.hpp"
#include "editor/ui/ui.hpp"

namespace steradian::ui {

/// The part of the window that shows the picture, window units.
struct ViewRect {
  ImVec2 min, size;
  bool contains(ImVec2 p) const {
    return p.x >= min.x && p.y >= min.y && p.x < min.x + size.x && p.y < min.y + size.y;
  }
  float aspect() const { return size.y > 0 ? size.x / size.y : 1.0f; }
};

/// World to window under one camera.
class Projection {
 public:
  Projection(const CameraView& view, const ViewRect& rect);
  std::optional<ImVec2> point(const glm::dvec3& world) const;  // nullopt behind the eye
  /// Clipped at a plane just before the eye.
  void line(ImDrawList& list, const glm::dvec3& a, const glm::dvec3& b, ImU32 color, float width) const;

 private:
  ImVec2 onScreen(const glm::dvec3& camera) const;

  glm::dmat4 cameraFromWorld_;
  bool parallel_;
  double focal_;  // half heights per unit tangent; in parallel projection per metre
  ImVec2 center_;
  float halfHeight_;
};

void drawOverlay(Ui& ui, ImDrawList& list, const Document& document, const CameraView& view,
                 const ViewRect& rect, Id cameraInUse);

/// The light or camera whose mark is at `at`; the picture's own pick pass does not see them.
Id markAt(const Ui& ui, const Scene& scene, const CameraView& view, const ViewRect& rect, ImVec2 at,
          Id cameraInUse);

}  // namespace steradian::ui
