// SPDX-License-Identifier: MIT
// Replaces a file so that at every instant it is whole: the old or the new.
#include "plugins/host/atomic_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace steradian::plugins {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kPrefix = ".steradian-save-";

[[noreturn]] void fail(const fs::path& path, const std::string& what, int error) {
  const char* remedy = error == ENOSPC || error == EDQUOT ? "; free some space and save again"
                       : error == EACCES || error == EPERM || error == EROFS
                           ? "; save to a place that you may write to"
                           : "";
  throw Error(ExitCode::io, path.string() + ": " + what + ": " + std::strerror(error) + remedy +
                                " (an existing file was left as it was)");
}

/// Beyond RLIMIT_FSIZE the kernel sends SIGXFSZ, which kills; held back, write() just returns EFBIG.
class HoldFileSizeSignal {
 public:
  HoldFileSizeSignal() {
    sigemptyset(&set_);
    sigaddset(&set_, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &set_, &old_);
  }
  ~HoldFileSizeSignal() {
    const timespec now{};
    if (!sigismember(&old_, SIGXFSZ)) sigtimedwait(&set_, nullptr, &now);
    pthread_sigmask(SIG_SETMASK, &old_, nullptr);
  }

 private:
  sigset_t set_, old_;
};

/// The temporary file: locked while its writer lives, removed unless it was renamed.
class Temporary {
 public:
  Temporary(const fs::path& target, mode_t mode) : target_(target) {
    static std::atomic<unsigned> counter{0};
    for (int attempt = 0; attempt < 1000 && fd_ < 0; ++attempt) {
      path_ = target.parent_path() /
              (std::string(kPrefix) + std::to_string(getpid()) + "-" + std::to_string(counter++) + ".tmp");
      fd_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (fd_ < 0 && errno != EEXIST) fail(target, "cannot create a file beside it", errno);
    }
    if (fd_ < 0) fail(target, "cannot create a file beside it", EEXIST);
    flock(fd_, LOCK_EX | LOCK_NB);
  }
  ~Temporary() {
    if (fd_ >= 0) close(fd_);
    if (!path_.empty()) unlink(path_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  void keepModeAndOwner(const struct stat& old) {
    // The owner can be kept only by root; the mode goes last because chown clears bits of it.
    if (fchown(fd_, old.st_uid, old.st_gid) != 0 && errno != EPERM)
      fail(target_, "cannot keep its owner", errno);
    if (fchmod(fd_, old.st_mode & 07777) != 0) fail(target_, "cannot keep its mode", errno);
  }
  void write(std::string_view bytes) {
    const HoldFileSizeSignal hold;
    while (!bytes.empty()) {
      const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) fail(target_, "cannot be written", n == 0 ? ENOSPC : errno);
      bytes.remove_prefix(std::size_t(n));
    }
    if (fsync(fd_) != 0) fail(target_, "cannot be written to the disk", errno);
  }
  void becomeTarget() {
    if (rename(path_.c_str(), target_.c_str()) != 0) fail(target_, "cannot be replaced", errno);
    path_.clear();
  }

 private:
  fs::path target_, path_;
  int fd_ = -1;
};

/// The file behind symbolic links, also when it does not exist yet.
fs::path throughLinks(fs::path path) {
  const fs::path asked = path;
  for (int hop = 0; hop < 40; ++hop) {
    std::error_code none;
    if (!fs::is_symlink(path, none)) return path;
    const fs::path next = fs::read_symlink(path, none);
    if (none) fail(asked, "cannot follow its link", none.value());
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  fail(asked, "cannot follow its link", ELOOP);
}

/// Removes what writers left that were killed: their process is gone and nobody holds the lock.
void sweep(const fs::path& folder) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (name.compare(0, kPrefix.size(), kPrefix) != 0) continue;
    const pid_t owner = pid_t(std::atol(name.c_str() + kPrefix.size()));
    if (owner <= 0 || kill(owner, 0) == 0 || errno != ESRCH) continue;
    const int fd = open(entry.path().c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    if (fd < 0) continue;
    if (flock(fd, LOCK_EX | LOCK_NB) == 0) unlink(entry.path().c_str());
    close(fd);
  }
}

/// Makes the rename itself durable; file systems without it say EINVAL.
void syncFolder(const fs::path& target) {
  const int fd = open(target.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;  // a folder that may be written but not read
  const int error = fsync(fd) != 0 ? errno : 0;
  close(fd);
  if (error && error != EINVAL)
    throw Error(ExitCode::io,
                target.string() + ": was replaced, but the disk did not confirm it: " + std::strerror(error));
}

}  // namespace

void writeFileAtomically(const fs::path& asked, std::string_view bytes) {
  std::error_code none;
  const fs::path target = throughLinks(fs::absolute(asked, none));
  if (none || !target.has_filename()) fail(asked, "is not the name of a file", EINVAL);
  struct stat old {};
  const bool exists = stat(target.c_str(), &old) == 0;
  if (!exists && errno != ENOENT) fail(asked, "cannot be written", errno);
  if (exists && S_ISDIR(old.st_mode)) fail(asked, "cannot be written", EISDIR);
  if (exists && !S_ISREG(old.st_mode)) fail(asked, "is not a regular file", EINVAL);
  if (exists && access(target.c_str(), W_OK) != 0) fail(asked, "cannot be written", errno);
  sweep(target.parent_path());
  Temporary temporary(target, exists ? 0600 : 0666);
  if (exists) temporary.keepModeAndOwner(old);
  temporary.write(bytes);
  temporary.becomeTarget();
  syncFolder(target);
}

}  // namespace steradian::plugins
