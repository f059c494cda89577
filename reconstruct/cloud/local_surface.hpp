#pragma once
/// Local surface estimation from nearby points.
#include <span>
#include <vector>

#include "core/types.hpp"
#include "reconstruct/cloud/cloud.hpp"

namespace clast::reconstruct_detail {

/// Moving least squares: fits planes and quadrics to the nearest points with similar normals.
/// @cite levin2004
class MovingLeastSquares {
 public:
  static constexpr int kNoiseNeighbours = 24;

  /// Constructs the method for a set of points.
  /// @param points  must outlive this object
  /// @param normals  unit, one per point; must outlive this object
  /// @param is_oriented  true if all normals are outward; otherwise, the two sides of a thin plate
  ///                     are not distinguished
  MovingLeastSquares(std::span<const Vec3> points, std::span<const Vec3> normals,
                     bool is_oriented = true);

  /// Scatter of neighbours about a fitted quadric.
  struct Scatter {
    double deviation = 0.0;  ///< standard deviation, m
    /// Fourth moment over the squared variance: 3 for Gaussian noise, 1 for two parallel planes.
    double kurtosis = 0.0;
  };
  /// Estimates the scatter: medians over up to 2,000 points.
  /// @param neighbours  number of neighbours of each point
  Scatter estimate_scatter(int neighbours) const;
  /// Estimates the noise, m: the standard deviation of 24 neighbours.
  double estimate_noise() const { return estimate_scatter(kNoiseNeighbours).deviation; }

  /// Finds outliers close to the surface. They are slightly isolated, and farther from the surface
  /// fitted to their neighbours than their spacing and scatter allow.
  /// @param spacings  local point spacings, m
  std::vector<bool> find_off_surface_points(std::span<const double> spacings) const;

  /// Deviation of a point from the plane fitted to its neighbours.
  struct PlaneDeviation {
    double height = 0.0;     ///< height of the point above the fitted plane, m
    double deviation = 0.0;  ///< standard deviation of the neighbours, m
  };
  std::vector<PlaneDeviation> plane_deviations() const;

  /// Returns the points projected along their normals onto a local plane or quadric. It is that of
  /// the largest neighbourhood that is fitted to within `noise` (m). Edges are preserved, because
  /// there is no such fit near them.
  /// @param threads  number of threads; does not affect the result
  std::vector<Vec3> smoothed_points(double noise, unsigned threads) const;

 private:
  Vec3 smoothed_point(std::size_t i, double noise) const;

  std::span<const Vec3> points_;
  std::span<const Vec3> normals_;
  bool is_oriented_;
  PointTree tree_;
};

}  // namespace clast::reconstruct_detail
