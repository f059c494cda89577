#pragma once
/// Reading of point clouds from lidar and photogrammetry.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "mesh/reference_system.hpp"

namespace clast {

/// Batch of points of a cloud, in the units and axes of its file.
struct PointBatch {
  std::vector<Vec3> points;           ///< number of points passed on
  std::vector<std::uint8_t> classes;  ///< ASPRS classes of a LAS file; otherwise empty
};

/// ASPRS class of ground points (LAS 1.4 R15, table 17).
inline constexpr std::uint8_t kGroundClass = 2;

struct CloudSummary {
  std::size_t points = 0;      ///< handed over
  std::size_t non_finite = 0;  ///< skipped points with a non-finite coordinate
  std::size_t withheld = 0;    ///< skipped points that are withheld or classified as noise (LAS)
  std::string crs;             ///< "EPSG:25832", otherwise WKT; empty if unknown
  std::vector<LengthUnitDeclaration> lengths = {};
};

/// Reads a cloud in batches, in file order, so that it need not fit into memory: .xyz, .txt, .csv,
/// .pts, .asc (text), .las (1.0 to 1.4), .pcd (ascii, binary, compressed), .ply and other meshes
/// (their vertices).
///
/// Text: the separator of the first line of points (a semicolon, tab or comma, otherwise blanks)
/// determines the columns; decimal commas are accepted unless commas separate. A heading, also in a
/// comment, names x, y and z (`find_coordinate_columns`); otherwise they are the first three
/// columns. Lines starting with # or // and lines with only the number of points of the next scan
/// are skipped.
/// @param columns  of a text: names or 1-based numbers of x, y and z; empty: by the heading
/// @throws InputError  if the file is missing, corrupt, truncated, compressed (.laz) or without
///                     points; the heading does not name x, y and z; or `columns` is given for
///                     another format; names the file, and the line of a text
CloudSummary stream_cloud(const std::filesystem::path& path,
                          const std::function<void(const PointBatch&)>& consume,
                          const std::vector<std::string>& columns = {});

/// Reads all points of a file.
/// @throws InputError  as `stream_cloud`
std::vector<Vec3> read_cloud(const std::filesystem::path& path);

/// Returns formats that contain points only, as lower-case extensions with the dot.
const std::vector<std::string>& cloud_extensions();

}  // namespace clast
