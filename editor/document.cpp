// SPDX-License-Identifier: MIT
// The document: previews, commits, undo, selection, and the unsaved mark.
#include "editor/document.hpp"

#include <algorithm>
#include <unordered_set>

namespace steradian {

Document::Document(Scene scene, std::filesystem::path path)
    : history_(std::make_shared<const Scene>(std::move(scene)), path.empty() ? "New" : "Open"),
      shown_(history_.current()),
      saved_(shown_),
      path_(std::move(path)) {}

void Document::show(Snapshot scene) {
  shown_ = std::move(scene);
  dropStaleSelection();
}

void Document::preview(Scene scene) {
  show(std::make_shared<const Scene>(std::move(scene)));
}

void Document::cancelPreview() {
  if (previewing()) show(history_.current());
}

void Document::commit(std::string name) {
  if (!previewing()) return;
  if (*shown_ == committed())
    show(history_.current());
  else
    history_.push(shown_, std::move(name));
}

void Document::apply(Scene next, std::string name) {
  preview(std::move(next));
  commit(std::move(name));
}

bool Document::undo() {
  cancelPreview();
  if (history_.index() == 0) return false;
  goTo(history_.index() - 1);
  return true;
}

bool Document::redo() {
  cancelPreview();
  if (history_.index() + 1 >= history_.steps().size()) return false;
  goTo(history_.index() + 1);
  return true;
}

void Document::goTo(std::size_t step) {
  history_.goTo(step);
  show(history_.current());
}

void Document::dropStaleSelection() {
  if (selection_.empty()) return;
  std::unordered_set<Id> present;
  for (const Object& object : shown_->objects) present.insert(object.id);
  std::erase_if(selection_, [&](Id id) { return present.count(id) == 0; });
  if (!selection_.count(active_)) active_ = selection_.empty() ? Id::none : *selection_.rbegin();
}

void Document::select(Selection objects) {
  selection_ = std::move(objects);
  dropStaleSelection();
  if (!selection_.count(active_)) active_ = selection_.empty() ? Id::none : *selection_.rbegin();
}

void Document::selectOnly(Id object) {
  active_ = object;
  select(object == Id::none ? Selection{} : Selection{object});
}

void Document::toggleSelected(Id object) {
  Selection next = selection_;
  if (next.erase(object) == 0) {
    next.insert(object);
    active_ = object;
  }
  select(std::move(next));
}

void Document::extendSelectionTo(Id object) {
  const auto& objects = shown_->objects;
  const auto at = [&](Id id) {
    return std::find_if(objects.begin(), objects.end(), [&](const Object& o) { return o.id == id; });
  };
  const auto from = at(active_), to = at(object);
  if (from == objects.end() || to == objects.end()) return selectOnly(object);
  Selection next = selection_;
  for (auto o = std::min(from, to); o <= std::max(from, to); ++o) next.insert(o->id);
  select(std::move(next));
}

std::string Document::title() const {
  return (path_.empty() ? "Untitled" : path_.filename().string()) + (unsaved() ? "*" : "");
}

bool Document::unsaved() const {
  if (saved_ == history_.current()) return false;
  return !saved_ || !(*saved_ == committed());
}

void Document::markSaved(std::filesystem::path path) {
  path_ = std::move(path);
  saved_ = history_.current();
}

}  // namespace steradian
