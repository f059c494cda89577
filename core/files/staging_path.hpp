#pragma once
/// Temporary paths beside an output target.
#include <filesystem>
#include <memory>

#include "core/files/file_lock.hpp"

namespace clast {

/// Empty file ".STEM.partPID.EXTENSION" or folder ".NAME.partPID" beside a target, with a unique
/// name, also between containers with equal process ids. Holds a `FileLock` on it if the file
/// system has locks.
class StagingPath {
 public:
  enum class Kind { kFile, kFolder };

  /// Creates the path, after removing those left by ended programs (`remove_stale_staging`).
  /// @param target  in an existing folder
  /// @throws InputError  if it cannot be created
  StagingPath(const std::filesystem::path& target, Kind kind);

  const std::filesystem::path& path() const { return path_; }
  /// Releases the lock; call when the path no longer exists.
  void unlock() { lock_.reset(); }
  /// Returns the path for files moved out of the target meanwhile: ".NAME.partPID.former".
  std::filesystem::path backup_path() const;

 private:
  std::unique_ptr<FileLock> lock_;
  std::filesystem::path path_;
};

/// Removes unlocked temporary paths of a target, left by killed programs. A backup folder whose
/// target is missing becomes the target again.
void remove_stale_staging(const std::filesystem::path& target, StagingPath::Kind kind);

}  // namespace clast
