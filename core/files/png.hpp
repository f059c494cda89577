#pragma once
/// PNG images, for embedding in HTML pages.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clast {

/// Colour with the components red, green and blue.
using Rgb = std::array<std::uint8_t, 3>;

/// Encodes palette indices as PNG, row-major from the top; colour 0 of the palette is transparent.
/// @param palette  1 to 256 colours
/// @cite png3
std::string encode_palette_png(std::uint32_t width, std::uint32_t height,
                               std::span<const std::uint8_t> pixels,
                               const std::vector<Rgb>& palette);

/// Encodes an image as a PNG file. Pixels are row-major from the top.
/// @cite png3
std::string encode_rgb_png(std::uint32_t width, std::uint32_t height, std::span<const Rgb> pixels);

/// Compresses bytes to a zlib stream.
/// @param level  1 (fast) to 9 (small)
/// @cite rfc1951
std::string compress_zlib(std::string_view bytes, int level = 9);

/// Encodes bytes as base64 (RFC 4648) with padding.
std::string encode_base64(std::string_view bytes);

/// Returns the data URI of a PNG image: "data:image/png;base64,...".
std::string png_data_uri(std::string_view png);

}  // namespace clast
