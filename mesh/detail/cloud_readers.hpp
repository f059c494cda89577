#pragma once
/// One reader per cloud format. Each hands over its points and says what it left out; messages have
/// no file name.
#include <istream>
#include <string_view>

#include "mesh/point_cloud.hpp"

namespace clast::mesh_detail {

/// Collects points and hands them over in batches of a size that suits the cache.
class PointSink {
 public:
  explicit PointSink(const std::function<void(const PointBatch&)>& consume) : take_(consume) {}

  /// Points that are not finite are counted and left out.
  void add_point(const Vec3& point);
  void add_point(const Vec3& point, std::uint8_t asprs_class);
  /// Hands over the rest.
  CloudSummary finish(CloudSummary summary);

 private:
  bool is_usable(const Vec3& point);
  void flush_batch();

  const std::function<void(const PointBatch&)>& take_;
  PointBatch batch_;
  std::size_t points_ = 0;
  std::size_t non_finite_ = 0;
};

/// @throws InputError  corrupt or cut short
/// @param columns  as `stream_cloud` has them
/// @param counted  the number of points stands before each scan, as in .pts files
CloudSummary read_text_cloud(std::istream& stream, PointSink& sink,
                             const std::vector<std::string>& columns, bool has_point_counts);
CloudSummary read_las(std::istream& stream, PointSink& sink);
CloudSummary read_pcd(std::string_view content, PointSink& sink);

}  // namespace clast::mesh_detail
