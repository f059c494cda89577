#include "core/files/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <thread>

#include "core/error.hpp"
#include "core/files/output_file.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds kBetweenTries{20};

fs::path parent_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

int opened(const fs::path& file, int flags) {
  int descriptor = -1;
  do {
    descriptor = ::open(file.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, 0666);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

/// Opens the lock file, made where there is none. One that another user's program left may only be
/// read, which is enough to lock it. -1 with `errno` where that is not permitted either.
int opened_or_made(const fs::path& file) {
  while (true) {
    const int descriptor = opened(file, O_RDWR | O_CREAT);
    if (descriptor >= 0 || errno != EACCES) return descriptor;
    const int readable = opened(file, O_RDONLY);
    if (readable >= 0) return readable;
    if (errno == ENOENT && ::faccessat(AT_FDCWD, parent_of(file).c_str(), W_OK, AT_EACCESS) == 0) {
      continue;  // its holder has just removed it
    }
    errno = EACCES;
    return -1;
  }
}

[[noreturn]] void refuse_lock(const fs::path& file, const fs::path& target, int reason) {
  std::error_code code;
  const bool there = fs::exists(fs::symlink_status(file, code));
  throw InputError(file.string() + ": can't be " + (there ? "opened" : "made") + " (" +
                   std::strerror(reason) + "), so " + target.string() +
                   " can't be locked and written; " +
                   (there ? "if no other program is writing to it, delete this lock file, or have "
                            "its owner delete it"
                          : "check the permissions of the folder"));
}

/// True if the open file still has that name. The file is opened again, because network file
/// systems answer this from the server, but names from a cache.
bool is_still(const fs::path& file, int descriptor) {
  const int now = opened(file, O_RDONLY);
  if (now < 0) return false;
  struct stat mine {
  }, named{};
  const bool same = ::fstat(descriptor, &mine) == 0 && ::fstat(now, &named) == 0 &&
                    mine.st_dev == named.st_dev && mine.st_ino == named.st_ino;
  ::close(now);
  return same;
}

}  // namespace

fs::path FileLock::lock_path(const fs::path& target) {
  const fs::path linked = resolve_link(target);
  return linked.parent_path() / ("." + linked.filename().string() + ".lock");
}

FileLock::FileLock(const fs::path& target, NotLocked) : file_(lock_path(target)) {
  std::error_code code;
  if (file_.has_parent_path()) fs::create_directories(file_.parent_path(), code);
}

bool FileLock::try_lock(const fs::path& target) {
  const int descriptor = opened_or_made(file_);
  if (descriptor < 0) refuse_lock(file_, target, errno);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
    if (is_still(file_, descriptor)) {
      descriptor_ = descriptor;
      return true;
    }
  } else if (errno != EWOULDBLOCK && errno != EINTR) {
    const std::string reason = std::strerror(errno);
    ::close(descriptor);
    throw InputError(file_.string() + ": can't be locked (" + reason + "), so " + target.string() +
                     " is not written; if no other program is writing to it, delete "
                     "this lock file, or else name a target on another disk");
  }
  ::close(descriptor);
  return false;
}

std::unique_ptr<FileLock> FileLock::try_acquire(const fs::path& target) {
  std::unique_ptr<FileLock> lock(new FileLock(target, NotLocked{}));
  return lock->try_lock(target) ? std::move(lock) : nullptr;
}

FileLock::FileLock(const fs::path& target, const FileLockOptions& options)
    : FileLock(target, NotLocked{}) {
  const auto begin = std::chrono::steady_clock::now();
  bool said = false;
  while (!try_lock(target)) {
    if (std::chrono::steady_clock::now() - begin > options.timeout) {
      const auto waited = std::chrono::duration_cast<std::chrono::seconds>(options.timeout);
      throw InputError(target.string() + ": another program " +
                       (waited.count() > 0
                            ? "has been writing to it for " + std::to_string(waited.count()) + " s"
                            : "is writing to it") +
                       "; wait until it ends, or end it, and try again");
    }
    if (!said && options.on_wait) options.on_wait();
    said = true;
    std::this_thread::sleep_for(kBetweenTries);
  }
}

FileLock::~FileLock() {
  if (descriptor_ < 0) return;
  std::error_code ignored;
  fs::remove(file_, ignored);
  ::close(descriptor_);
}

}  // namespace clast
