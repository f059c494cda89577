#pragma once
/// Places beside a target where something is made before it takes the target's place.
#include <filesystem>
#include <memory>

#include "core/files/file_lock.hpp"

namespace clast {

/// An empty file ".STEM.partPID.EXTENSION" or folder ".NAME.partPID" beside a target, under a name
/// that no other program uses, in containers with the same process numbers neither. A `FileLock` on
/// it is held as long as the object lives, where the file system has locks.
class StagingPath {
 public:
  enum class Kind { kFile, kFolder };

  /// Removes what ended programs left of the same target first (`remove_stale_staging`).
  /// @param target  its folder exists
  /// @throws InputError  it can't be made; the message says why
  StagingPath(const std::filesystem::path& target, Kind kind);

  const std::filesystem::path& path() const { return path_; }
  /// Gives up the lock, when nothing is left under the name.
  void unlock() { lock_.reset(); }
  /// Beside it, for what is taken out of the target meanwhile: ".NAME.partPID.former".
  std::filesystem::path backup_path() const;

 private:
  std::unique_ptr<FileLock> lock_;
  std::filesystem::path path_;
};

/// Removes parts of a target that no program holds locked: a kill leaves them. A former folder
/// whose target is missing was about to be exchanged and becomes the target again.
void remove_stale_staging(const std::filesystem::path& target, StagingPath::Kind kind);

}  // namespace clast
