#pragma once
/// Local surface estimation from nearby points.
#include <span>
#include <vector>

#include "core/types.hpp"
#include "reconstruct/cloud/cloud.hpp"

namespace clast::reconstruct_detail {

/// Moving least squares: planes and quadrics fitted to nearest points with similar normals.
/// @cite levin2004
class MovingLeastSquares {
 public:
  /// Stores the points.
  /// @param points  must outlive this object
  /// @param normals  unit, outward, one per point; must outlive this object
  MovingLeastSquares(std::span<const Vec3> points, std::span<const Vec3> normals);

  /// Returns the noise: the median standard deviation about small quadrics over up to 2,000 points,
  /// m.
  double estimate_noise() const;

  /// Finds outliers close to the surface: points farther from the surface fitted to their
  /// neighbours than `spacings` (m) and scatter allow, and slightly isolated.
  std::vector<bool> find_off_surface_points(std::span<const double> spacings) const;

  /// Deviation of a point from the plane of its neighbours.
  struct PlaneDeviation {
    double height = 0.0;     ///< of the point over the fitted plane, m
    double deviation = 0.0;  ///< standard deviation of the neighbours, m
  };
  std::vector<PlaneDeviation> plane_deviations() const;

  /// Returns the points projected along their normals onto the local plane or quadric of the
  /// largest neighbourhood that fits within `noise` (m); edges are preserved because no such fit
  /// exists there.
  std::vector<Vec3> smoothed_points(double noise) const;

 private:
  std::span<const Vec3> points_;
  std::span<const Vec3> normals_;
  PointTree tree_;
};

}  // namespace clast::reconstruct_detail
