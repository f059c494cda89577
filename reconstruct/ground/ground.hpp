#pragma once
/// The ground in a scan.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "reconstruct/underside/underside.hpp"

namespace clast {

/// How ground is distinguished from blocks. Shares are of the diagonal of the scan.
struct GroundOptions {
  std::uint64_t seed = 1;    ///< of the draws of planes
  int trials = 1000;         ///< planes drawn
  double tolerance = 0.01;   ///< of the first plane; the local surface follows the ground closer
  double least_rise = 0.03;  ///< what rises less is no block

  void check() const;  ///< throws InputError naming the field and its value
};

/// A ground as a plane and smooth heights above it.
class Ground {
 public:
  struct Surface;
  Ground(const Plane& plane, std::unique_ptr<const Surface> surface, double roughness);
  Ground(Ground&&) noexcept;
  Ground& operator=(Ground&&) noexcept;
  ~Ground();

  const Plane& plane() const { return plane_; }    ///< normal up, away from what lies below
  double roughness() const { return roughness_; }  ///< standard deviation about the surface, m
  /// Height above the local surface along the plane's normal, m.
  double height(const Vec3& point) const;
  /// The plane that touches the local surface where it passes below `point`, over a reach of
  /// `size`.
  Plane tangent_plane_below(const Vec3& point, double size) const;

 private:
  Plane plane_;
  std::unique_ptr<const Surface> surface_;
  double roughness_;
};

/// Finds the ground: the plane that most points lie on while nearly all others lie on one side of
/// it, and that is seen around them; then a smooth surface of heights above it, fitted to what lies
/// on it only.
/// @param points  without outliers, m
/// @returns none where no plane is the ground of the rest: a block by itself
/// @cite fischler1981
std::optional<Ground> find_ground(std::span<const Vec3> points, const GroundOptions& options = {});

}  // namespace clast
