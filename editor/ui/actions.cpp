// SPDX-License-Identifier: MIT
// Requests become edits, selections and views. Faults become messages; the scene stays as it was.
#include <utility>

#include "editor/ui/application.hpp"
#include "editor/ui/placement.hpp"

namespace steradian::ui {

void Application::carryOutRequests() {
  const std::vector<Request> requests = std::exchange(requests_, {});
  try {
    if (click_) clicked(*click_);
    for (const Request& request : requests)
      std::visit([this](const auto& wanted) { carryOut(wanted); }, request);
  } catch (const std::exception& error) {
    messages_.error(error.what());
  }
}

void Application::carryOut(const Run& request) {
  runFileCommand(request.command);
  runEditCommand(request.command);
  runViewCommand(request.command);
}

void Application::runEditCommand(Command command) {
  const std::vector<Id> selected = document_.selected();
  const Object* active = find(document_.scene(), document_.active());
  const std::string what =
      selected.size() == 1 && active ? active->name : std::to_string(selected.size()) + " objects";
  if (command == Command::undo) document_.undo();
  if (command == Command::redo) document_.redo();
  if (command == Command::selectNone) document_.selectOnly(Id::none);
  if (command == Command::selectAll) {
    Selection all;
    for (const Object& object : document_.scene().objects) all.insert(object.id);
    document_.select(std::move(all));
  }
  if (selected.empty()) return;
  if (command == Command::duplicate) {
    edits::AddedMany copies = edits::duplicate(document_.scene(), selected);
    edit(std::move(copies.scene), "Duplicate " + what);
    document_.select({copies.ids.begin(), copies.ids.end()});
  }
  if (command == Command::remove) edit(edits::remove(document_.scene(), selected), "Delete " + what);
  if (command == Command::toggleVisible) toggleVisible();
  if (command == Command::rename) {
    outliner_.renaming = document_.active();
    outliner_.renameStarts = options_.outliner = true;
  }
}

void Application::toggleVisible() {
  const Object* active = find(document_.scene(), document_.active());
  const bool visible = active && !active->visible;
  edit(edits::setVisible(document_.scene(), document_.selected(), visible), visible ? "Show" : "Hide");
}

void Application::runViewCommand(Command command) {
  switch (command) {
    case Command::addMenu:
      addMenuWanted_ = true;
      break;
    case Command::focusSelection:
      frameObjects(&document_.selection());
      break;
    case Command::frameAll:
      frameObjects(nullptr);
      break;
    case Command::lookThrough:
      toggleLookThrough();
      break;
    case Command::viewToCamera:
      moveCameraToView();
      break;
    case Command::togglePause:
      paused_ = !paused_;
      break;
    case Command::showKeys:
      info_.showKeys();
      break;
    case Command::showAbout:
      info_.showAbout();
      break;
    default:
      break;
  }
}

void Application::carryOut(const OpenFile& request) {
  guarded([this, path = request.path] { openFile(path); });
}

void Application::carryOut(const AddObject& request) {
  Place place{view_.orbit.pivot(), {0, 1, 0}, view_.orbit.distance()};
  const Extent film = live_.film();
  if (const auto hit = live_.pick(film.width / 2, film.height / 2); hit && hit->object != Id::none)
    place = {hit->position, hit->normal, hit->distance};
  const Scene& scene = document_.scene();
  edits::Added added = placed(scene, request.content, place, viewOf(view_, scene));
  edit(std::move(added.scene), "Add " + edits::kindName(request.content));
  document_.selectOnly(added.id);
}

void Application::carryOut(const Select& request) {
  switch (request.how) {
    case Select::How::only:
      document_.selectOnly(request.object);
      break;
    case Select::How::toggle:
      document_.toggleSelected(request.object);
      break;
    case Select::How::extend:
      document_.extendSelectionTo(request.object);
      break;
  }
}

void Application::clicked(const Click& click) {
  const ViewRect rect = picture();
  const Scene& scene = document_.scene();
  if (!rect.contains(click.at)) return;
  const Ui ui{window_.scale().units, labels_, requests_};
  Id object = Id::none;
  if (view_.overlay) object = markAt(ui, scene, viewOf(view_, scene), rect, click.at, view_.throughCamera);
  if (object == Id::none) {
    const glm::ivec2 pixel = filmPixel(rect, live_.film(), click.at);
    if (const auto hit = live_.pick(pixel.x, pixel.y)) object = hit->object;
  }
  if (object == Id::none && click.how == Select::How::toggle) return;
  carryOut(Select{object, click.how});
}

void Application::carryOut(const LookThrough& request) {
  if (request.camera == Id::none)
    leaveCamera(view_, document_.scene());
  else
    view_.throughCamera = request.camera;
}

void Application::toggleLookThrough() {
  if (view_.throughCamera != Id::none) return leaveCamera(view_, document_.scene());
  const Scene& scene = document_.scene();
  const auto isCamera = [](const Object* object) {
    return object && std::holds_alternative<steradian::Camera>(object->content);
  };
  if (isCamera(find(scene, document_.active())))
    view_.throughCamera = document_.active();
  else if (isCamera(find(scene, scene.activeCamera)))
    view_.throughCamera = scene.activeCamera;
  else
    for (const Object& object : scene.objects)
      if (isCamera(&object)) {
        view_.throughCamera = object.id;
        return;
      }
  if (view_.throughCamera == Id::none) messages_.note("The scene has no camera. Add one with Shift+A.");
}

void Application::moveCameraToView() {
  const Scene& scene = document_.scene();
  const Object* active = find(scene, document_.active());
  const bool chosen = active && std::holds_alternative<steradian::Camera>(active->content);
  const Id camera = chosen ? active->id : scene.activeCamera;
  const Object* object = find(scene, camera);
  if (!object) return messages_.note("The scene has no active camera. Select one, or add one with Shift+A.");
  edit(cameraAtView(scene, camera, viewOf(view_, scene)), "Move " + object->name + " to view");
}

void Application::frameObjects(const Selection* objects) {
  leaveCamera(view_, document_.scene());
  if (const auto bounds = boundsOf(document_.scene(), objects))
    view_.orbit.frame(*bounds, layout_.viewport.aspect());
}

}  // namespace steradian::ui
