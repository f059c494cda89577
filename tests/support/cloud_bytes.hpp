#pragma once
/// Cloud files as bytes: LAS and PCD.
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast {

template <class T>
void put(std::string& bytes, std::size_t offset, T value) {
  if (bytes.size() < offset + sizeof(T)) bytes.resize(offset + sizeof(T), '\0');
  std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

struct LasPoint {
  std::array<std::int32_t, 3> steps;
  std::uint8_t asprs_class = 2;
  bool withheld = false;
};

/// A LAS file as the ASPRS specification lays it out, with one GeoTIFF key: EPSG 25832.
inline std::string las_file(int minor, std::uint8_t format, std::size_t record_size,
                            const std::vector<LasPoint>& points, const Vec3& scale,
                            const Vec3& offset) {
  const std::uint16_t header_size = minor >= 4 ? 375 : minor == 3 ? 235 : 227;
  std::string bytes(header_size, '\0');
  bytes.replace(0, 4, "LASF");
  put<std::uint8_t>(bytes, 24, 1);
  put<std::uint8_t>(bytes, 25, static_cast<std::uint8_t>(minor));
  put<std::uint16_t>(bytes, 94, header_size);
  const std::size_t keys = 54 + 16;
  put<std::uint32_t>(bytes, 96, static_cast<std::uint32_t>(header_size + keys));
  put<std::uint32_t>(bytes, 100, 1);
  put<std::uint8_t>(bytes, 104, format);
  put<std::uint16_t>(bytes, 105, static_cast<std::uint16_t>(record_size));
  const auto count = static_cast<std::uint32_t>(points.size());
  put<std::uint32_t>(bytes, 107, minor >= 4 ? 0 : count);
  for (std::size_t k = 0; k < 3; ++k) {
    put<double>(bytes, 131 + 8 * k, scale[static_cast<Eigen::Index>(k)]);
    put<double>(bytes, 155 + 8 * k, offset[static_cast<Eigen::Index>(k)]);
  }
  if (minor >= 4) put<std::uint64_t>(bytes, 247, count);
  std::string record(keys, '\0');
  record.replace(2, 15, "LASF_Projection");
  put<std::uint16_t>(record, 18, 34735);
  put<std::uint16_t>(record, 20, 16);
  const std::array<std::uint16_t, 8> directory = {1, 1, 0, 1, 3072, 0, 1, 25832};
  std::memcpy(record.data() + 54, directory.data(), sizeof directory);
  bytes += record;
  for (const LasPoint& point : points) {
    std::string one(record_size, '\0');
    for (std::size_t k = 0; k < 3; ++k) put<std::int32_t>(one, 4 * k, point.steps[k]);
    if (format < 6) {
      put<std::uint8_t>(one, 15,
                        static_cast<std::uint8_t>(point.asprs_class | (point.withheld ? 0x80 : 0)));
    } else {
      put<std::uint8_t>(one, 15, point.withheld ? 0x04 : 0);
      put<std::uint8_t>(one, 16, point.asprs_class);
    }
    bytes += one;
  }
  return bytes;
}

inline const std::string kPcdHeader =
    "# .PCD v.7\nVERSION .7\nFIELDS x y z rgb\nSIZE 4 4 8 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
    "WIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\n";

/// Three points, the last without a place, point by point or field by field.
inline std::string pcd_points(bool by_field) {
  std::string bytes;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::array<float, 3> x = {1, 4, nan}, y = {2, 5, nan};
  const std::array<double, 3> z = {3.1, 6, 0};
  const auto add = [&](auto value) { put(bytes, bytes.size(), value); };
  if (by_field) {
    for (const float v : x) add(v);
    for (const float v : y) add(v);
    for (const double v : z) add(v);
    for (int i = 0; i < 3; ++i) add(std::uint32_t{7});
  } else {
    for (std::size_t i = 0; i < 3; ++i) {
      add(x[i]);
      add(y[i]);
      add(z[i]);
      add(std::uint32_t{7});
    }
  }
  return bytes;
}

/// Compressed: literal runs for the first 56 bytes, then a copy of four bytes from four back.
inline std::string packed_pcd() {
  const std::string plain = pcd_points(true);
  std::string packed;
  packed += static_cast<char>(31);
  packed += plain.substr(0, 32);
  packed += static_cast<char>(23);
  packed += plain.substr(32, 24);
  packed += static_cast<char>(2 << 5);  // length 4, the bytes that end four back
  packed += static_cast<char>(3);
  std::string file = kPcdHeader + "DATA binary_compressed\n";
  put(file, file.size(), static_cast<std::uint32_t>(packed.size()));
  put(file, file.size(), static_cast<std::uint32_t>(plain.size()));
  return file + packed;
}

}  // namespace clast
