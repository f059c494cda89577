// TIFF 6.0, section 2, and BigTIFF.
#include "terrain/gdal/detail/tiff_keys.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>

namespace clast::terrain_detail {
namespace {

/// Whole numbers of a file in its byte order.
class TiffFile {
 public:
  explicit TiffFile(const std::filesystem::path& path) : stream_(path, std::ios::binary) {
    const std::string head = bytes(0, 4);
    big_endian_ = head.starts_with("MM");
    const int version = head.size() < 4 ? 0 : static_cast<unsigned char>(head[big_endian_ ? 3 : 2]);
    is_tiff_ = (big_endian_ || head.starts_with("II")) && (version == 42 || version == 43);
    is_big_ = version == 43;
  }
  bool is_tiff() const { return is_tiff_; }
  bool is_big() const { return is_big_; }

  std::string bytes(std::uint64_t at, std::uint64_t count) {
    std::string read(count, '\0');
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(at));
    stream_.read(read.data(), static_cast<std::streamsize>(count));
    read.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream_.gcount(), 0)));
    return read;
  }
  /// 0 behind the end of the file.
  std::uint64_t number(std::uint64_t at, std::size_t size) {
    const std::string read = little_endian(bytes(at, size), size);
    std::uint64_t value = 0;
    for (std::size_t i = read.size(); i > 0; --i) {
      value = value << 8 | static_cast<unsigned char>(read[i - 1]);
    }
    return value;
  }
  /// `read` with each run of `size` bytes in little-endian order.
  std::string little_endian(std::string read, std::size_t size) const {
    if (!big_endian_) return read;
    for (std::size_t at = 0; at + size <= read.size(); at += size) {
      std::reverse(read.begin() + static_cast<std::ptrdiff_t>(at),
                   read.begin() + static_cast<std::ptrdiff_t>(at + size));
    }
    return read;
  }

 private:
  std::ifstream stream_;
  bool is_tiff_ = false, is_big_ = false, big_endian_ = false;
};

/// The bytes of an entry of a directory, whose elements have `size` bytes.
/// @param at  of the entry
std::string entry_bytes(TiffFile& file, std::uint64_t at, std::size_t size) {
  constexpr std::uint64_t kMost = 1 << 20;  // keys take kilobytes
  const std::size_t word = file.is_big() ? 8 : 4;
  const std::uint64_t count = file.number(at + 4, word);
  if (count > kMost / size) return {};
  const std::uint64_t place = at + 4 + word;
  const bool inside = count * size <= word;
  return file.little_endian(file.bytes(inside ? place : file.number(place, word), count * size),
                            size);
}

}  // namespace

GeoTiffKeys read_geotiff_keys(const std::filesystem::path& path) {
  GeoTiffKeys keys;
  TiffFile file(path);
  if (!file.is_tiff()) return keys;
  const bool big = file.is_big();
  const std::uint64_t directory = file.number(big ? 8 : 4, big ? 8 : 4);
  const std::uint64_t entries = file.number(directory, big ? 8 : 2);
  constexpr std::uint64_t kMaxEntries = 65535;
  for (std::uint64_t i = 0; i < std::min(entries, kMaxEntries); ++i) {
    const std::uint64_t at = directory + (big ? 8 + 20 * i : 2 + 12 * i);
    const std::uint64_t tag = file.number(at, 2);
    if (tag == 34735) keys.directory = entry_bytes(file, at, 2);
    if (tag == 34736) keys.doubles = entry_bytes(file, at, 8);
    if (tag == 34737) keys.texts = entry_bytes(file, at, 1);
    if (tag > 34737 || tag == 0) break;  // they are in ascending order
  }
  return keys;
}

}  // namespace clast::terrain_detail
