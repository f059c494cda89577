#pragma once
/// Layer between a core polyhedron and its rounded surface, decomposed into convex pieces with
/// closed-form moments.
#include <vector>

#include "massprops/moments.hpp"

namespace clast::massprops_detail {

/// Half-space n . x <= d.
struct HalfSpace {
  Vec3 normal;
  double offset;
};

/// Convex piece: an intersection of half-spaces, optionally with a sphere or cylinder.
struct OffsetPiece {
  enum class CurvedFace { none, sphere, cylinder };
  CurvedFace round = CurvedFace::none;
  Vec3 centre = Vec3::Zero();  ///< of the sphere, or a point of the cylinder's axis
  Vec3 axis = Vec3::Zero();    ///< of the cylinder, unit
  std::vector<HalfSpace> planes;
  Bounds box;
};

/// Pieces of the layer: a prism on each face, a wedge on each convex edge, and a spherical sector
/// in the normal cone of each vertex.
///
/// Each point of the body outside the core lies in a piece, because its nearest core point is on a
/// face, edge or vertex with the point in its normal cone; the union of core and pieces is
/// therefore the body for any core. For convex cores the pieces are disjoint and `total` plus the
/// core's moments is exact. At reflex edges they overlap; `overlaps` are the kite-shaped prisms in
/// which the two face prisms of such an edge overlap, if they are clear of the far edges.
struct OffsetLayer {
  double radius = 0.0;
  std::vector<OffsetPiece> pieces;
  Moments piece_moments;  ///< sum over the pieces, with overlaps counted repeatedly
  std::vector<OffsetPiece> overlaps;
  Moments overlap_moments;
  double area = 0.0;             ///< outer area of the pieces, m^2
  double overlap_area = 0.0;     ///< outer area lost to `overlaps`, m^2
  double solid_angle = 0.0;      ///< of all normal cones; 4 pi when the core is convex
  bool has_reflex_edge = false;  ///< beyond 1e-9 rad, or an edge whose dihedral is undefined
};

/// Decomposes the layer.
/// @param core  closed, consistently oriented, about a local origin
/// @param clear_radius  radius for which overlaps must be clear of the far edges, at least
///                      `radius`; a common value gives several radii equal overlaps
OffsetLayer decompose_offset_layer(const TriangleMesh& core, double radius, double clear_radius);

}  // namespace clast::massprops_detail
