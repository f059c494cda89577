#pragma once
/// Readers of point cloud formats. Messages do not contain the file name.
#include <filesystem>
#include <istream>
#include <string_view>

#include "mesh/point_cloud.hpp"

namespace clast::mesh_detail {

struct LasCopy;

/// Collects points and passes them on in batches that fit into the cache.
class PointBatcher {
 public:
  explicit PointBatcher(const std::function<void(const PointBatch&)>& consume)
      : consume_(consume) {}

  /// Adds a point. Non-finite points are counted and skipped.
  void add_point(const Vec3& point);
  void add_point(const Vec3& point, std::uint8_t asprs_class, const PointRecording& recording);
  /// Passes the remaining points to the consumer and completes the summary.
  CloudSummary finish(CloudSummary summary);

 private:
  bool is_usable(const Vec3& point);
  void flush_batch();

  const std::function<void(const PointBatch&)>& consume_;
  PointBatch batch_;
  std::size_t points_ = 0;
  std::size_t non_finite_ = 0;
};

/// Reads a text, LAS or PCD cloud and passes its points to `sink`.
/// @param columns  columns of x, y and z, as in `stream_cloud`
/// @param has_point_counts  true if the number of points precedes each scan, as in .pts files
/// @throws InputError  if the file is corrupt or truncated
CloudSummary read_text_cloud(std::istream& stream, PointBatcher& sink,
                             const std::vector<std::string>& columns, bool has_point_counts);
/// @param path  the file, for the program that unpacks it if it is compressed (LAZ)
/// @param copy  keeps the unpacked points for the next call with the same path; may be null
CloudSummary read_las_cloud(std::istream& stream, const std::filesystem::path& path,
                            PointBatcher& sink, LasCopy* copy);
CloudSummary read_pcd_cloud(std::string_view content, PointBatcher& sink);

}  // namespace clast::mesh_detail
