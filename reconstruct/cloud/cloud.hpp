#pragma once
/// Point cloud operations of PCL on `Vec3` points. PCL uses floats, so coordinates are relative to
/// a local origin. Results do not depend on the number of threads.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Returns the ascending indices of the inliers. An inlier's mean distance to its `neighbours`
/// nearest points exceeds the mean over all points by at most `deviations` standard deviations.
/// @cite rusu2008
std::vector<std::uint32_t> find_inliers(std::span<const Vec3> points, int neighbours,
                                        double deviations);

/// Decimates points: replaces the points in each cube of side `cell` (m) by their mean.
std::vector<Vec3> decimate_points(std::span<const Vec3> points, double cell);

/// Finds clusters of points connected by steps of at most `max_gap`, the largest first. Clusters
/// with fewer than `min_points` points are omitted.
std::vector<std::vector<std::uint32_t>> find_clusters(std::span<const Vec3> points, double max_gap,
                                                      std::size_t min_points);

/// Estimates unit normals from planes of the `neighbours` nearest points. Signs are arbitrary.
std::vector<Vec3> estimate_normals(std::span<const Vec3> points, int neighbours);

/// Search for nearest points with a k-d tree.
class PointTree {
 public:
  explicit PointTree(std::span<const Vec3> points);
  ~PointTree();

  struct Neighbour {
    std::uint32_t point;
    double distance;  ///< m
  };
  /// Returns up to `count` nearest points, the nearest first.
  std::vector<Neighbour> nearest_neighbours(const Vec3& position, int count) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the mean nearest-neighbour distance over up to 2000 points, m.
double mean_spacing(std::span<const Vec3> points);

}  // namespace clast::reconstruct_detail
