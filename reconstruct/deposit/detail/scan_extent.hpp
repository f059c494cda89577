#pragma once
/// Extent of a whole scan, and blocks that its border cuts.
#include <span>
#include <vector>

#include "reconstruct/deposit/detail/region_samples.hpp"

namespace clast::reconstruct_detail {

/// Middle and convex hull in plan of a scan.
class ScanExtent {
 public:
  /// @param points  points of the whole scan, z up
  explicit ScanExtent(std::span<const Vec3> points);

  const Vec3& middle() const { return middle_; }  ///< middle of the bounding box, m
  /// Returns whether the border cuts a surface: whether points within three spacings of the border
  /// extend over more than 0.4 of its diameter, and their normals do not point outwards, as those
  /// of a flank do that ends there.
  /// @param surface  points of a block with their normals
  bool border_cuts(std::span<const SurfaceSample> surface, double spacing) const;

 private:
  Vec3 middle_;
  std::vector<Vec2> outline_;  ///< counter-clockwise
};

}  // namespace clast::reconstruct_detail
