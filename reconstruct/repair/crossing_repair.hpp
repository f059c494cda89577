#pragma once
/// Repair of self-intersections of closed surfaces, with the mildest method first.
#include <cstddef>
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Largest acceptable relative volume change of a self-intersection repair.
inline constexpr double kCrossingVolume = 0.02;

/// Rounds vertices computed about a local `origin` to the positions they will have after adding it;
/// rounding afterwards could cause new intersections.
TriangleMesh snapped_to_grid(TriangleMesh mesh, const Vec3& origin);

/// Surface without self-intersections.
struct CrossingFreeSurface {
  TriangleMesh mesh;
  /// Relative excess volume of a wrap before scaling, if wrapping was necessary.
  std::optional<double> wrap_bias;
};

/// Repairs self-intersections: separates touching sheets minimally; otherwise smooths intersecting
/// triangles, or removes them with growing neighbourhoods and fills the holes; otherwise wraps the
/// surface and scales the wrap to its volume.
/// @param mesh  closed, oriented 2-manifold of one component, already `snapped_to_grid`
/// @param origin  of its coordinates; the result is on the same grid
/// @return closed, oriented, one component, without self-intersections, volume within
///          `kCrossingVolume`; empty if no method succeeds
std::optional<CrossingFreeSurface> repair_crossings(const TriangleMesh& mesh, const Vec3& origin);

}  // namespace clast::reconstruct_detail
