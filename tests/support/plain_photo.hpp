#pragma once
/// Small photos without a library for images.
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/files/text_file.hpp"

namespace clast {

/// Writes a grey BMP; different seeds give different files.
inline void write_plain_photo(const std::filesystem::path& path, int width, int height,
                              unsigned seed) {
  std::string bytes = "BM";
  const auto put = [&](std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  };
  const auto row = static_cast<std::uint32_t>((3 * width + 3) / 4 * 4);
  const auto size = row * static_cast<std::uint32_t>(height);
  put(54 + size, 4);
  put(0, 4);
  put(54, 4);
  put(40, 4);
  put(static_cast<std::uint32_t>(width), 4);
  put(static_cast<std::uint32_t>(height), 4);
  put(1, 2);
  put(24, 2);
  put(0, 4);
  put(size, 4);
  for (int i = 0; i < 4; ++i) put(0, 4);
  for (std::uint32_t i = 0; i < size; ++i) put((i * 37 + seed * 101) % 251, 1);
  write_text_file(path, bytes);
}

}  // namespace clast
