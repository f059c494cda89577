#pragma once
/// Changing a library file that others may be changing too.
#include <filesystem>
#include <functional>

#include "library/block_library.hpp"

namespace clast {

struct LibraryUpdateOptions {
  /// Begins with an empty library where there is none.
  bool create_if_missing = false;
  /// Called once when another process is writing to the library.
  std::function<void()> on_wait = {};
};

/// Locks the library (core/files/file_lock.hpp), reads it, lets `change` change it, writes it whole
/// and releases the lock. `change` receives what others wrote meanwhile, so none of it is lost.
/// @return what was written
/// @throws InputError  as `BlockLibrary::read`, `BlockLibrary::write` and `FileLock`, and whatever
///                     `change` throws: the file is then as it was
BlockLibrary update_library(const std::filesystem::path& path, const LibraryUpdateOptions& options,
                            const std::function<void(BlockLibrary&)>& change);

/// Checks that `update_library` could write there, before the work whose result it will store.
/// @throws InputError  it could not, or what is there is no library
void check_library_target(const std::filesystem::path& path);

}  // namespace clast
