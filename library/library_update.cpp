#include "library/library_update.hpp"

#include "core/files/file_lock.hpp"
#include "core/files/output_file.hpp"

namespace clast {

BlockLibrary update_library(const std::filesystem::path& path, const LibraryUpdateOptions& options,
                            const std::function<void(BlockLibrary&)>& change) {
  const FileLock lock(path, {.on_wait = options.on_wait});
  const bool there = !options.create_if_missing || std::filesystem::exists(path);
  BlockLibrary library = there ? BlockLibrary::read(path) : BlockLibrary();
  change(library);
  library.write(path);
  return library;
}

void check_library_writable(const std::filesystem::path& path) {
  check_output_target(path, {.kind = kLibraryFormat});
}

}  // namespace clast
