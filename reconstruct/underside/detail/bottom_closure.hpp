#pragma once
/// Surface that closes the hole under a block and is lowered to model the unobserved bottom.
#include <cstddef>
#include <utility>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/underside/detail/hole_patch.hpp"
#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

/// Displacement of the surface that closes a hole. Each vertex moves by `depth` (m) times its
/// deflection raised to `power`. Larger powers give a more pointed bottom.
struct ClosureDisplacement {
  double power = 0.0, depth = 0.0;
};

/// Surface that closes a hole and can be lowered along one direction. The added volume is
/// proportional to the depth.
class BottomClosure {
 public:
  static constexpr double kMinPower = 0.05;  ///< minimum of `ClosureDisplacement::power`

  /// Constructs the closure of a mesh.
  /// @param closed  mesh whose hole is closed by `patch`; must outlive this object
  /// @param patch  triangles that close the hole; their new vertices in `closed` begin at
  ///               `first_vertex`
  /// @param down  direction in which the closure is lowered, unit vector
  BottomClosure(const TriangleMesh& closed, HolePatch patch, std::size_t first_vertex,
                const Vec3& down)
      : closed_(closed), patch_(std::move(patch)), first_vertex_(first_vertex), down_(down) {}

  /// Returns the closed mesh with its closure lowered.
  TriangleMesh lowered_mesh(const ClosureDisplacement& move) const;
  /// Returns the displacement that adds the volume `added` (m^3). The power is reduced such that
  /// the depth is at most `deepest` (m), if possible.
  ClosureDisplacement displacement_for_volume(double added, double power, double deepest) const;
  /// Returns the displacement that adds the volume `added` and reaches the ground, because a block
  /// does not float. It starts from `blunt` and makes the bottom more pointed, up to `max_power`.
  ClosureDisplacement displacement_touching_ground(const Plane& ground,
                                                   const ClosureDisplacement& blunt, double added,
                                                   double max_power) const;

 private:
  /// Returns the volume added per depth of the displacement, m^2.
  double volume_per_depth(double power) const;
  bool touches(const Plane& ground, const ClosureDisplacement& move) const;
  double lowering_at_vertex(std::size_t vertex, const ClosureDisplacement& move) const;

  const TriangleMesh& closed_;
  HolePatch patch_;
  std::size_t first_vertex_;
  Vec3 down_;
};

}  // namespace clast::reconstruct_detail
