#pragma once
/// Temporary paths beside an output target.
#include <filesystem>
#include <memory>

#include "core/files/file_lock.hpp"

namespace clast {

/// Temporary file ".STEM.partPID.EXTENSION" or folder ".NAME.partPID" beside a target. Its name is
/// unique even between containers with equal process ids. A `FileLock` marks it as in use if
/// possible.
class StagingPath {
 public:
  enum class Kind { kFile, kFolder };

  /// Creates an empty file or folder, after `remove_stale_staging`.
  /// @param target  output path, in an existing folder
  /// @throws InputError  if it cannot be created
  StagingPath(const std::filesystem::path& target, Kind kind);

  const std::filesystem::path& path() const { return path_; }
  /// Releases the lock. Call it once the path no longer exists.
  void unlock() { lock_.reset(); }
  /// Returns the path to which files of the target are moved during the exchange:
  /// ".NAME.partPID.former".
  std::filesystem::path backup_path() const;

 private:
  std::unique_ptr<FileLock> lock_;
  std::filesystem::path path_;
};

/// Removes temporary paths of a target without a lock, which killed programs have left. A backup
/// folder whose target is missing becomes the target again.
void remove_stale_staging(const std::filesystem::path& target, StagingPath::Kind kind);

}  // namespace clast
