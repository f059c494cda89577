#pragma once
/// File locks for processes that read, modify and write a file.
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

namespace clast {

struct FileLockOptions {
  std::chrono::milliseconds timeout = std::chrono::minutes(5);
  /// Function that is called once if another process holds the lock.
  std::function<void()> on_wait = {};
};

/// Holds a lock on `target` for its lifetime. It is an exclusive flock(2) on the file ".NAME.lock"
/// beside the target, because the target itself is replaced by renames. The kernel releases the
/// lock when a process ends.
///
/// The holder removes the lock file. A lock file that remains after a kill is harmless. Links are
/// resolved, so that all names of a file share one lock. Threads exclude each other like processes.
/// Network file systems work if they support flock, as NFS on Linux does.
class FileLock {
 public:
  /// Waits for the lock and acquires it. Creates missing parent folders.
  /// @throws InputError  if the lock is not obtained within `timeout`, or if the lock file cannot
  ///                     be created or read
  explicit FileLock(const std::filesystem::path& target, const FileLockOptions& options = {});
  /// Tries to acquire the lock without waiting; null if another process or thread holds it.
  /// @throws InputError  as the constructor, except for the timeout
  static std::unique_ptr<FileLock> try_acquire(const std::filesystem::path& target);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  static std::filesystem::path lock_path(const std::filesystem::path& target);

 private:
  struct NotLocked {};
  FileLock(const std::filesystem::path& target, NotLocked);
  /// Opens and locks the lock file.
  /// @return false if another process or thread holds the lock
  bool try_lock(const std::filesystem::path& target);

  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace clast
