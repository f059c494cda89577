#pragma once
/// Small pictures inside an HTML page.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clast {

using Rgb = std::array<std::uint8_t, 3>;

/// A PNG file of `width` x `height` palette indices, row by row from the top. Colour 0 of the
/// palette is transparent.
/// @param palette  1 to 256 colours
/// @cite png3
std::string encode_palette_png(std::uint32_t width, std::uint32_t height,
                        std::span<const std::uint8_t> pixels, const std::vector<Rgb>& palette);

/// A PNG file of `width` x `height` colours, row by row from the top.
/// @cite png3
std::string encode_rgb_png(std::uint32_t width, std::uint32_t height, std::span<const Rgb> pixels);

/// A zlib stream.
/// @param level  1 fast to 9 small
/// @cite rfc1951
std::string compress_zlib(std::string_view bytes, int level = 9);

/// RFC 4648, with padding.
std::string encode_base64(std::string_view bytes);

/// "data:image/png;base64,...", as a page that holds its pictures refers to one.
std::string png_data_uri(std::string_view png);

}  // namespace clast
