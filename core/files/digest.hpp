#pragma once
/// SHA-256 digests. Outputs identify their inputs by them.
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace clast {

/// Incremental computation of a SHA-256 digest (FIPS 180-4).
/// @cite fips180
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void add(std::string_view bytes);
  /// Finishes the digest. No bytes may be added afterwards.
  /// @returns 64 lower-case hexadecimal digits
  std::string finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

std::string sha256(std::string_view bytes);

/// Returns the SHA-256 of a file. The file is read in chunks.
/// @throws InputError  if the file cannot be read
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace clast
