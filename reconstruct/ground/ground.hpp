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
  std::uint64_t seed = 1;    ///< of the random planes
  int trials = 1000;         ///< number of random planes
  double tolerance = 0.01;   ///< of the first plane; the local surface is fitted more closely
  double least_rise = 0.03;  ///< minimum height of blocks

  void check() const;  ///< throws InputError naming the field and its value
};

/// Ground as a plane with smooth heights above it.
class Ground {
 public:
  struct Surface;
  Ground(const Plane& plane, std::unique_ptr<const Surface> surface,
         double roughness);  ///< standard deviation about the surface, m
  Ground(Ground&&) noexcept;
  Ground& operator=(Ground&&) noexcept;
  ~Ground();

  const Plane& plane() const { return plane_; }    ///< normal up, away from what lies below
  double roughness() const { return roughness_; }  ///< standard deviation about the surface, m
  /// Returns the height above the local ground surface along the plane's normal, m.
  double height(const Vec3& point) const;
  /// Returns the tangent plane of the ground below `point`, averaged over a size.
  Plane tangent_plane_below(const Vec3& point, double size) const;

 private:
  Plane plane_;
  std::unique_ptr<const Surface> surface_;
  double roughness_;
};

/// Finds the ground: the plane that contains most points, with nearly all others on one side and
/// ground visible around them; then a smooth height surface fitted to its points.
/// @param points  without outliers, m
/// @returns empty if no plane is a ground, as for a single block
/// @cite fischler1981
std::optional<Ground> find_ground(std::span<const Vec3> points,
                                  const GroundDetectionOptions& options = {});

}  // namespace clast
