#pragma once
/// Atomic output files that never replace files of another kind.
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include "core/files/staging_path.hpp"

namespace clast {

/// Rules for replacing an existing file.
struct OverwritePolicy {
  /// Kind of the output (`detect_file_kind`). An existing file of another kind is never replaced.
  /// An empty `kind` stands for any kind, for files that only clast uses. An existing empty file
  /// counts as of every kind.
  std::string kind = {};
  /// If true, an existing file of this kind is replaced. If false, no existing file is.
  bool replace = true;
};

/// Output file that is written beside its target. `commit` renames it to the target and keeps the
/// permissions of a replaced file. Without `commit`, the temporary file is removed and the target
/// does not change. Links are resolved.
class OutputFile {
 public:
  /// Creates missing parent folders and the temporary file.
  /// @throws InputError  if the target path is empty, a folder, a device, or a dangling or circular
  ///                     link, if the target is write-protected or `rules` do not allow to replace
  ///                     it, or if its folder cannot be created or written
  explicit OutputFile(std::filesystem::path target, const OverwritePolicy& rules = {});
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Returns the path of the temporary file. It has the extension of the target.
  const std::filesystem::path& temporary_path() const { return staging_->path(); }
  const std::filesystem::path& target_path() const { return target_; }
  /// Writes the whole content to `temporary_path`.
  /// @throws InputError  if the disk is full or the file is too large
  void write(std::string_view content);
  /// Checks the overwrite policy again and renames the temporary file to the target. Both are one
  /// atomic step if `replace` is false.
  /// @throws InputError  if the rename failed, or if another program has meanwhile written a file
  ///                     that must be kept
  void commit();

 private:
  std::filesystem::path target_;
  std::unique_ptr<StagingPath> staging_;
  OverwritePolicy rules_;
  bool absent_ = false;  ///< true if the target did not exist at the start
  bool committed_ = false;
};

/// Writes a whole file through an `OutputFile`.
/// @throws InputError  as the members of `OutputFile`
void write_output(const std::filesystem::path& target, std::string_view content,
                  const OverwritePolicy& rules);

/// Checks before a computation that the target can be written. Creates missing parent folders.
/// @throws InputError  as `OutputFile`
void check_output_target(const std::filesystem::path& target, const OverwritePolicy& rules);

/// Returns true if two paths name one file, which need not exist.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Checks that files of the given sizes (bytes) fit on the disk of the target, and that none
/// exceeds the file size limit of the process.
/// @throws InputError  if they do not; the message gives the needed and available sizes
void check_disk_space(const std::filesystem::path& target,
                      std::initializer_list<std::uint64_t> files);

/// Returns the path to which a symbolic link leads, which need not exist; other paths unchanged.
/// @throws InputError  if the link is circular
std::filesystem::path resolve_link(const std::filesystem::path& target);

/// Renames a file or folder, or returns `file_exists` if the new name exists. This is atomic if the
/// file system supports it.
std::error_code rename_without_replacing(const std::filesystem::path& from,
                                         const std::filesystem::path& to);

/// Throws the InputError for a target that another program wrote between check and rename.
[[noreturn]] void throw_concurrent_write(const std::filesystem::path& target);

}  // namespace clast
