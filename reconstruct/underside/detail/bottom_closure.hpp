#pragma once
/// A closure across the rim of a hole, moved down to where the block may end.
#include <cstddef>
#include <utility>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/underside/detail/hole_patch.hpp"
#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

/// How the closure is moved: every vertex by `depth` (m) times its bulge to a power. The larger the
/// power, the more pointed what hangs below.
struct ClosureShape {
  double power = 0.0, depth = 0.0;
};

/// What lies under the closure grows in proportion to the depth, since all moves are along one way.
class BottomClosure {
 public:
  static constexpr double kMinPower = 0.05;  ///< least power of a move

  /// @param closed        with the closure, and alive as long as this
  /// @param patch         the closure, its vertices numbered from `first_vertex` on in `closed`
  /// @param down          unit
  BottomClosure(const TriangleMesh& closed, HolePatch patch, std::size_t first_vertex,
                const Vec3& down)
      : closed_(closed), patch_(std::move(patch)), first_vertex_(first_vertex), down_(down) {}

  /// `closed` with the closure moved.
  TriangleMesh lowered(const ClosureShape& move) const;
  /// With `added` volume (m^3) under the closure, no deeper than `deepest` (m) where that is
  /// possible: the power falls until it is.
  ClosureShape shape_for_volume(double added, double power, double deepest) const;
  /// The same volume, so pointed that it touches the ground: a block does not float. The power
  /// rises to `max_power` at most.
  ClosureShape shape_touching_ground(const Plane& ground, const ClosureShape& blunt, double added, double max_power) const;

 private:
  /// Volume that is added for each metre of depth, m^2.
  double volume_per_depth(double power) const;
  bool touches(const Plane& ground, const ClosureShape& move) const;
  double vertex_drop(std::size_t vertex, const ClosureShape& move) const;

  const TriangleMesh& closed_;
  HolePatch patch_;
  std::size_t first_vertex_;
  Vec3 down_;
};

}  // namespace clast::reconstruct_detail
