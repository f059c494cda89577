#pragma once
/// Bounds and best estimate for the unobserved underside of a block.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/plane.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/surface_uncertainty.hpp"
#include "reconstruct/underside/free_space_grid.hpp"
#include "shapes/volume_bracket.hpp"

namespace clast {

struct UndersideOptions {
  /// Ground below the block, normal up. It bounds the block from below only if more than half of
  /// the space under it was observed to be free. If empty, the rim faces down.
  std::optional<Plane> ground = {};
  /// Depth of the best estimate below the rim, as a fraction of the observed height: a quarter of
  /// the total height by default. It does not affect the bounds.
  double max_depth_fraction = 1.0 / 3.0;
  /// Minimum area fraction of a hole's flat filling; smaller holes are ignored.
  double smallest_share = 0.001;
  /// Maximum area fraction; above it the scan is a sheet rather than a block (a hemisphere has a
  /// third).
  double largest_share = 0.42;
  /// Free space in the frame of the scan, evaluated above the given ground.
  const FreeSpaceGrid* free_space = nullptr;
  /// Returns true if a position on the open surface was scanned; fillings of small holes were not.
  /// Empty: all was.
  std::function<bool(const Vec3&)> is_observed = {};
  double unit = 1.0;  ///< m per unit of the mesh, for lengths in notes
  /// Uncertainty of the open surface; null if exact.
  const SurfaceUncertainty* uncertainty = nullptr;

  void check() const;  ///< throws InputError naming the field and its value
};

/// Scan closed in two ways, with bounds. Both meshes are closed and outward with equal triangles;
/// the filling of the largest hole is lowered in `best`. The lower volume is that of `lower` minus
/// possible indentations of the filling, like those of the observed surface.
struct Underside : VolumeBracket {
  TriangleMesh lower_mesh;  ///< filled by membranes across the rims
  TriangleMesh best_estimate;
  std::size_t open_sides = 1;      ///< number of holes bracketed together
  std::size_t first_filling = 0;   ///< index of the first filling triangle in both meshes
  Vec3 down = -Vec3::UnitZ();      ///< direction of the filling of the largest hole
  Vec3 rim_centre = Vec3::Zero();  ///< of the largest hole, m
  std::size_t rim_edges = 0;
  double rim_length = 0.0;        ///< m
  double ground_clearance = 0.0;  ///< height of the rim above the ground, m; 0 without ground
  std::vector<std::string> notes;
};

/// Closes the largest hole as underside and the others flat, and brackets them together; holes
/// below 0.3 % of the surface count as observed.
///
/// For a convex body, all of it lies behind each tangent plane of the observed surface: the upper
/// volume fills the space between closures and these planes, moved outwards by the observed
/// surface's height over its own tangent planes, down to a known ground, and excluding free space.
/// There is no upper volume if it would exceed the observed one by more than a third (doubling,
/// above a ground). Best estimate: docs/theory.md; measurements: docs/benchmarks.md.
/// @param open  oriented 2-manifold of one component; small holes may remain
/// @returns empty if no hole is large enough: the scan is practically closed
/// @throws GeometryError  if it is not an oriented manifold, is a sheet, or a rim cannot be filled;
///                        states size and position of the hole
/// @cite schneider2014
std::optional<Underside> close_underside(const TriangleMesh& open,
                                         const UndersideOptions& options = {});

}  // namespace clast
