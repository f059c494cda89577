#pragma once
/// Closure of a hole, lowered to the possible bottom of a block.
#include <cstddef>
#include <utility>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/underside/detail/hole_patch.hpp"
#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

/// Displacement of the closure: `depth` (m) times the deflection to a power. Larger powers give a
/// more pointed bottom.
struct ClosureShape {
  double power = 0.0, depth = 0.0;
};

/// Closure that is lowered along one direction, so that the added volume is proportional to the
/// depth.
class BottomClosure {
 public:
  static constexpr double kMinPower = 0.05;  ///< smallest power

  /// Stores the closure.
  /// @param closed  mesh with the closure; must outlive this object
  /// @param patch  closure, with vertices from `first_vertex` on in `closed`
  /// @param down  unit vector
  BottomClosure(const TriangleMesh& closed, HolePatch patch, std::size_t first_vertex,
                const Vec3& down)
      : closed_(closed), patch_(std::move(patch)), first_vertex_(first_vertex), down_(down) {}

  /// Returns `closed` with the lowered closure.
  TriangleMesh lower_mesh(const ClosureShape& move) const;
  /// Returns the shape with `added` volume (m^3), at most `deepest` (m) if possible, by reducing
  /// the power.
  ClosureShape shape_for_volume(double added, double power, double deepest) const;
  /// Returns the shape of equal volume that touches the ground, because a block does not float, by
  /// increasing the power up to `max_power`.
  ClosureShape shape_touching_ground(const Plane& ground, const ClosureShape& blunt, double added,
                                     double max_power) const;

 private:
  /// Returns the added volume per depth, m^2.
  double volume_per_depth(double power) const;
  bool touches(const Plane& ground, const ClosureShape& move) const;
  double lowering_at_vertex(std::size_t vertex, const ClosureShape& move) const;

  const TriangleMesh& closed_;
  HolePatch patch_;
  std::size_t first_vertex_;
  Vec3 down_;
};

}  // namespace clast::reconstruct_detail
