#pragma once
/// The side of a block that nobody saw: how large and how small the block may be, and the best
/// guess.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/seen_through.hpp"
#include "shapes/triangle_mesh.hpp"

namespace clast {

/// A plane, as n . p = d with the unit normal n.
struct Plane {
  Vec3 normal = Vec3::UnitZ();
  double distance = 0.0;  ///< m

  double height(const Vec3& point) const { return normal.dot(point) - distance; }
};

/// What is known and what is supposed of an underside.
struct UndersideOptions {
  /// The ground the block lies on, normal up. Where 95 % of the rim stand clear of it, the
  /// block has sunk into it by 5 % of its height at most; it may go as deep as `deepest` where 85 %
  /// and less do. None: a rim faces down, whichever way
  /// that is.
  std::optional<Plane> ground = {};
  /// At most this much is buried, as a share of the height that was seen: a quarter of the whole
  /// height by default. Not where the ground is known and the rim is clear of it.
  double deepest = 1.0 / 3.0;
  /// A hole whose flat filling has less than this share of the closed surface is left alone.
  double smallest_share = 0.001;
  /// ... and with more the scan is a sheet and no block: half a ball has a third.
  double largest_share = 0.42;
  /// Space that was looked through, in the frame of the scan: above the ground that is given, no
  /// rock is there.
  const SeenThrough* through = nullptr;

  void check() const;  ///< throws InputError naming the field and its value
};

/// A scan closed three ways. All are closed and outward; `lower` has the same vertices and
/// triangles as the others, whose filling is moved down.
struct Underside {
  TriangleMesh lower;  ///< filled straight across the rim (a soap film)
  TriangleMesh best;
  TriangleMesh upper;
  double lower_volume = 0.0;  ///< m^3
  double best_volume = 0.0;
  double upper_volume = 0.0;
  double invented_share = 0.0;     ///< filling's share of the area of `best`
  std::size_t first_invented = 0;  ///< triangles from this one on are filling, in all three
  Vec3 down = -Vec3::UnitZ();      ///< the way the filling faces
  Vec3 rim_centre = Vec3::Zero();  ///< m
  std::size_t rim_edges = 0;
  double rim_length = 0.0;  ///< m
  double gap = 0.0;         ///< of the rim above the ground, m; 0 without a ground
  std::vector<std::string> notes;
};

/// Closes the largest hole of a scan as an underside, and the others flat.
///
/// The bracket rests on the sections A(z) across the block. Of a convex body sqrt(A) is concave in
/// z (Brunn & Minkowski), so below the rim it lies under its tangent: the upper shape is the cone
/// with the section and the narrowing at the rim, no deeper than `deepest` (or than the ground).
/// Where it is known what was looked through, the upper volume is no larger than all that was not.
/// The lower shape ends at the rim. See docs/theory.md for the best guess and its error.
///
/// @param open  oriented 2-manifold in one piece; small holes may be left
/// @returns none where no hole is large enough: the scan is closed, or nearly
/// @throws GeometryError  not an oriented manifold; a sheet; or a rim that can't be filled. The
///                        message says how large and where the hole is
/// @cite schneider2014
std::optional<Underside> closed_underside(const TriangleMesh& open,
                                          const UndersideOptions& options = {});

}  // namespace clast
