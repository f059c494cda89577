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
  /// the space under the block was observed to be free. If empty, the rim faces down.
  std::optional<Plane> ground = {};
  /// Depth limit of the best estimate below the rim, divided by the height of the observed part. At
  /// the default, the limit is a quarter of the total height. It does not affect the bounds.
  double max_depth_fraction = 1.0 / 3.0;
  /// Minimum area of a hole, filled flat, as a fraction of the surface. Smaller ones are ignored.
  double min_hole_fraction = 0.001;
  /// Maximum area of the fillings, as a fraction of the surface. Above it, the scan is a sheet
  /// rather than a block. For a hemisphere, the fraction is a third.
  double max_filling_fraction = 0.42;
  /// Free space in the frame of the scan. Only used if the ground is given.
  const FreeSpaceGrid* free_space = nullptr;
  /// Returns true if a position on the open surface was scanned, and false on the fillings of small
  /// holes. If empty, the whole surface was scanned.
  std::function<bool(const Vec3&)> is_observed = {};
  double unit = 1.0;  ///< m per unit of the mesh, for lengths in notes
  /// Uncertainty of the open surface. Null if it is exact.
  const SurfaceUncertainty* uncertainty = nullptr;

  void check() const;  ///< throws InputError naming the field and its value
};

/// Scan whose underside is closed in two ways, with volume bounds. Both meshes have the same
/// triangles, outward.
struct Underside : VolumeBracket {
  TriangleMesh lower_mesh;  ///< closed by membranes across the rims
  TriangleMesh best_estimate;
  std::size_t open_sides = 1;      ///< number of unobserved sides, which are bracketed together
  std::size_t first_filling = 0;   ///< index of the first filling triangle in both meshes
  Vec3 down = -Vec3::UnitZ();      ///< outward direction of the filling of the largest hole
  Vec3 rim_centre = Vec3::Zero();  ///< centre of the rim of the largest hole, m
  std::size_t rim_edges = 0;
  double rim_length = 0.0;        ///< m
  double ground_clearance = 0.0;  ///< height of the rim above the ground, m; 0 without ground
  std::vector<std::string> notes;
};

/// Closes the largest hole of a scan as the underside of a block and the others by flat membranes.
/// Computes volume bounds for all of them together. Holes below 0.3 % of the surface are treated as
/// observed.
///
/// The upper volume includes the space between the closed holes and the flank planes
/// (`fit_flank_planes`). Space below a known ground and free space are excluded. There is no upper
/// volume if it would exceed the observed volume by more than a third (above a ground: by more than
/// 100 %). The lower volume is that of `lower_mesh` minus possible indentations of the fillings.
/// Best estimate: docs/theory.md; measurements: docs/accuracy.md.
/// @param open  oriented 2-manifold of one component; may have small holes
/// @returns empty if no hole is large enough, so that the scan is practically closed
/// @throws GeometryError  if `open` is not an oriented manifold, is a sheet, or has a rim that
///                        cannot be filled; states size and position of the hole
/// @cite schneider2014
std::optional<Underside> close_underside(const TriangleMesh& open,
                                         const UndersideOptions& options = {});

}  // namespace clast
