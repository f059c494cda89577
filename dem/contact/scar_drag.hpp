#pragma once
/// Drag of the ground on what of a block is in it (docs/theory.md, Scar drag). @cite lu2019
#include <span>
#include <vector>

#include "dem/contact/contact_history.hpp"
#include "dem/motion/body_motion.hpp"

namespace clast::dem_detail {

/// The part of a block below a plane, seen along a direction in the plane.
struct EmbeddedFrontalArea {
  double area = 0.0;  ///< m^2
  Vec3 centre = Vec3::Zero();
};

/// Exact for convex cores, which count lowered by their radius; hollows in front count twice. A
/// ball is a segment of a circle, and a rod counts by its lower end.
/// @param block      of the core, in its own frame, as are all that follow
/// @param radius     of the rounding, m
/// @param ground     a point of the plane
/// @param up         its unit normal, out of the ground
/// @param direction  of the motion, unit, along the plane
EmbeddedFrontalArea embedded_frontal_area(const SurfaceFeatures& block, double radius, const Vec3& ground,
                             const Vec3& up, const Vec3& direction);

/// The drag on one block: F = C_d rho A v^2/2 against the motion v of the middle of its embedded
/// front A along the ground.
class ScarDrag {
 public:
  /// @param strength  C_d rho/2 by zone, kg/m^3; it and the block must outlive the drag
  ScarDrag(std::span<const double> drag_factors, const IndexedSurface& block)
      : block_(block), drag_factors_(drag_factors) {}

  /// The force at the end of a step; (0, 0, 0) without contacts.
  /// @param lost  gets what the drag of the step took from the block, J
  Vec3 update(const std::vector<Contact>& contacts, const RelativeMotion& motion, double& lost);
  const Vec3& application_point() const { return position_; }  ///< where it acts
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(force_, position_);
  }

 private:
  Vec3 drag_force(const std::vector<Contact>& contacts, const RelativeMotion& motion);

  const IndexedSurface& block_;
  std::span<const double> drag_factors_;
  Vec3 force_ = Vec3::Zero(), position_ = Vec3::Zero();
};

}  // namespace clast::dem_detail
