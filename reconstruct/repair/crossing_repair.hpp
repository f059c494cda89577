#pragma once
/// Ways to free a closed surface of places where it passes through itself, the gentlest first.
#include <cstddef>
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Relative change of the volume by replacing crossings above which that did harm.
inline constexpr double kCrossingVolume = 0.02;

/// Moves vertices that were computed about a local `origin` to where they will lie when that is
/// added again: rounded only then, triangles that just missed each other may cross.
TriangleMesh snapped_to_grid(TriangleMesh mesh, const Vec3& origin);

/// A surface that was freed of its crossings.
struct CrossingFreeSurface {
  TriangleMesh mesh;
  /// Set where only a wrap gave one: relative volume it had too much before it was scaled back.
  std::optional<double> wrap_bias;
};

/// Sheets that touch are parted by a hair's breadth; else triangles that cross are smoothed, or cut
/// out with more and more rings around them and filled anew; else the surface is wrapped, and the
/// wrap is scaled back to its volume.
/// @param mesh    closed, oriented 2-manifold of one component, already `snapped_to_grid`
/// @param origin  of its coordinates; the result is on the same grid
/// @return closed, oriented, of one component, without crossings, its volume within
/// `kCrossingVolume`;
///         none where no way gave such a surface
std::optional<CrossingFreeSurface> repair_crossings(const TriangleMesh& mesh, const Vec3& origin);

}  // namespace clast::reconstruct_detail
