#pragma once
/// The side of a block that nobody saw: how large and how small the block may be, and the best
/// guess.
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

/// What is known and what is supposed of an underside.
struct UndersideOptions {
  /// The ground that the block lies on, normal up. It bounds the block from below only if space was
  /// seen to be free under more than half of it. If none is given, the rim faces down.
  std::optional<Plane> ground = {};
  /// Depth of the best guess below the rim, as a fraction of the height that was seen: a quarter of
  /// the whole height by default. It bounds nothing.
  double max_depth_fraction = 1.0 / 3.0;
  /// A hole whose flat filling has less than this share of the closed surface is left alone.
  double smallest_share = 0.001;
  /// ... and with more the scan is a sheet and no block: half a ball has a third.
  double largest_share = 0.42;
  /// Space that was looked through, in the frame of the scan: above the ground that is given, no
  /// rock is there.
  const FreeSpaceGrid* free_space = nullptr;
  /// Whether a place on the open surface was scanned; what was not is a filling of
  /// small holes. None: all of it was.
  std::function<bool(const Vec3&)> is_observed = {};
  double unit = 1.0;  ///< m per unit of the mesh, for the lengths of notes
  /// How well the open surface is known; null: it is exact.
  const SurfaceUncertainty* uncertainty = nullptr;

  void check() const;  ///< throws InputError naming the field and its value
};

/// A scan closed in two ways, and bounds beyond that. Both meshes are closed and outward, with the
/// same triangles; the filling of the largest hole is moved down in `best_estimate`. The lower
/// volume is that of `lower_mesh`, less what its filling may be dented as the seen surface is.
struct Underside : VolumeBracket {
  TriangleMesh lower_mesh;  ///< filled straight across the rims (membranes)
  TriangleMesh best_estimate;
  std::size_t open_sides = 1;      ///< holes that are bracketed, together
  std::size_t first_filling = 0;   ///< triangles from this one on are filling, in both
  Vec3 down = -Vec3::UnitZ();      ///< the way the filling of the largest hole faces
  Vec3 rim_centre = Vec3::Zero();  ///< of the largest hole, m
  std::size_t rim_edges = 0;
  double rim_length = 0.0;        ///< m
  double ground_clearance = 0.0;  ///< of the rim above the ground, m; 0 without a ground
  std::vector<std::string> notes;
};

/// Closes the largest hole of a scan as an underside, and the others flat, and brackets them
/// together; those below 0.3 % of the surface are closed flat and count as seen.
///
/// Of a convex body every tangent plane of the seen surface has all of it on one side, also the
/// unseen part: the upper volume fills the space between the closures and these planes, moved out
/// by what the seen surface stands out over its own tangent planes, down to the ground where one is
/// known. Where it is known what was looked through, the upper volume is no larger than all that
/// was not. Where that leaves more than a third as much again as was seen (as much again above a
/// ground), there is no upper volume. See docs/theory.md for the best guess, and
/// docs/benchmarks.md for what was measured.
///
/// @param open  oriented 2-manifold in one component; small holes may be left
/// @returns none where no hole is large enough: the scan is closed, or nearly
/// @throws GeometryError  not an oriented manifold; a sheet; or a rim that can't be filled. The
///                        message says how large and where the hole is
/// @cite schneider2014
std::optional<Underside> close_underside(const TriangleMesh& open,
                                         const UndersideOptions& options = {});

}  // namespace clast
