#pragma once
/// Temporary files without a name.

namespace clast {

/// Empty file in the folder for temporary files that has no name: its space is freed when the last
/// descriptor of it is closed, also if the program is killed.
class UnnamedFile {
 public:
  /// @throws InputError  if it cannot be created
  UnnamedFile();
  ~UnnamedFile();
  UnnamedFile(const UnnamedFile&) = delete;
  UnnamedFile& operator=(const UnnamedFile&) = delete;

  /// Returns its descriptor, which is not inherited by other programs.
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = -1;
};

}  // namespace clast
