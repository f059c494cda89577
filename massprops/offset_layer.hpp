#pragma once
/// The layer between a core polyhedron and the surface of its rounded body, cut into convex pieces
/// whose moments are known in closed form.
#include <vector>

#include "massprops/moments.hpp"

namespace clast::massprops_detail {

/// n . x <= d.
struct HalfSpace {
  Vec3 normal;
  double offset;
};

/// A convex piece: half-spaces, cut by a sphere or a cylinder where `round` says so.
struct OffsetPiece {
  enum class CurvedFace { none, sphere, cylinder };
  CurvedFace round = CurvedFace::none;
  Vec3 centre = Vec3::Zero();  ///< of the sphere, or a point of the cylinder's axis
  Vec3 axis = Vec3::Zero();    ///< of the cylinder, unit
  std::vector<HalfSpace> planes;
  Bounds box;
};

/// Pieces of the layer: a prism on every face, a wedge on every convex edge, the part of a ball in
/// the normal cone of every vertex.
///
/// Every point of the body outside the core lies in a piece, since its nearest core point lies on a
/// face, an edge or a vertex with the point in the normal cone there; so the union of core and
/// pieces is the body whatever the core is like. Where the core is convex the pieces are disjoint
/// and `piece_moments` with the core's moments is exact. At reflex edges they overlap; `overlaps`
/// are the kite-shaped prisms in which the two face prisms of such an edge overlap, where those
/// stand clear of the far edges.
struct OffsetLayer {
  double radius = 0.0;
  std::vector<OffsetPiece> pieces;
  Moments piece_moments;  ///< sum over the pieces, overlaps counted more than once
  std::vector<OffsetPiece> overlaps;
  Moments overlap_moments;
  double area = 0.0;             ///< outer area of the pieces, m^2
  double overlap_area = 0.0;     ///< outer area lost to `overlaps`, m^2
  double solid_angle = 0.0;      ///< of all normal cones; 4 pi when the core is convex
  bool has_reflex_edge = false;  ///< beyond 1e-9 rad, or an edge whose dihedral is undefined
};

/// @param core          closed, consistently oriented, about a local origin
/// @param clear_radius  the radius for which overlaps must stand clear of the far edges, at least
///                      `radius`; the same for several radii gives all of them the same overlaps
OffsetLayer decompose_offset_layer(const TriangleMesh& core, double radius, double clear_radius);

}  // namespace clast::massprops_detail
