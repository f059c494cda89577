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
struct Move {
  double power = 0.0, depth = 0.0;
};

/// What lies under the closure grows in proportion to the depth, since all moves are along one way.
class BottomClosure {
 public:
  static constexpr double kBluntest = 0.05;  ///< least power of a move

  /// @param closed        with the closure, and alive as long as this
  /// @param patch         the closure, its vertices numbered from `first_vertex` on in `closed`
  /// @param down          unit
  BottomClosure(const TriangleMesh& closed, HolePatch patch, std::size_t first_vertex,
                const Vec3& down)
      : closed_(closed), patch_(std::move(patch)), first_vertex_(first_vertex), down_(down) {}

  /// `closed` with the closure moved.
  TriangleMesh lowered(const Move& move) const;
  /// With `added` volume (m^3) under the closure, no deeper than `deepest` (m) where that is
  /// possible: the power falls until it is.
  Move holding(double added, double power, double deepest) const;
  /// The same volume, so pointed that it touches the ground: a block does not float. The power
  /// rises to `most` at most.
  Move lying(const Plane& ground, const Move& blunt, double added, double most) const;

 private:
  /// Volume that is added for each metre of depth, m^2.
  double column(double power) const;
  bool touches(const Plane& ground, const Move& move) const;
  double fall(std::size_t vertex, const Move& move) const;

  const TriangleMesh& closed_;
  HolePatch patch_;
  std::size_t first_vertex_;
  Vec3 down_;
};

}  // namespace clast::reconstruct_detail
