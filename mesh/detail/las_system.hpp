#pragma once
/// Coordinate system of LAS files, from their projection records.
#include <cstdint>
#include <istream>

#include "mesh/point_cloud.hpp"

namespace clast::mesh_detail {

/// Positions of the variable-length records of a LAS file.
struct LasRecordLayout {
  std::uint64_t begin = 0;           ///< start of the records before the points (the header size)
  std::uint64_t end = 0;             ///< start of the points
  std::uint32_t count = 0;           ///< number of records before the points
  std::uint64_t extended_begin = 0;  ///< start of the records after the points, since version 1.4
  std::uint32_t extended_count = 0;
  bool uses_wkt = false;  ///< bit 4 of the global encoding: WKT instead of GeoTIFF keys
};

/// Reads the coordinate system of a LAS file, from GeoTIFF keys and WKT. Sets `crs` and
/// `unit_declarations` of the summary.
void read_las_crs(std::istream& stream, const LasRecordLayout& records, CloudSummary& summary);

}  // namespace clast::mesh_detail
