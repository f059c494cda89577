#pragma once
/// Output files that appear whole or not at all.
#include <filesystem>

namespace clast {

/// A file that is written beside its target and renamed over it by `commit`, with the permissions
/// of the file it replaces. Without `commit` the temporary file is removed and the target stays as
/// it was. Links are followed.
class OutputFile {
 public:
  /// Makes missing parent folders.
  /// @throws InputError  the target is empty, a folder, a device, write-protected or a broken link,
  /// or
  ///                     its folder can't be made or written to
  explicit OutputFile(std::filesystem::path target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where to write. Same extension as the target, so that writers that go by it still work.
  const std::filesystem::path& temporary() const { return temporary_; }
  const std::filesystem::path& target() const { return target_; }
  /// @throws InputError  the rename failed
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

}  // namespace clast
