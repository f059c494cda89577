#pragma once
/// SHA-256 digests: how outputs name the inputs they were made from.
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace clast {

/// SHA-256 of bytes that come piece by piece (FIPS 180-4).
/// @cite fips180
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void add(std::string_view bytes);
  /// Ends it: nothing may be added afterwards.
  /// @returns 64 lower-case hexadecimal digits
  std::string finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Of all `bytes` at once.
std::string sha256(std::string_view bytes);

/// Of a file's content, of which no more than a piece is in memory at a time.
/// @throws InputError  the file can't be read; names it
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace clast
