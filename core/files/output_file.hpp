#pragma once
/// Output files that appear whole or not at all, and never replace something else.
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include "core/files/staging_path.hpp"

namespace clast {

/// What an output may replace.
struct OverwritePolicy {
  /// As `detect_file_kind` has it: a target of any other kind is refused. Empty: any kind will do,
  /// for files that only clast uses. An empty file, as a shell or a queue makes beforehand, is of
  /// every kind.
  std::string kind = {};
  /// Takes the place of a file of its own kind. False: nothing that is there is written over.
  bool replace = true;
};

/// A file that is written beside its target and renamed over it by `commit`, with the permissions
/// of the file it replaces. Without `commit` the temporary file is removed and the target stays as
/// it was. Links are followed.
class OutputFile {
 public:
  /// Makes missing parent folders.
  /// @throws InputError  the target is empty, a folder, a device, write-protected, a link that
  ///                     leads nowhere or in a circle, or something that the rules keep; or its
  ///                     folder can't be made or written to
  explicit OutputFile(std::filesystem::path target, const OverwritePolicy& rules = {});
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where to write. Same extension as the target, so that writers that go by it still work.
  const std::filesystem::path& temporary_path() const { return staging_->path(); }
  const std::filesystem::path& target_path() const { return target_; }
  /// Writes the whole content to `temporary_path`.
  /// @throws InputError  the disk is full, or the file too large
  void write(std::string_view content);
  /// Applies the rules again and renames. If nothing may be replaced, both are one atomic step.
  /// @throws InputError  the rename failed; or another program wrote meanwhile what the rules keep
  void commit();

 private:
  std::filesystem::path target_;
  std::unique_ptr<StagingPath> staging_;
  OverwritePolicy rules_;
  bool absent_ = false;  ///< nothing was there at the start
  bool committed_ = false;
};

/// Writes a whole file through an `OutputFile`.
/// @throws InputError  as its members
void write_output(const std::filesystem::path& target, std::string_view content,
                  const OverwritePolicy& rules);

/// Checks that the target could be written, before the work starts. Missing parent folders are
/// made.
/// @throws InputError  as `OutputFile`
void check_output_target(const std::filesystem::path& target, const OverwritePolicy& rules);

/// Checks that files of so many bytes fit beside the target: together by the free space of the
/// disk, each by the largest file that the shell allows.
/// @throws InputError  they could not; gives what is needed and what there is
void check_disk_space(const std::filesystem::path& target,
                      std::initializer_list<std::uint64_t> files);

/// The file that a link leads to, there or not, and any other path as it is.
/// @throws InputError  a link that leads in a circle
std::filesystem::path resolve_link(const std::filesystem::path& target);

/// Renames a file or a folder unless something has the new name (`file_exists`): in one step where
/// the file system has one.
std::error_code rename_without_replacing(const std::filesystem::path& from,
                                         const std::filesystem::path& to);

/// Refuses a target that another program wrote between the check and the rename.
[[noreturn]] void throw_concurrent_write(const std::filesystem::path& target);

}  // namespace clast
