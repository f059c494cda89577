#pragma once
/// Folders of files that belong together, such as a report, which appear whole or not at all.
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/files/staging_path.hpp"

namespace clast {

/// How a folder of one kind is recognised.
struct FolderKind {
  std::string name;         ///< for messages: "comparison"
  std::string marker_file;  ///< that every such folder has: "provenance.json"
  std::string mark;         ///< that stands in it
  /// Whether a file of that name, relative to the folder, is the writer's. What is not stays where
  /// it is.
  std::function<bool(const std::filesystem::path&)> is_own_file;
};

/// A folder that is filled beside its target and takes its place by `commit`. Without, it is
/// removed and the target stays as it was. Links are followed.
class OutputFolder {
 public:
  /// Makes missing parent folders.
  /// @param replace  takes the place of a folder of its kind
  /// @throws InputError  the target is empty, a file, or the root of a disk; it holds files with
  ///                     names of this kind without being of it; it is of it, and `replace` is
  ///                     false; or nothing can be made beside it
  OutputFolder(const std::filesystem::path& target, FolderKind kind, bool replace);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write.
  const std::filesystem::path& temporary_path() const { return staging_->path(); }
  /// Files of the kind that were in the target are removed, others are not touched.
  /// @throws InputError  one of the others would be written over, a rename failed, or another
  ///                     program wrote meanwhile what must not be replaced. The target is as it was
  void commit();

 private:
  std::filesystem::path target_;
  std::unique_ptr<StagingPath> staging_;
  FolderKind kind_;
  bool replace_;
  bool committed_ = false;
};

}  // namespace clast
