#pragma once
/// Concurrent updates of a library file.
#include <filesystem>
#include <functional>

#include "library/block_library.hpp"

namespace clast {

struct LibraryUpdateOptions {
  /// Create an empty library if there is none.
  bool create_if_missing = false;
  /// Called once if another process is writing to the library.
  std::function<void()> on_wait = {};
};

/// Locks the library (core/files/file_lock.hpp), reads it, applies `change`, writes it and releases
/// the lock, so that no concurrent change is lost.
/// @return the written library
/// @throws InputError  as `BlockLibrary::read`, `BlockLibrary::write` and `FileLock`, and
///                     exceptions of `change`; the file is then unchanged
BlockLibrary update_library(const std::filesystem::path& path, const LibraryUpdateOptions& options,
                            const std::function<void(BlockLibrary&)>& change);

/// Checks before a computation that `update_library` can write the file.
/// @throws InputError  if it cannot, or the existing file is not a library
void check_library_target(const std::filesystem::path& path);

}  // namespace clast
