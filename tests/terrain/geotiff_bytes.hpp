#pragma once
/// GeoTIFF files whose keys say what a test wants them to say.
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace clast {

/// A key of a GeoTIFF directory with its value.
struct TiffKey {
  std::uint16_t key;
  std::uint16_t value;
};

/// Heights as 32-bit floats, north row first, in cells of one unit (TIFF 6.0, OGC GeoTIFF 1.1).
inline std::string geotiff(const std::vector<TiffKey>& keys, int columns,
                           const std::vector<float>& heights, double west, double north) {
  std::string data;  // behind the eight bytes of the head
  const auto append = [&](const void* bytes, std::size_t size) {
    const std::size_t at = 8 + data.size();
    data.append(static_cast<const char*>(bytes), size);
    if (data.size() % 2 == 1) data += '\0';
    return static_cast<std::uint32_t>(at);
  };
  const auto rows =
      static_cast<std::uint32_t>(heights.size()) / static_cast<std::uint32_t>(columns);
  const std::uint32_t strip = append(heights.data(), heights.size() * sizeof(float));
  const std::array<double, 3> scale = {1.0, 1.0, 0.0};
  const std::array<double, 6> tie = {0.0, 0.0, 0.0, west, north, 0.0};
  std::vector<std::uint16_t> directory = {1, 1, 0, static_cast<std::uint16_t>(keys.size())};
  for (const auto& [key, value] : keys) {
    for (const std::uint16_t word : {key, std::uint16_t{0}, std::uint16_t{1}, value}) {
      directory.push_back(word);
    }
  }
  struct Entry {
    std::uint16_t tag, type;  // 3 short, 4 long, 12 double
    std::uint32_t count, value;
  };
  const std::vector<Entry> entries = {
      {256, 4, 1, static_cast<std::uint32_t>(columns)},
      {257, 4, 1, rows},
      {258, 3, 1, 32},
      {259, 3, 1, 1},
      {262, 3, 1, 1},
      {273, 4, 1, strip},
      {277, 3, 1, 1},
      {278, 4, 1, rows},
      {279, 4, 1, static_cast<std::uint32_t>(heights.size() * sizeof(float))},
      {339, 3, 1, 3},
      {33550, 12, 3, append(scale.data(), sizeof scale)},
      {33922, 12, 6, append(tie.data(), sizeof tie)},
      {34735, 3, static_cast<std::uint32_t>(directory.size()),
       append(directory.data(), directory.size() * 2)}};
  std::string file = "II*";
  file += '\0';
  const auto number = [](auto value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
  };
  file += number(static_cast<std::uint32_t>(8 + data.size())) + data;
  file += number(static_cast<std::uint16_t>(entries.size()));
  for (const Entry& entry : entries) {
    file += number(entry.tag) + number(entry.type) + number(entry.count) + number(entry.value);
  }
  return file + number(std::uint32_t{0});
}

}  // namespace clast
