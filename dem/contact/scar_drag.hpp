#pragma once
/// Drag on the embedded part of a block (docs/theory.md, Scar drag). @cite lu2019
#include <span>
#include <vector>

#include "dem/contact/contact_history.hpp"
#include "dem/motion/body_motion.hpp"

namespace clast::dem_detail {

/// Frontal area of the part of a block below the ground plane, projected along the direction of
/// motion.
struct EmbeddedFrontalArea {
  double area = 0.0;  ///< m^2
  Vec3 centre = Vec3::Zero();
};

/// Computes the frontal area of the part of a block below the ground plane. It is exact for convex
/// blocks, up to the shape of their rounding.
/// @param block  features of the core in the body frame; the other arguments are in this frame too
/// @param radius  radius of the rounding, m
/// @param ground  point of the ground plane
/// @param up  unit normal of the plane, out of the ground
/// @param direction  direction of motion, unit, in the plane
EmbeddedFrontalArea embedded_frontal_area(const SurfaceFeatures& block, double radius,
                                          const Vec3& ground, const Vec3& up,
                                          const Vec3& direction);

/// Drag force on the embedded part of a block: C rho A v^2 / 2, with drag coefficient C, soil
/// density rho, embedded frontal area A and tangential velocity v at the centre of that area. The
/// force acts opposite to v.
class ScarDrag {
 public:
  /// Stores references to the block and the drag factors.
  /// @param drag_factors  half of drag coefficient times soil density, by ground zone, kg/m^3; must
  ///                      outlive this object, as must the block
  ScarDrag(std::span<const double> drag_factors, const IndexedSurface& block)
      : block_(block), drag_factors_(drag_factors) {}

  /// Computes the drag force at the end of a step, N; zero without contacts.
  /// @param lost  receives the energy dissipated by the drag in the step, J
  Vec3 update(const std::vector<Contact>& contacts, const RelativeMotion& motion, double& lost);
  const Vec3& application_point() const {
    return position_;
  }  ///< point at which the drag force acts
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
