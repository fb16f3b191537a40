// SPDX-License-Identifier: MIT
// Previews, history, selection and the unsaved mark.
#include "editor/document.hpp"

#include <gtest/gtest.h>

#include "editor/edits.hpp"

using namespace steradian;
namespace e = steradian::edits;

namespace {
Scene moved(const Scene& scene, double x) {
  return e::setTransform(scene, Id(1), Transform{{x, 0, 0}});
}
}  // namespace

TEST(Document, a_drag_of_many_previews_is_one_step) {
  Document document(e::addGroup({}).scene);
  for (int i = 1; i <= 100; ++i) document.preview(moved(document.committed(), i));
  EXPECT_TRUE(document.previewing());
  EXPECT_EQ(document.scene().objects[0].transform.translation.x, 100.0);
  EXPECT_FALSE(document.undoName());
  document.commit("Move Group");
  EXPECT_EQ(document.undoName(), "Move Group");
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.scene().objects[0].transform.translation.x, 0.0);
  EXPECT_FALSE(document.undo());
}

TEST(Document, a_cancelled_preview_leaves_no_trace) {
  Document document(e::addGroup({}).scene);
  document.preview(moved(document.committed(), 5));
  document.cancelPreview();
  document.commit("Move");
  EXPECT_FALSE(document.undoName());
  EXPECT_EQ(document.scene().objects[0].transform.translation.x, 0.0);
}

TEST(Document, an_edit_that_changes_nothing_is_no_step) {
  Document document(e::addGroup({}).scene);
  document.apply(document.scene(), "Nothing");
  EXPECT_FALSE(document.undoName());
  EXPECT_FALSE(document.previewing());
}

TEST(Document, a_new_edit_forgets_what_was_undone) {
  Document document;
  document.apply(e::addGroup(document.scene()).scene, "Add Group");
  document.apply(e::addShape(document.scene(), Sphere{}).scene, "Add Sphere");
  document.undo();
  EXPECT_EQ(document.redoName(), "Add Sphere");
  document.apply(e::addShape(document.scene(), Box{}).scene, "Add Box");
  EXPECT_FALSE(document.redoName());
  EXPECT_EQ(document.history().steps().size(), 3u);
}

TEST(Document, is_unsaved_exactly_while_it_differs_from_the_file) {
  Document document({}, "/tmp/room.srad");
  EXPECT_EQ(document.title(), "room.srad");
  document.apply(e::addGroup(document.scene()).scene, "Add Group");
  EXPECT_EQ(document.title(), "room.srad*");
  document.undo();
  EXPECT_FALSE(document.unsaved());
  document.redo();
  document.markSaved("/tmp/other.srad");
  EXPECT_EQ(document.title(), "other.srad");
  document.undo();
  EXPECT_TRUE(document.unsaved());
  Document imported;
  imported.markUnsaved();
  EXPECT_EQ(imported.title(), "Untitled*");
}

TEST(Document, the_selection_never_holds_what_is_gone) {
  Document document;
  const auto sphere = e::addShape(document.scene(), Sphere{});
  document.apply(sphere.scene, "Add Sphere");
  document.selectOnly(sphere.id);
  EXPECT_EQ(document.active(), sphere.id);
  document.undo();
  EXPECT_TRUE(document.selection().empty());
  EXPECT_EQ(document.active(), Id::none);
  document.select({Id(1), Id(99)});
  EXPECT_TRUE(document.selection().empty());
}

TEST(Document, selection_toggles_and_extends_in_the_scenes_order) {
  Scene scene;
  for (int i = 0; i < 5; ++i) scene = e::addGroup(scene).scene;
  Document document(scene);
  document.selectOnly(Id(4));
  document.extendSelectionTo(Id(2));
  EXPECT_EQ(document.selection(), (Selection{Id(2), Id(3), Id(4)}));
  document.toggleSelected(Id(3));
  EXPECT_EQ(document.selection(), (Selection{Id(2), Id(4)}));
  document.toggleSelected(Id(5));
  EXPECT_EQ(document.active(), Id(5));
}

TEST(History, forgets_the_oldest_steps_beyond_its_memory_but_keeps_32) {
  History history(std::make_shared<const Scene>(), "Open", 1);
  for (int i = 1; i <= 100; ++i) {
    Scene scene;
    scene.name = std::to_string(i);
    history.push(std::make_shared<const Scene>(scene), "Edit");
  }
  EXPECT_EQ(history.steps().size(), 32u);
  EXPECT_EQ(history.current()->name, "100");
  history.goTo(0);
  EXPECT_EQ(history.current()->name, "69");
  EXPECT_FALSE(history.undoName());
}
