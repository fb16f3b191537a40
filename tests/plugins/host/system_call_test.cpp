// SPDX-License-Identifier: MIT
// A save under a system that fails at the k-th call, for every k. The functions below replace those of libc
// for this program alone.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdarg>

#include "plugins/host/atomic_file.hpp"
#include "tests/plugins/fixture.hpp"

namespace {

enum class Mode { off, fail, shortWrite, interrupt };

struct Injection {
  Mode mode = Mode::off;
  int call = 0;    // calls seen so far
  int failAt = 0;  // this one, counted from 1
  int error = EIO;
  bool hits() { return mode != Mode::off && ++call == failAt; }
} injection;

template <class Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool failing() {
  if (injection.mode != Mode::fail || !injection.hits()) return false;
  errno = injection.error;
  return true;
}

}  // namespace

extern "C" {

ssize_t write(int fd, const void* data, size_t size) {
  const auto next = real<ssize_t (*)(int, const void*, size_t)>("write");
  if (injection.mode == Mode::shortWrite && injection.hits())
    return next(fd, data, size > 1 ? size / 2 : size);
  if (injection.mode == Mode::interrupt && injection.hits()) {
    errno = EINTR;
    return -1;
  }
  return failing() ? -1 : next(fd, data, size);
}
int fsync(int fd) {
  return failing() ? -1 : real<int (*)(int)>("fsync")(fd);
}
int fchmod(int fd, mode_t mode) noexcept {
  return failing() ? -1 : real<int (*)(int, mode_t)>("fchmod")(fd, mode);
}
int fchown(int fd, uid_t user, gid_t group) noexcept {
  return failing() ? -1 : real<int (*)(int, uid_t, gid_t)>("fchown")(fd, user, group);
}
int rename(const char* from, const char* to) noexcept {
  return failing() ? -1 : real<int (*)(const char*, const char*)>("rename")(from, to);
}
int open(const char* path, int flags, ...) {
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(list, mode_t) : 0;
  va_end(list);
  if ((flags & O_CREAT) && failing()) return -1;
  return real<int (*)(const char*, int, ...)>("open")(path, flags, mode);
}

}  // extern "C"

namespace steradian::plugins {
namespace {

using SystemCall = FolderTest;

/// Calls that a save of a file of this size makes; also shows that the replaced functions are the ones in
/// use.
int callsOfOneSave(const fs::path& file, Mode mode) {
  injection = {.mode = mode, .failAt = 0};
  writeFileAtomically(file, std::string(100'000, 'n'));
  const int calls = injection.call;
  injection = {};
  return calls;
}

TEST_F(SystemCall, FailingAtAnyPlaceLeavesTheOldOrTheNewFileWholeAndNothingElse) {
  const fs::path place = folder / "place", file = place / "a";
  fs::create_directory(place);
  const std::string old = "old", fresh(100'000, 'n');
  writeText(file, old);
  const int calls = callsOfOneSave(file, Mode::fail);
  ASSERT_GE(calls, 7);  // open, chown, chmod, write, fsync, rename, fsync of the folder
  int kept = 0;
  for (const int error : {EIO, ENOSPC, EDQUOT})
    for (int k = 1; k <= calls; ++k) {
      writeText(file, old);
      injection = {.mode = Mode::fail, .failAt = k, .error = error};
      const auto [message, code] = faultOf([&] { writeFileAtomically(file, fresh); });
      injection = {};
      EXPECT_EQ(code, ExitCode::io) << "call " << k << ": " << message;
      const std::string now = readText(file);
      EXPECT_TRUE(now == old || now == fresh) << "call " << k << " tore the file";
      kept += now == old;
      EXPECT_EQ(std::distance(fs::directory_iterator(place), {}), 1) << "call " << k << " left a file";
    }
  EXPECT_EQ(kept, 3 * (calls - 1));  // only the last call comes after the replacement
}

TEST_F(SystemCall, ShortAndInterruptedWritesAreContinued) {
  const fs::path file = folder / "a";
  const std::string fresh(100'000, 'n');
  for (const Mode mode : {Mode::shortWrite, Mode::interrupt}) {
    writeText(file, "old");
    injection = {.mode = mode, .failAt = 1};
    writeFileAtomically(file, fresh);
    EXPECT_EQ(injection.call, 2) << "the write was not continued by a second one";
    injection = {};
    EXPECT_EQ(readText(file), fresh);
  }
}

}  // namespace
}  // namespace steradian::plugins
