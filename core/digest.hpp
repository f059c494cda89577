#pragma once
/// SHA-256 digests: how outputs name the inputs they were made from.
#include <filesystem>
#include <string>
#include <string_view>

namespace clast {

/// SHA-256 of `bytes`, 64 lower-case hexadecimal digits (FIPS 180-4).
/// @cite fips180
std::string sha256(std::string_view bytes);

/// SHA-256 of a file's content.
/// @throws InputError  the file can't be read; names it
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace clast
