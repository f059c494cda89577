#pragma once
/// Mutual exclusion of processes that read, change and write back a file.
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

namespace clast {

struct FileLockOptions {
  std::chrono::milliseconds timeout = std::chrono::minutes(5);
  /// Called once, when another process has the lock.
  std::function<void()> on_wait = {};
};

/// Holds the lock on `target` for its lifetime: an exclusive flock(2) on ".NAME.lock" beside it.
/// The target itself can't carry it, since it is replaced by a rename. The kernel releases the lock
/// when a process ends, however it ends.
///
/// The lock file is removed by the holder of the lock, so that one is left only by a kill, and then
/// does no harm. A process that had it open meanwhile finds that the file with that name is another
/// one, and asks for the lock on that one. One left by another user is opened for reading only,
/// which is enough. On network file systems this holds as far as flock does
/// (NFS on Linux: between machines too). Links are followed, so that a library has one lock by
/// whatever name. Threads of one process lock each other out as processes do.
class FileLock {
 public:
  /// Makes missing parent folders.
  /// @throws InputError  not obtained within `timeout`; or the lock file can't be made, where
  ///                     the target could not be written either; or one is left that may not be
  ///                     read
  explicit FileLock(const std::filesystem::path& target, const FileLockOptions& options = {});
  /// The lock without waiting for it; none if another process or thread holds it.
  /// @throws InputError  as the constructor, but for the wait
  static std::unique_ptr<FileLock> try_acquire(const std::filesystem::path& target);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Where the lock of a file is.
  static std::filesystem::path lock_path(const std::filesystem::path& target);

 private:
  struct NotLocked {};
  FileLock(const std::filesystem::path& target, NotLocked);
  /// Opens and locks the lock file.
  /// @return  false if another process or thread holds it
  bool try_lock(const std::filesystem::path& target);

  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace clast
