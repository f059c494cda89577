#pragma once
/// File locks for processes that read, modify and write a file.
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

namespace clast {

struct FileLockOptions {
  std::chrono::milliseconds timeout = std::chrono::minutes(5);
  /// Called once if another process holds the lock.
  std::function<void()> on_wait = {};
};

/// Holds the lock on `target` for its lifetime: an exclusive flock(2) on ".NAME.lock" beside it,
/// because the target itself is replaced by renames. The kernel releases the lock when a process
/// ends.
///
/// The holder removes the lock file; one that remains after a kill is harmless. A process that had
/// opened a removed lock file detects this and locks the new one. Lock files of other users are
/// opened read-only, which suffices. Network file systems work as far as flock does (NFS on Linux:
/// between machines, too). Links are resolved, so that all names of a file share one lock. Threads
/// exclude each other like processes.
class FileLock {
 public:
  /// Acquires the lock; creates missing parent folders.
  /// @throws InputError  if the lock is not obtained within `timeout`, or the lock file cannot be
  ///                     created or read
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
