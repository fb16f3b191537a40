// SPDX-License-Identifier: MIT
// The only mutable thing of the editor's model: current scene, history, selection, file, unsaved mark.
#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/history.hpp"
#include "renderer/scene/scene.hpp"

namespace steradian {

using Selection = std::set<Id>;

class Document {
 public:
  /// An untitled document (`path` empty) or one just read from `path`; in both cases nothing is unsaved.
  explicit Document(Scene scene = {}, std::filesystem::path path = {});

  /// What is to be shown: the preview while a drag runs, else the committed scene.
  const Scene& scene() const { return *shown_; }
  /// The same, to hold on to; the pointer differs exactly when the document may have changed.
  const Snapshot& snapshot() const { return shown_; }
  const Scene& committed() const { return *history_.current(); }

  /// Shows `scene` without a history step: call every frame of a drag, with an edit of committed().
  void preview(Scene scene);
  bool previewing() const { return shown_ != history_.current(); }
  void cancelPreview();
  /// Makes the preview one step; nothing happens when it equals the committed scene.
  void commit(std::string name);
  /// A finished edit in one call.
  void apply(Scene next, std::string name);

  // A preview that runs is cancelled first. False when there is nothing to take back or bring back.
  bool undo();
  bool redo();
  void goTo(std::size_t step);  // the history panel
  std::optional<std::string> undoName() const { return history_.undoName(); }
  std::optional<std::string> redoName() const { return history_.redoName(); }
  const History& history() const { return history_; }

  /// Ids that no longer exist are never in it.
  const Selection& selection() const { return selection_; }
  std::vector<Id> selected() const { return {selection_.begin(), selection_.end()}; }
  Id active() const { return active_; }  // the one selected last; none when nothing is
  void select(Selection objects);
  void selectOnly(Id object);  // none = nothing
  void toggleSelected(Id object);
  /// From the active object to `object` in the scene's order.
  void extendSelectionTo(Id object);

  const std::filesystem::path& path() const { return path_; }  // empty = never saved
  std::string title() const;  // "room.srad" or "Untitled", with * when unsaved
  /// The committed scene differs from what is on disk; undoing to the saved state clears it.
  bool unsaved() const;
  /// After a successful save of committed().
  void markSaved(std::filesystem::path path);
  /// The scene has no file of its own yet (an import, a recovery): ask before losing it.
  void markUnsaved() { saved_.reset(); }

 private:
  void show(Snapshot scene);
  void dropStaleSelection();

  History history_;
  Snapshot shown_;
  Snapshot saved_;
  Selection selection_;
  Id active_ = Id::none;
  std::filesystem::path path_;
};

}  // namespace steradian
