#include "core/files/png.hpp"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <new>

namespace clast {
namespace {

/// @param palette  RGBA, null where the pixels are colours
std::string png_file(png_image& image, const void* pixels, const void* palette) {
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string png(size, '\0');
  if (png_image_write_to_memory(&image, png.data(), &size, 0, pixels, 0, palette) == 0) {
    throw std::bad_alloc();  // the only way it fails with room for the worst case
  }
  png.resize(size);
  return png;
}

png_image image_of(std::uint32_t width, std::uint32_t height, png_uint_32 format) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = format;
  return image;
}

}  // namespace

std::string compress_zlib(std::string_view bytes, int level) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string stream(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(stream.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()),
                level) != Z_OK) {
    throw std::bad_alloc();  // the only way it fails with room for the worst case
  }
  stream.resize(size);
  return stream;
}

std::string encode_palette_png(std::uint32_t width, std::uint32_t height,
                               std::span<const std::uint8_t> pixels,
                               const std::vector<Rgb>& palette) {
  assert(pixels.size() == std::size_t{width} * height);
  assert(!palette.empty() && palette.size() <= 256);
  std::vector<std::array<std::uint8_t, 4>> colours;
  for (const Rgb& colour : palette) {
    const std::uint8_t opacity = colours.empty() ? 0 : 255;
    colours.push_back({colour[0], colour[1], colour[2], opacity});
  }
  png_image image = image_of(width, height, PNG_FORMAT_RGBA_COLORMAP);
  image.colormap_entries = static_cast<png_uint_32>(colours.size());
  return png_file(image, pixels.data(), colours.data());
}

std::string encode_rgb_png(std::uint32_t width, std::uint32_t height, std::span<const Rgb> pixels) {
  assert(pixels.size() == std::size_t{width} * height);
  png_image image = image_of(width, height, PNG_FORMAT_RGB);
  return png_file(image, pixels.data(), nullptr);
}

std::string png_data_uri(std::string_view png) {
  return "data:image/png;base64," + encode_base64(png);
}

std::string encode_base64(std::string_view bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) {
      group = (group << 8) | (k < here ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= here ? kDigits[(group >> (18 - 6 * k)) & 63u] : '=';
    }
  }
  return text;
}

}  // namespace clast
