#pragma once
/// Ellipsoid of a partly visible block, with a prior for its axis ratios.
#include <span>

#include "core/types.hpp"
#include "reconstruct/deposit/detail/region_samples.hpp"

namespace clast::reconstruct_detail {

struct Ellipsoid {
  Vec3 centre = Vec3::Zero();
  Mat3 axes = Mat3::Identity();   ///< columns: unit axes
  Vec3 semi_axes = Vec3::Ones();  ///< m, in the order of `axes`

  /// Transforms a point to the frame in which the ellipsoid is the unit sphere.
  Vec3 to_unit_sphere(const Vec3& point) const {
    return (axes.transpose() * (point - centre)).cwiseQuotient(semi_axes);
  }
  Vec3 from_unit_sphere(const Vec3& point) const {
    return centre + axes * point.cwiseProduct(semi_axes);
  }
  double volume() const { return 4.0 / 3.0 * kPi * semi_axes.prod(); }
};

/// Fits the most probable ellipsoid of a block: close to the visible samples, parallel to their
/// normals, with few samples of the surroundings inside, and with axis ratios as rocks have them.
/// @param seen  samples of the visible surface, at least 4
/// @param around  samples of neighbours and ground, which are not inside the block
Ellipsoid fit_prior_ellipsoid(std::span<const SurfaceSample> seen,
                              std::span<const SurfaceSample> around);

}  // namespace clast::reconstruct_detail
