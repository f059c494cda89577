#pragma once
/// Repair of self-intersections of closed surfaces. The least invasive method is tried first.
#include <cstddef>
#include <optional>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Maximum relative volume change of a self-intersection repair.
inline constexpr double kMaxIntersectionVolumeChange = 0.02;

/// Rounds vertices relative to a local `origin` such that `origin` can be added without rounding
/// errors. Later rounding could cause new intersections.
TriangleMesh snapped_to_grid(TriangleMesh mesh, const Vec3& origin);

/// Repaired surface without self-intersections.
struct IntersectionFreeSurface {
  TriangleMesh mesh;
  /// Relative excess volume of a wrap before it was scaled. Set if wrapping was necessary.
  std::optional<double> relative_wrap_excess;
};

/// Repairs self-intersections where they are. Touching sheets are separated by a small distance. If
/// intersections remain, intersecting triangles are smoothed, or they and their neighbours are
/// removed and the holes filled.
/// @param mesh  closed, oriented 2-manifold of one component, already `snapped_to_grid`
/// @param origin  origin of the vertex coordinates; the result is snapped to the same grid
/// @return closed, oriented surface of one component without self-intersections; empty if no method
/// succeeds within `kMaxIntersectionVolumeChange`
std::optional<TriangleMesh> repair_self_intersections_locally(const TriangleMesh& mesh,
                                                              const Vec3& origin);

/// Repairs self-intersections like `repair_self_intersections_locally`. If that fails, the whole
/// surface is wrapped and the wrap scaled to its volume.
std::optional<IntersectionFreeSurface> repair_self_intersections(const TriangleMesh& mesh,
                                                                 const Vec3& origin);

}  // namespace clast::reconstruct_detail
