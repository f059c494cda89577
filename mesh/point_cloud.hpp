#pragma once
/// Reading of point clouds from lidar and photogrammetry.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "mesh/reference_system.hpp"

namespace clast {

namespace mesh_detail {
struct LasCopy;
}

/// Origin of a LAS point: the strip or position from which it was recorded, and when.
struct PointRecording {
  std::uint16_t source = 0;  ///< point source ID; 0 if unknown
  double time = 0.0;         ///< GPS time, s; 0 if unknown
};

/// Batch of points of a cloud, in the units and axes of its file.
struct PointBatch {
  std::vector<Vec3> points;           ///< points in the order of the file
  std::vector<std::uint8_t> classes;  ///< ASPRS class of each point of a LAS file; otherwise empty
  std::vector<PointRecording> recordings = {};  ///< of each point of a LAS file; otherwise empty
};

/// ASPRS class of ground points (LAS 1.4 R15, table 17).
inline constexpr std::uint8_t kGroundClass = 2;

/// Number of points, coordinate system and length units of a point cloud file.
struct CloudSummary {
  std::size_t point_count = 0;        ///< number of points passed to the caller
  std::size_t non_finite_points = 0;  ///< number of skipped points with a non-finite coordinate
  std::size_t withheld_points = 0;    ///< number of skipped points that are withheld or noise (LAS)
  std::string crs;                    ///< "EPSG:25832", otherwise WKT; empty if unknown
  std::vector<LengthUnitDeclaration> unit_declarations = {};
};

/// Reads a cloud in batches, in file order, so that it need not fit into memory. Formats are text
/// (.xyz, .txt, .csv, .pts, .asc), .las (1.0 to 1.4), .laz, .pcd (ascii, binary, compressed), and
/// the vertices of .ply and other meshes. The points of .laz are unpacked by a program that is
/// looked for on PATH: laszip, laszip64, las2las, node with the package laz-perf, or pdal.
///
/// Columns of text are separated by semicolons, tabs, commas or blanks, as in the first line of
/// points. Decimal commas are accepted unless commas separate the columns. A heading, which may be
/// in a comment, names x, y and z (`find_coordinate_columns`). Without heading, they are the first
/// three columns. Comments (# or //) and point counts before scans are skipped.
/// @param columns  names or numbers (from 1) of the columns x, y and z of a text; if empty, the
///                 heading decides
/// @throws InputError  if the file is missing, corrupt, truncated or without points, if no program
///                     at hand unpacks it (.laz), if the heading does not name x, y and z, or if
///                     `columns` is given for a format other than text; the message gives file and
///                     line
CloudSummary stream_cloud(const std::filesystem::path& path,
                          const std::function<void(const PointBatch&)>& consume,
                          const std::vector<std::string>& columns = {});

/// Point cloud file that is read several times.
class CloudFile {
 public:
  explicit CloudFile(std::filesystem::path path, std::vector<std::string> columns = {});
  ~CloudFile();
  CloudFile(CloudFile&&) noexcept;
  CloudFile& operator=(CloudFile&&) noexcept;

  const std::filesystem::path& path() const { return path_; }
  /// Reads the cloud as `stream_cloud`. A .laz file is unpacked only once: its points remain in a
  /// temporary file without a name, unless there is no room for it.
  CloudSummary stream(const std::function<void(const PointBatch&)>& consume) const;

 private:
  std::filesystem::path path_;
  std::vector<std::string> columns_;
  std::unique_ptr<mesh_detail::LasCopy> copy_;
};

/// Reads all points of a point cloud file.
/// @throws InputError  as `stream_cloud`
std::vector<Vec3> read_cloud(const std::filesystem::path& path);

/// Returns the extensions of formats that contain only points, in lower case with the dot.
const std::vector<std::string>& cloud_extensions();

}  // namespace clast
