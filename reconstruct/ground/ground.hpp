#pragma once
/// Detection of the ground in scans.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "reconstruct/underside/underside.hpp"

namespace clast {

/// Options of ground detection; lengths are fractions of the scan's diagonal.
struct GroundDetectionOptions {
  std::uint64_t seed = 1;          ///< seed of the random planes
  int trials = 1000;               ///< number of random planes
  double tolerance = 0.01;         ///< maximum distance of points from the initial plane
  double min_block_height = 0.03;  ///< minimum height of blocks above the ground

  void check() const;  ///< throws InputError naming the field and its value
};

/// Ground, described by a plane and smooth heights above it.
class Ground {
 public:
  struct Surface;
  Ground(const Plane& plane, std::unique_ptr<const Surface> surface,
         double roughness);  ///< standard deviation about the surface, m
  Ground(Ground&&) noexcept;
  Ground& operator=(Ground&&) noexcept;
  ~Ground();

  const Plane& plane() const { return plane_; }    ///< reference plane; its normal points up
  double roughness() const { return roughness_; }  ///< standard deviation about the surface, m
  /// Returns the height above the local ground surface along the plane's normal, m.
  double height_above_ground(const Vec3& point) const;
  /// Returns the tangent plane of the ground below `point`, averaged over the length `size` (m).
  Plane tangent_plane_below(const Vec3& point, double size) const;

 private:
  Plane plane_;
  std::unique_ptr<const Surface> surface_;
  double roughness_;
};

/// Finds the ground. The plane that contains most points is the ground if nearly all other points
/// are on one side of it, and if it is visible around them. A smooth height surface is then fitted
/// to the points near the plane.
/// @param points  points without outliers, m
/// @returns empty if no plane is a ground, for example if the scan contains a single block only
/// @cite fischler1981
std::optional<Ground> find_ground(std::span<const Vec3> points,
                                  const GroundDetectionOptions& options = {});

}  // namespace clast
