// SPDX-License-Identifier: MIT
// A save is whole or did not happen: full disks, limits, links, modes, SIGKILL.
#include "plugins/host/atomic_file.hpp"

#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>
#include <thread>

#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

class AtomicFile : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    place = folder / "place";
    fs::create_directory(place);
  }
  std::size_t filesIn(const fs::path& where) {
    return std::size_t(std::distance(fs::directory_iterator(where), {}));
  }
  fs::path place;
};

/// The soft limit of file sizes while it lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &old_); }

 private:
  rlimit old_;
};

Scene manyObjects() {
  Scene scene;
  for (std::uint32_t i = 1; i <= 5000; ++i)
    scene.objects.push_back({.id = Id{i}, .name = "an object with a name"});
  scene.nextId = Id{5001};
  return scene;
}

TEST_F(AtomicFile, WritesAndReplaces) {
  writeFileAtomically(place / "a", "one");
  EXPECT_EQ(readText(place / "a"), "one");
  writeFileAtomically(place / "a", "");
  EXPECT_EQ(readText(place / "a"), "");
  EXPECT_EQ(filesIn(place), 1u);
}

TEST_F(AtomicFile, ASizeLimitLeavesTheOldFileAndNothingElse) {
  writeFileAtomically(place / "a.srad", "old");
  const Scene scene = manyObjects();
  const std::vector<float> noise = [] {
    std::mt19937 random(1);
    std::vector<float> out(200 * 200 * 3);
    for (float& v : out) v = float(random()) * 0x1p-32f;
    return out;
  }();
  const ImageToSave image{.width = 200, .height = 200, .radiance = noise.data(), .displayed = noise.data()};
  stockPlugins().exportImage(image, folder / "warm.exr");  // libraries are loaded before the limit holds
  stockPlugins().exportImage(image, folder / "warm.png");
  const FileSizeLimit limit(64 << 10);
  for (const auto& work : std::initializer_list<std::function<void()>>{
           [&] { stockPlugins().exportScene(scene, place / "a.srad"); },
           [&] { stockPlugins().exportImage(image, place / "a.exr"); },
           [&] { stockPlugins().exportImage(image, place / "a.png"); }}) {
    const auto [message, code] = faultOf(work);
    EXPECT_EQ(code, ExitCode::io) << message;
    EXPECT_CONTAINS(message, "File too large");
  }
  EXPECT_EQ(readText(place / "a.srad"), "old");
  EXPECT_EQ(filesIn(place), 1u);
}

TEST_F(AtomicFile, AFullDiskLeavesTheOldFileAndNothingElse) {
  if (mount("tmpfs", place.c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "may not mount a small disk here";
  writeFileAtomically(place / "a.srad", "old");
  const auto [message, code] = faultOf([&] { stockPlugins().exportScene(manyObjects(), place / "a.srad"); });
  EXPECT_EQ(code, ExitCode::io);
  EXPECT_CONTAINS(message, "No space left on device; free some space");
  EXPECT_EQ(readText(place / "a.srad"), "old");
  EXPECT_EQ(filesIn(place), 1u);
  umount(place.c_str());
}

TEST_F(AtomicFile, ASymbolicLinkIsWrittenThrough) {
  fs::create_directory(place / "real");
  writeText(place / "real/a", "old");
  fs::create_symlink("real/a", place / "link");
  fs::create_symlink("link", place / "link2");
  writeFileAtomically(place / "link2", "new");
  EXPECT_TRUE(fs::is_symlink(place / "link") && fs::is_symlink(place / "link2"));
  EXPECT_EQ(readText(place / "real/a"), "new");
  fs::create_symlink("real/later", place / "dangling");
  writeFileAtomically(place / "dangling", "new");
  EXPECT_EQ(readText(place / "real/later"), "new");
  fs::create_symlink("loop", place / "loop");
  EXPECT_EQ(faultOf([&] { writeFileAtomically(place / "loop", "x"); }).second, ExitCode::io);
}

TEST_F(AtomicFile, TheModeIsKept) {
  writeText(place / "a", "old");
  chmod((place / "a").c_str(), 0640);
  writeFileAtomically(place / "a", "new");
  struct stat s {};
  stat((place / "a").c_str(), &s);
  EXPECT_EQ(s.st_mode & 07777, 0640u);
}

TEST_F(AtomicFile, FoldersAndMissingFoldersAreRefused) {
  EXPECT_EQ(faultOf([&] { writeFileAtomically(place, "x"); }).second, ExitCode::io);
  EXPECT_CONTAINS(faultOf([&] { writeFileAtomically(place / "none/a", "x"); }).first,
                  "No such file or directory");
  EXPECT_EQ(faultOf([&] { writeFileAtomically("/dev/full", "x"); }).second, ExitCode::io);
}

TEST_F(AtomicFile, AReadOnlyFileOrFolderIsRefusedForAnOrdinaryUser) {
  writeText(place / "a", "old");
  chmod((place / "a").c_str(), 0444);
  chmod(folder.c_str(), 0755);
  const pid_t child = fork();
  if (child == 0) {
    if (getuid() == 0 && setuid(65534) != 0) _exit(9);
    const bool file = faultOf([&] { writeFileAtomically(place / "a", "new"); }).second == ExitCode::io;
    chmod(place.c_str(), 0555);
    const bool inFolder = faultOf([&] { writeFileAtomically(place / "b", "new"); }).second == ExitCode::io;
    chmod(place.c_str(), 0755);
    _exit(file && inFolder ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_EQ(readText(place / "a"), "old");
}

TEST_F(AtomicFile, After200KillsTheFileIsAlwaysWholeAndNoRestRemains) {
  const fs::path file = place / "a";
  const std::string one(1 << 20, 'a'), two((1 << 20) + 1, 'b');
  writeFileAtomically(file, one);
  std::mt19937 random(7);
  int torn = 0, leftovers = 0;
  for (int i = 0; i < 200; ++i) {
    const pid_t child = fork();
    if (child == 0)
      for (bool odd = i % 2;; odd = !odd) writeFileAtomically(file, odd ? one : two);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 8000));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    leftovers += filesIn(place) > 1;
    const std::string now = readText(file);
    torn += now != one && now != two;
  }
  EXPECT_EQ(torn, 0);
  EXPECT_GT(leftovers, 0) << "no kill hit a save, so this test showed nothing";
  writeFileAtomically(file, one);
  EXPECT_EQ(filesIn(place), 1u) << "the next save sweeps what killed ones left";
}

}  // namespace
}  // namespace steradian::plugins
