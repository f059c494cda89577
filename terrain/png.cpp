#include "terrain/png.hpp"

#include <algorithm>
#include <cassert>

namespace clast {
namespace {

void append_u32(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((value >> shift) & 0xFF);
}

/// CRC-32 of PNG chunks (polynomial 0xEDB88320).
std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) ? 0xEDB88320u : 0u);
  }
  return crc ^ 0xFFFFFFFFu;
}

/// Checksum of zlib streams (RFC 1950).
std::uint32_t adler32(std::string_view bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521u;
    b = (b + a) % 65521u;
  }
  return (b << 16) | a;
}

/// A zlib stream of stored blocks (RFC 1950 and 1951).
std::string stored_zlib(std::string_view bytes) {
  constexpr std::size_t kLargestBlock = 65535;
  std::string stream("\x78\x01", 2);
  for (std::size_t begin = 0;;) {
    const std::size_t size = std::min(kLargestBlock, bytes.size() - begin);
    const bool last = begin + size == bytes.size();
    const auto low = static_cast<char>(size & 0xFF), high = static_cast<char>(size >> 8);
    stream += last ? '\x01' : '\x00';
    stream += low;
    stream += high;
    stream += static_cast<char>(~low);
    stream += static_cast<char>(~high);
    stream += bytes.substr(begin, size);
    begin += size;
    if (last) break;
  }
  append_u32(stream, adler32(bytes));
  return stream;
}

void append_chunk(std::string& png, std::string_view type, std::string_view data) {
  append_u32(png, static_cast<std::uint32_t>(data.size()));
  const std::string body = std::string(type) + std::string(data);
  png += body;
  append_u32(png, crc32(body));
}

}  // namespace

std::string palette_png(std::uint32_t width, std::uint32_t height,
                        std::span<const std::uint8_t> pixels, const std::vector<Rgb>& palette) {
  assert(pixels.size() == std::size_t{width} * height);
  assert(!palette.empty() && palette.size() <= 256);
  std::string png("\x89PNG\r\n\x1a\n", 8);

  std::string header;
  append_u32(header, width);
  append_u32(header, height);
  header += std::string("\x08\x03\x00\x00\x00", 5);  // 8 bits, palette, no interlacing
  append_chunk(png, "IHDR", header);

  std::string colours;
  for (const Rgb& colour : palette) {
    for (const std::uint8_t part : colour) colours += static_cast<char>(part);
  }
  append_chunk(png, "PLTE", colours);
  append_chunk(png, "tRNS", std::string(1, '\0'));

  std::string rows;
  rows.reserve((width + std::size_t{1}) * height);
  for (std::uint32_t row = 0; row < height; ++row) {
    rows += '\0';  // no filter
    const auto line = pixels.subspan(std::size_t{row} * width, width);
    rows.append(reinterpret_cast<const char*>(line.data()), line.size());
  }
  append_chunk(png, "IDAT", stored_zlib(rows));
  append_chunk(png, "IEND", {});
  return png;
}

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
