#pragma once
/// Points of lidar and photogrammetry from files.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "mesh/reference_system.hpp"

namespace clast {

/// Some points of a cloud, in the units and axes of its file.
struct PointBatch {
  std::vector<Vec3> points;
  std::vector<std::uint8_t> classes;  ///< ASPRS class of each point of a LAS file; else empty
};

/// ASPRS class of points on the ground (LAS 1.4 R15, table 17).
inline constexpr std::uint8_t kGroundClass = 2;

/// What a cloud file holds beside its points.
struct CloudSummary {
  std::size_t points = 0;      ///< handed over
  std::size_t non_finite = 0;  ///< left out: a coordinate is not finite
  std::size_t withheld = 0;    ///< left out: flagged as withheld, or classed as noise (LAS)
  std::string crs;             ///< "EPSG:25832", else WKT; empty when the file does not say
  std::vector<LengthUnitDeclaration> lengths = {};  ///< all that the file says of its units
};

/// Reads a cloud and hands it over in batches, in the order of the file, so that it need not fit
/// into memory: .xyz, .txt, .csv, .pts, .asc (text), .las (1.0 to 1.4), .pcd (ascii, binary,
/// compressed), .ply and other meshes (their vertices).
///
/// Text: the separator of the first line of points (a semicolon, tab or comma, else blanks) decides
/// the columns; decimal commas are read where commas do not separate. A heading above the points,
/// also in a remark, names x, y and z (`find_coordinate_columns`); without a heading they are the
/// first three. Lines that start with # or // are skipped, and so are lines with nothing but the
/// number of points of the scan that follows.
/// @param columns  of a text: three names or numbers from 1, those of x, y and z; empty: the
/// heading
///                 decides
/// @throws InputError  missing, corrupt, cut short, compressed (.laz) or without points; a heading
///                     that does not name x, y and z; `columns` of no text; the message names the
///                     file, and the line of a text
CloudSummary stream_cloud(const std::filesystem::path& path,
                          const std::function<void(const PointBatch&)>& consume,
                          const std::vector<std::string>& columns = {});

/// All points of a file at once. @throws as `stream_cloud`
std::vector<Vec3> read_cloud(const std::filesystem::path& path);

/// Formats that hold points and never triangles, as lower-case extensions with the dot.
const std::vector<std::string>& cloud_extensions();

}  // namespace clast
