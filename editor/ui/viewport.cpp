// SPDX-License-Identifier: MIT
// Mouse handling of the viewport.
#include "editor/ui/viewport.hpp"

#include <algorithm>
#include <cmath>

#include "editor/ui/style.hpp"

namespace steradian::ui {

namespace {

void drag(ViewState& state, const Scene& scene, ImVec2 delta, float height) {
  const ImGuiIO& io = ImGui::GetIO();
  if (delta.x == 0 && delta.y == 0) return;
  leaveCamera(state, scene);
  const double right = delta.x / height, down = delta.y / height;
  if (io.KeyShift)
    state.orbit.pan(right, down);
  else if (io.KeyCtrl)
    state.orbit.zoom(-down * 20.0);
  else
    state.orbit.orbit(right, down);
}

Select::How howToSelect() {
  const ImGuiIO& io = ImGui::GetIO();
  return io.KeyCtrl || io.KeyShift ? Select::How::toggle : Select::How::only;
}

std::optional<Click> handleMouse(ViewState& state, const Scene& scene, float height) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const bool navigating =
      ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (io.KeyAlt && ImGui::IsMouseDown(ImGuiMouseButton_Left));
  if (active && navigating) drag(state, scene, io.MouseDelta, height);
  if (hovered && io.MouseWheel != 0.0f) {
    leaveCamera(state, scene);
    state.orbit.zoom(io.MouseWheel);
  }
  const bool still = io.MouseDragMaxDistanceSqr[0] < io.MouseDragThreshold * io.MouseDragThreshold;
  if (hovered && still && !io.KeyAlt && ImGui::IsMouseReleased(ImGuiMouseButton_Left))
    return Click{io.MousePos, howToSelect()};
  return std::nullopt;
}

void drawFrame(Ui& ui, ImDrawList& list, const ViewState& state, const Scene& scene,
               const ViewRect& picture) {
  const Object* camera = find(scene, state.throughCamera);
  if (!camera) return;
  const std::string text = "Through " + camera->name;
  const ImVec2 at{picture.min.x + ui.px(10), picture.min.y + ui.px(8)};
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - ui.px(5), at.y - ui.px(2)}, {at.x + size.x + ui.px(5), at.y + size.y + ui.px(2)},
                     IM_COL32(20, 21, 24, 170), ui.px(4));
  list.AddText(at, color::kText, text.c_str());
}

}  // namespace

CameraView viewOf(const ViewState& state, const Scene& scene) {
  const Object* object = find(scene, state.throughCamera);
  const auto* camera = object ? std::get_if<steradian::Camera>(&object->content) : nullptr;
  if (!camera) return state.orbit.view();
  glm::dmat4 world = worldFromObject(scene, object->id);
  for (int i = 0; i < 3; ++i) world[i] = glm::normalize(world[i]);  // a camera ignores scale
  return {world, camera->fovY, *camera};
}

void leaveCamera(ViewState& state, const Scene& scene) {
  if (state.throughCamera == Id::none) return;
  const CameraView view = viewOf(state, scene);
  state.throughCamera = Id::none;
  state.orbit.lookAs(view, state.orbit.distance());
}

ViewRect pictureRect(const ViewState& state, const Scene& scene, const ViewRect& panel) {
  if (!find(scene, state.throughCamera)) return panel;
  const float wanted = float(scene.render.width) / float(std::max(scene.render.height, 1));
  ImVec2 size = panel.size;
  if (panel.aspect() > wanted)
    size.x = std::max(1.0f, std::round(size.y * wanted));
  else
    size.y = std::max(1.0f, std::round(size.x / wanted));
  return {{panel.min.x + std::floor(0.5f * (panel.size.x - size.x)),
           panel.min.y + std::floor(0.5f * (panel.size.y - size.y))},
          size};
}

std::optional<Click> viewport(Ui& ui, ViewState& state, const Document& document, const ViewRect& panel) {
  const Scene& scene = document.scene();
  ImGui::SetCursorScreenPos(panel.min);
  ImGui::InvisibleButton("viewport", panel.size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  ui.mark("viewport");
  const std::optional<Click> click = handleMouse(state, scene, panel.size.y);
  const ViewRect picture = pictureRect(state, scene, panel);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (state.overlay) drawOverlay(ui, list, document, viewOf(state, scene), picture, state.throughCamera);
  drawFrame(ui, list, state, scene, picture);
  return click;
}

glm::ivec2 filmPixel(const ViewRect& picture, Extent film, ImVec2 at) {
  const float x = (at.x - picture.min.x) / picture.size.x * float(film.width);
  const float y = (at.y - picture.min.y) / picture.size.y * float(film.height);
  return {std::clamp(int(std::floor(x)), 0, film.width - 1),
          std::clamp(int(std::floor(y)), 0, film.height - 1)};
}

}  // namespace steradian::ui
