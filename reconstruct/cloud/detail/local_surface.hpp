#pragma once
/// The surface near a place, estimated from the points around it.
#include <span>
#include <vector>

#include "core/types.hpp"
#include "reconstruct/cloud/cloud.hpp"

namespace clast::reconstruct_detail {

/// Moving least squares: planes and quadrics fitted to the nearest points that face the same way.
/// @cite levin2004
class MovingLeastSquares {
 public:
  /// @param points   alive as long as this
  /// @param normals  unit, outward, one for each point; alive as long as this
  MovingLeastSquares(std::span<const Vec3> points, std::span<const Vec3> normals);

  /// Standard deviation of the points about small quadrics: the median over up to 2,000 points, m.
  double estimate_noise() const;

  /// Points that lie farther off the surface fitted to their neighbours than `spacings` (m) and the
  /// scatter of these allow, and a little apart from them: outliers close to the surface.
  std::vector<bool> find_off_surface_points(std::span<const double> spacings) const;

  /// A point against its neighbours that face the same way.
  struct PlaneDeviation {
    double height = 0.0;     ///< over the plane fitted to them, m
    double deviation = 0.0;  ///< of them about that plane, m
  };
  std::vector<PlaneDeviation> plane_deviations() const;

  /// Every point moved along its normal onto the plane or quadric through its neighbourhood, which
  /// is as large as `noise` (m) lets one fit: edges stay, since no plane or quadric fits there.
  std::vector<Vec3> smoothed_points(double noise) const;

 private:
  std::span<const Vec3> points_;
  std::span<const Vec3> normals_;
  PointTree tree_;
};

}  // namespace clast::reconstruct_detail
