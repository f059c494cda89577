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
  /// Kind of the output (`detect_file_kind`); an existing file of another kind is an error. Empty:
  /// any kind, for files that only clast uses. An empty file, as created by a shell or a job queue,
  /// counts as of every kind.
  std::string kind = {};
  /// True: an existing file of this kind is replaced. False: no existing file is.
  bool replace = true;
};

/// Output file that is written beside its target and renamed over it by `commit`, with the
/// permissions of the replaced file. Without `commit` the temporary file is removed and the target
/// stays unchanged. Links are resolved.
class OutputFile {
 public:
  /// Creates missing parent folders and the temporary file.
  /// @throws InputError  if the target is empty, a folder, a device, write-protected, a dangling or
  ///                     circular link, or must be kept by the rules; or if its folder cannot be
  ///                     created or written
  explicit OutputFile(std::filesystem::path target, const OverwritePolicy& rules = {});
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Returns the path to write to, with the target's extension, by which some writers choose their
  /// format.
  const std::filesystem::path& temporary_path() const { return staging_->path(); }
  const std::filesystem::path& target_path() const { return target_; }
  /// Writes the whole content to `temporary_path`.
  /// @throws InputError  if the disk is full or the file too large
  void write(std::string_view content);
  /// Applies the rules again and renames. If nothing may be replaced, both are one atomic step.
  /// @throws InputError  if the rename failed, or another program has meanwhile written a file that
  ///                     must be kept
  void commit();

 private:
  std::filesystem::path target_;
  std::unique_ptr<StagingPath> staging_;
  OverwritePolicy rules_;
  bool absent_ = false;  ///< the target did not exist at the start
  bool committed_ = false;
};

/// Writes a whole file through an `OutputFile`.
/// @throws InputError  as its members
void write_output(const std::filesystem::path& target, std::string_view content,
                  const OverwritePolicy& rules);

/// Checks before a computation that the target can be written. Creates missing parent folders.
/// @throws InputError  as `OutputFile`
void check_output_target(const std::filesystem::path& target, const OverwritePolicy& rules);

/// Checks that files of the given sizes (bytes) fit on the target's disk, and each below the file
/// size limit of the shell.
/// @throws InputError  if they do not; names the needed and available sizes
void check_disk_space(const std::filesystem::path& target,
                      std::initializer_list<std::uint64_t> files);

/// Returns the file that a link leads to, existing or not; other paths unchanged.
/// @throws InputError  if the link is circular
std::filesystem::path resolve_link(const std::filesystem::path& target);

/// Renames a file or folder, or returns `file_exists` if the new name exists; atomic if the file
/// system supports it.
std::error_code rename_without_replacing(const std::filesystem::path& from,
                                         const std::filesystem::path& to);

/// Throws the InputError for a target that another program wrote between check and rename.
[[noreturn]] void throw_concurrent_write(const std::filesystem::path& target);

}  // namespace clast
