#pragma once
/// LAS files whose projection records say what a test wants them to say.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/cloud_bytes.hpp"

namespace clast {

/// An entry of a GeoTIFF key directory: the value itself, a double or a text.
struct LasKey {
  std::uint16_t key = 0;
  std::uint16_t value = 0;
  double number = 0.0;    ///< not 0: stored among the doubles
  std::string text = {};  ///< not empty: stored among the texts
};

/// What a file says of its coordinates.
struct LasDeclaration {
  std::vector<LasKey> keys = {};
  std::string wkt = {};
  bool wkt_after_points = false;  ///< in an extended record of LAS 1.4
  int minor = 2;
  std::uint16_t encoding = 0;  ///< bit 4: WKT holds
};

inline std::string las_record(std::uint16_t id, const std::string& content, bool extended = false) {
  std::string record(extended ? 60 : 54, '\0');
  record.replace(2, 15, "LASF_Projection");
  put<std::uint16_t>(record, 18, id);
  if (extended) {
    put<std::uint64_t>(record, 20, content.size());
  } else {
    put<std::uint16_t>(record, 20, static_cast<std::uint16_t>(content.size()));
  }
  return record + content;
}

/// Points of format 0 with millimetre steps.
/// @param classes  of the points; empty: never classified
inline std::string declared_las(const LasDeclaration& says, const std::vector<Vec3>& points,
                                const std::vector<std::uint8_t>& classes = {}) {
  std::string directory, doubles, texts;
  const auto add = [&](std::uint16_t value) { put(directory, directory.size(), value); };
  for (const int word : {1, 1, 0}) add(static_cast<std::uint16_t>(word));
  add(static_cast<std::uint16_t>(says.keys.size()));
  for (const LasKey& key : says.keys) {
    add(key.key);
    if (!key.text.empty()) {
      add(34737);
      add(static_cast<std::uint16_t>(key.text.size()));
      add(static_cast<std::uint16_t>(texts.size()));
      texts += key.text;
    } else if (key.number != 0.0) {
      add(34736);
      add(1);
      add(static_cast<std::uint16_t>(doubles.size() / 8));
      put(doubles, doubles.size(), key.number);
    } else {
      add(0);
      add(1);
      add(key.value);
    }
  }
  std::string records;
  std::uint32_t count = 0;
  const auto append = [&](std::uint16_t id, const std::string& content) {
    if (content.empty()) return;
    records += las_record(id, content);
    ++count;
  };
  if (!says.keys.empty()) append(34735, directory);
  append(34736, doubles);
  append(34737, texts);
  if (!says.wkt_after_points && !says.wkt.empty()) append(2112, says.wkt + '\0');

  const std::uint16_t header_size = says.minor >= 4 ? 375 : 227;
  std::string bytes(header_size, '\0');
  bytes.replace(0, 4, "LASF");
  put<std::uint16_t>(bytes, 6, says.encoding);
  put<std::uint8_t>(bytes, 24, 1);
  put<std::uint8_t>(bytes, 25, static_cast<std::uint8_t>(says.minor));
  put<std::uint16_t>(bytes, 94, header_size);
  put<std::uint32_t>(bytes, 96, static_cast<std::uint32_t>(header_size + records.size()));
  put<std::uint32_t>(bytes, 100, count);
  put<std::uint16_t>(bytes, 105, 20);
  const auto number = static_cast<std::uint32_t>(points.size());
  put<std::uint32_t>(bytes, 107, says.minor >= 4 ? 0 : number);
  if (says.minor >= 4) put<std::uint64_t>(bytes, 247, number);
  constexpr double kStep = 0.001;
  const Vec3 offset = points.empty() ? Vec3::Zero() : Vec3(points.front().array().floor());
  for (std::size_t k = 0; k < 3; ++k) {
    put<double>(bytes, 131 + 8 * k, kStep);
    put<double>(bytes, 155 + 8 * k, offset[static_cast<Eigen::Index>(k)]);
  }
  bytes += records;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::string one(20, '\0');
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      put<std::int32_t>(
          one, 4 * k,
          static_cast<std::int32_t>(std::lround((points[i][axis] - offset[axis]) / kStep)));
    }
    if (!classes.empty()) put<std::uint8_t>(one, 15, classes[i]);
    bytes += one;
  }
  if (says.wkt_after_points) {
    put<std::uint64_t>(bytes, 235, bytes.size());
    put<std::uint32_t>(bytes, 243, 1);
    bytes += las_record(2112, says.wkt + '\0', true);
  }
  return bytes;
}

}  // namespace clast
