// SPDX-License-Identifier: MIT
// The list of recent files and where it lives.
#include "editor/recent_files.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <fstream>

using namespace steradian;
namespace fs = std::filesystem;

namespace {
struct RecentFilesTest : testing::Test {
  fs::path folder = fs::temp_directory_path() / ("steradian-recent-" + std::to_string(::getpid()));
  fs::path file = folder / "state" / "recent";
  void TearDown() override { fs::remove_all(folder); }
};
}  // namespace

TEST_F(RecentFilesTest, come_back_newest_first_without_repeats) {
  RecentFiles recent(file);
  for (const char* path : {"/a.srad", "/b with space.srad", "/a.srad"}) recent.add(path);
  const std::vector<fs::path> expected{"/a.srad", "/b with space.srad"};
  EXPECT_EQ(recent.paths(), expected);
  EXPECT_EQ(RecentFiles(file).paths(), expected);
  recent.remove("/a.srad");
  EXPECT_EQ(RecentFiles(file).paths().size(), 1u);
}

TEST_F(RecentFilesTest, are_few) {
  RecentFiles recent(file);
  for (int i = 0; i < 30; ++i) recent.add("/" + std::to_string(i));
  EXPECT_EQ(RecentFiles(file).paths().size(), RecentFiles::kMost);
  EXPECT_EQ(recent.paths().front(), "/29");
}

TEST_F(RecentFilesTest, survive_a_file_of_nonsense_and_a_folder_that_cannot_be_made) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "not absolute\n\xff\xfe\n\n/ok.srad\n";
  EXPECT_EQ(RecentFiles(file).paths(), std::vector<fs::path>{"/ok.srad"});
  RecentFiles unwritable("/dev/null/recent");
  unwritable.add("/a.srad");
  EXPECT_EQ(unwritable.paths().size(), 1u);
}

TEST_F(RecentFilesTest, live_in_the_xdg_state_folder_and_relative_values_are_ignored) {
  ::setenv("HOME", "/home/someone", 1);
  ::setenv("XDG_STATE_HOME", "/state", 1);
  EXPECT_EQ(stateFolder(), fs::path("/state/steradian"));
  ::setenv("XDG_STATE_HOME", "relative", 1);
  EXPECT_EQ(stateFolder(), fs::path("/home/someone/.local/state/steradian"));
  ::unsetenv("XDG_STATE_HOME");
  ::unsetenv("HOME");
  EXPECT_EQ(stateFolder(), std::nullopt);
}
