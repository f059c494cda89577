#include "core/png.hpp"

#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <new>
#include <utility>

namespace clast {
namespace {

void append_u32(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((value >> shift) & 0xFF);
}

const Bytef* bytes_of(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

void append_chunk(std::string& png, std::string_view type, std::string_view data) {
  append_u32(png, static_cast<std::uint32_t>(data.size()));
  const std::string body = std::string(type) + std::string(data);
  png += body;
  append_u32(png,
             static_cast<std::uint32_t>(crc32(0, bytes_of(body), static_cast<uInt>(body.size()))));
}

enum class ColourType : char { kRgb = 2, kPalette = 3 };

/// Signature and first chunk, 8 bits a sample, no interlacing.
std::string begun(std::uint32_t width, std::uint32_t height, ColourType type) {
  std::string png("\x89PNG\r\n\x1a\n", 8);
  std::string header;
  append_u32(header, width);
  append_u32(header, height);
  header += '\x08';
  header += static_cast<char>(type);
  header += std::string(3, '\0');
  append_chunk(png, "IHDR", header);
  return png;
}

std::string ended(std::string png, std::string_view rows) {
  append_chunk(png, "IDAT", deflated(rows));
  append_chunk(png, "IEND", {});
  return png;
}

}  // namespace

std::string deflated(std::string_view bytes, int level) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string stream(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(stream.data()), &size, bytes_of(bytes),
                static_cast<uLong>(bytes.size()), level) != Z_OK) {
    throw std::bad_alloc();  // the only way it fails with room for the worst case
  }
  stream.resize(size);
  return stream;
}

std::string palette_png(std::uint32_t width, std::uint32_t height,
                        std::span<const std::uint8_t> pixels, const std::vector<Rgb>& palette) {
  assert(pixels.size() == std::size_t{width} * height);
  assert(!palette.empty() && palette.size() <= 256);
  std::string png = begun(width, height, ColourType::kPalette);
  std::string colours;
  for (const Rgb& colour : palette) {
    for (const std::uint8_t part : colour) colours += static_cast<char>(part);
  }
  append_chunk(png, "PLTE", colours);
  append_chunk(png, "tRNS", std::string(1, '\0'));

  std::string rows;
  rows.reserve((width + std::size_t{1}) * height);
  for (std::uint32_t row = 0; row < height; ++row) {
    rows += '\0';  // no filter: neighbouring indices are no neighbouring colours
    const auto line = pixels.subspan(std::size_t{row} * width, width);
    rows.append(reinterpret_cast<const char*>(line.data()), line.size());
  }
  return ended(std::move(png), rows);
}

std::string rgb_png(std::uint32_t width, std::uint32_t height, std::span<const Rgb> pixels) {
  assert(pixels.size() == std::size_t{width} * height);
  constexpr std::size_t kChannels = 3;
  const std::size_t length = kChannels * width;
  std::string rows, above(length, '\0'), line(length, '\0');
  rows.reserve((length + 1) * height);
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::size_t i = 0; i < length; ++i) {
      line[i] = static_cast<char>(pixels[std::size_t{row} * width + i / kChannels][i % kChannels]);
    }
    // Differences from the left or from above, whichever are smaller: smooth shades become zeros.
    std::string left_filtered(1, '\x01'), up_filtered(1, '\x02');
    long left_sum = 0, up_sum = 0;
    for (std::size_t i = 0; i < length; ++i) {
      const char left = i < kChannels ? '\0' : line[i - kChannels];
      const auto by_left = static_cast<signed char>(line[i] - left);
      const auto by_up = static_cast<signed char>(line[i] - above[i]);
      left_sum += std::abs(by_left);
      up_sum += std::abs(by_up);
      left_filtered += static_cast<char>(by_left);
      up_filtered += static_cast<char>(by_up);
    }
    rows += left_sum < up_sum ? left_filtered : up_filtered;
    above = line;
  }
  return ended(begun(width, height, ColourType::kRgb), rows);
}

std::string png_link(std::string_view png) { return "data:image/png;base64," + base64(png); }

std::string base64(std::string_view bytes) {
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
