#pragma once
/// Updates of a block library file that other processes may change at the same time.
#include <filesystem>
#include <functional>

#include "library/block_library.hpp"

namespace clast {

struct LibraryUpdateOptions {
  /// If true, an empty library is created if there is none.
  bool create_if_missing = false;
  /// Function that is called once before waiting for another process that writes to the library.
  std::function<void()> on_wait = {};
};

/// Applies `change` to a library file. The file is locked while it is read, changed and written
/// (core/files/file_lock.hpp), so that no concurrent change is lost.
/// @return the written library
/// @throws InputError  if the library cannot be locked, read or written. Exceptions of `change` are
///                     propagated. In both cases, the file is unchanged
BlockLibrary update_library(const std::filesystem::path& path, const LibraryUpdateOptions& options,
                            const std::function<void(BlockLibrary&)>& change);

/// Checks that `update_library` can write the file. Call it before a long computation.
/// @throws InputError  if it cannot, or if the existing file is not a library
void check_library_writable(const std::filesystem::path& path);

}  // namespace clast
