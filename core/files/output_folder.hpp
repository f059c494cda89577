#pragma once
/// Atomic output folders, such as reports.
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/files/staging_path.hpp"

namespace clast {

/// Kind of an output folder. A folder is of this kind if its marker file contains `marker_text`.
struct OutputFolderKind {
  std::string name;              ///< for messages: "comparison"
  std::string marker_file_name;  ///< name of the marker file: "provenance.json"
  std::string marker_text;       ///< text in the marker file
  /// Returns true for files that clast writes to such a folder, given paths relative to it. Other
  /// files are never changed.
  std::function<bool(const std::filesystem::path&)> is_own_file;
};

/// Output folder that is filled beside its target. `commit` exchanges it with the target. Without
/// `commit`, it is removed and the target does not change. Links are resolved.
class OutputFolder {
 public:
  /// Creates missing parent folders and the temporary folder.
  /// @param replace  true if an existing folder of this kind may be replaced
  /// @throws InputError  if the target path is empty, a file or the root of a disk; if the target
  ///                     is of this kind and `replace` is false; if it is not of this kind but has
  ///                     files with names of this kind; or if nothing can be created beside it
  OutputFolder(const std::filesystem::path& target, OutputFolderKind kind, bool replace);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& temporary_path() const { return staging_->path(); }
  /// Replaces the output files in the target. Other files in it are kept.
  /// @throws InputError  if another file would be overwritten, if a rename failed, or if another
  ///                     program has meanwhile written a file that must be kept; the target does
  ///                     not change then
  void commit();

 private:
  std::filesystem::path target_;
  std::unique_ptr<StagingPath> staging_;
  OutputFolderKind kind_;
  bool replace_;
  bool committed_ = false;
};

}  // namespace clast
