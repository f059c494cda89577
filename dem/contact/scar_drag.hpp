#pragma once
/// Drag on the embedded part of a block (docs/theory.md, Scar drag). @cite lu2019
#include <span>
#include <vector>

#include "dem/contact/contact_history.hpp"
#include "dem/motion/body_motion.hpp"

namespace clast::dem_detail {

/// Area of the part of a block below a plane, projected along a direction in the plane.
struct EmbeddedFrontalArea {
  double area = 0.0;  ///< m^2
  Vec3 centre = Vec3::Zero();
};

/// Computes the embedded frontal area. It is exact for a convex core, which is lowered by the
/// radius of the rounding. Front faces in a concavity count twice. A ball gives a circular segment;
/// of a rod, only the lower end counts.
/// @param block  features of the core in the body frame; the other arguments are in this frame too
/// @param radius  radius of the rounding, m
/// @param ground  point of the plane
/// @param up  unit normal of the plane, out of the ground
/// @param direction  direction of motion, unit, in the plane
EmbeddedFrontalArea embedded_frontal_area(const SurfaceFeatures& block, double radius,
                                          const Vec3& ground, const Vec3& up,
                                          const Vec3& direction);

/// Drag on one block: F = C_d rho A v^2/2, opposite to the tangential velocity v of the centre of
/// its embedded frontal area A.
class ScarDrag {
 public:
  /// Stores the block.
  /// @param drag_factors  C_d rho/2 by zone, kg/m^3; must outlive this object, as must the block
  ScarDrag(std::span<const double> drag_factors, const IndexedSurface& block)
      : block_(block), drag_factors_(drag_factors) {}

  /// Computes the force at the end of a step; zero without contacts.
  /// @param lost  receives the energy dissipated by the drag in the step, J
  Vec3 update(const std::vector<Contact>& contacts, const RelativeMotion& motion, double& lost);
  const Vec3& application_point() const { return position_; }  ///< point of application
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
