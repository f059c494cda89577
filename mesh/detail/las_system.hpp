#pragma once
/// The reference system of a LAS file, out of its projection records.
#include <cstdint>
#include <istream>

#include "mesh/point_cloud.hpp"

namespace clast::mesh_detail {

/// Where the variable-length records of a LAS file lie.
struct LasRecordLayout {
  std::uint64_t begin = 0;           ///< of those before the points: the size of the header
  std::uint64_t end = 0;             ///< where the points begin
  std::uint32_t count = 0;           ///< before the points
  std::uint64_t extended_begin = 0;  ///< of those after the points, from version 1.4 on
  std::uint32_t extended_count = 0;
  bool uses_wkt = false;  ///< bit 4 of the global encoding: WKT, not GeoTIFF keys
};

/// Reads GeoTIFF keys and WKT; sets `crs` and `lengths` of the summary.
void read_las_crs(std::istream& stream, const LasRecordLayout& records, CloudSummary& summary);

}  // namespace clast::mesh_detail
