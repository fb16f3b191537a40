// SPDX-License-Identifier: MIT
// The viewport: navigation, picking and what lies over the picture. The picture itself is the Presenter's.
#pragma once
#include <functional>
#include <optional>

#include "editor/document.hpp"
#include "editor/ui/navigation.hpp"
#include "editor/ui/overlay.hpp"
#include "editor/ui/ui.hpp"
#include "renderer/presenter.hpp"

namespace steradian::ui {

/// Where the editor looks from. Not part of the document: looking around is no edit.
struct ViewState {
  OrbitView orbit;
  Id throughCamera = Id::none;  // look through this camera object; none = the free view
  bool overlay = true;
};

CameraView viewOf(const ViewState& state, const Scene& scene);
/// Leaves the camera and goes on with the free view from the same place.
void leaveCamera(ViewState& state, const Scene& scene);

/// The part of `panel` that the picture fills: all of it, or the camera's format when looking through one.
ViewRect pictureRect(const ViewState& state, const Scene& scene, const ViewRect& panel);

/// A click that wants to pick: where, in window units, and how it selects.
struct Click {
  ImVec2 at;
  Select::How how = Select::How::only;
};

/// Draws the overlay into the current window and handles the mouse. Returns a click, if there was one.
std::optional<Click> viewport(Ui& ui, ViewState& state, const Document& document, const ViewRect& panel);

/// Film pixels of a place in the picture, from the top left.
glm::ivec2 filmPixel(const ViewRect& picture, Extent film, ImVec2 at);

}  // namespace steradian::ui
