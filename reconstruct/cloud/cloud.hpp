#pragma once
/// The few operations of PCL that clouds need, on plain points. PCL holds floats, so everything is
/// about a local origin; results have the same bits whatever the number of threads.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Numbers of the points that are no outliers: those whose mean distance to their `neighbours`
/// nearest is at most `deviations` standard deviations above the mean of all. In order.
/// @cite rusu2008
std::vector<std::uint32_t> find_inliers(std::span<const Vec3> points, int neighbours,
                                        double deviations);

/// One point for each cube of side `cell` that holds some: their mean. m
std::vector<Vec3> decimated(std::span<const Vec3> points, double cell);

/// Sets of points that are linked by steps of at most `max_gap`, the largest first; sets of fewer
/// than `min_points` are left out.
std::vector<std::vector<std::uint32_t>> find_clusters(std::span<const Vec3> points, double max_gap,
                                                      std::size_t min_points);

/// Unit normals of the planes through the `neighbours` nearest, of either sign.
std::vector<Vec3> estimate_normals(std::span<const Vec3> points, int neighbours);

/// Nearest points, by a k-d tree.
class PointTree {
 public:
  explicit PointTree(std::span<const Vec3> points);
  ~PointTree();

  struct Neighbour {
    std::uint32_t point;
    double distance;  ///< m
  };
  /// The `count` nearest, nearest first; fewer where there are fewer.
  std::vector<Neighbour> nearest_neighbours(const Vec3& position, int count) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Mean distance of a point to its nearest, over up to 2000 points spread over the list. m
double mean_spacing(std::span<const Vec3> points);

}  // namespace clast::reconstruct_detail
