#pragma once
/// PCL operations on plain points. PCL uses floats, so coordinates are relative to a local origin;
/// results do not depend on the number of threads.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace clast::reconstruct_detail {

/// Returns the ascending indices of points whose mean distance to their `neighbours` nearest points
/// is at most `deviations` standard deviations above the mean of all.
/// @cite rusu2008
std::vector<std::uint32_t> find_inliers(std::span<const Vec3> points, int neighbours,
                                        double deviations);

/// Decimates points to the mean per cube of side `cell`, m.
std::vector<Vec3> decimated(std::span<const Vec3> points, double cell);

/// Finds clusters of points connected by steps of at most `reach`, the largest first; clusters
/// below `min_points` are omitted.
std::vector<std::vector<std::uint32_t>> find_clusters(std::span<const Vec3> points, double max_gap,
                                                      std::size_t min_points);

/// Estimates unit normals of arbitrary sign from the planes through the `neighbours` nearest
/// points.
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
