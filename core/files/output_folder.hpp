#pragma once
/// Atomic output folders, such as reports.
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/files/staging_path.hpp"

namespace clast {

/// Properties by which a folder of one kind is recognised.
struct FolderKind {
  std::string name;         ///< for messages: "comparison"
  std::string marker_file;  ///< file in every such folder: "provenance.json"
  std::string mark;         ///< text in that file
  /// Returns true if a file, given relative to the folder, belongs to the report. Other files are
  /// kept.
  std::function<bool(const std::filesystem::path&)> is_own_file;
};

/// Output folder that is filled beside its target and exchanged with it by `commit`. Without
/// `commit` it is removed and the target stays unchanged. Links are resolved.
class OutputFolder {
 public:
  /// Creates missing parent folders and the temporary folder.
  /// @param replace  replace an existing folder of this kind
  /// @throws InputError  if the target is empty, a file, or the root of a disk; contains files with
  ///                     names of this kind without being of it; is of it and `replace` is false;
  ///                     or if nothing can be created beside it
  OutputFolder(const std::filesystem::path& target, FolderKind kind, bool replace);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& temporary_path() const { return staging_->path(); }
  /// Replaces the files of this kind in the target; other files are kept.
  /// @throws InputError  if another file would be overwritten, a rename failed, or another program
  ///                     has meanwhile written what must be kept. The target is then unchanged
  void commit();

 private:
  std::filesystem::path target_;
  std::unique_ptr<StagingPath> staging_;
  FolderKind kind_;
  bool replace_;
  bool committed_ = false;
};

}  // namespace clast
