#pragma once
/// Layer between a core polyhedron and its rounded surface, decomposed into convex pieces whose
/// moments are known in closed form.
#include <vector>

#include "massprops/moments.hpp"

namespace clast::massprops_detail {

/// Half-space n . x <= d.
struct HalfSpace {
  Vec3 normal;
  double offset;
};

/// Convex piece: intersection of half-spaces, and optionally of a sphere or cylinder.
struct OffsetPiece {
  enum class CurvedFace { none, sphere, cylinder };
  CurvedFace curved_face = CurvedFace::none;
  Vec3 centre = Vec3::Zero();  ///< centre of the sphere, or a point on the axis of the cylinder
  Vec3 axis = Vec3::Zero();    ///< axis of the cylinder, unit
  std::vector<HalfSpace> planes;
  Bounds box;
};

/// Layer between a core and its rounded surface, as convex pieces: a prism on each face, a wedge on
/// each convex edge, and a spherical sector in the normal cone of each vertex.
///
/// The union of core and pieces is the rounded body, for any core. For a convex core the pieces are
/// disjoint; `piece_moments` plus the core's moments is then exact. At reflex edges, pieces
/// overlap. `overlaps` are the prisms in which the two face prisms of a reflex edge overlap, if
/// they are clear of the far edges of these faces.
struct OffsetLayer {
  double radius = 0.0;
  std::vector<OffsetPiece> pieces;
  SolidMoments piece_moments;  ///< sum over all pieces; overlaps are counted more than once
  std::vector<OffsetPiece> overlaps;
  SolidMoments overlap_moments;
  double area = 0.0;             ///< sum of the outer areas of the pieces, m^2
  double overlap_area = 0.0;     ///< outer area lost to `overlaps`, m^2
  double solid_angle = 0.0;      ///< sum over all normal cones; 4 pi if the core is convex
  bool has_reflex_edge = false;  ///< by more than 1e-9 rad, or with an undefined angle
};

/// Decomposes the layer between a core and its rounded surface into convex pieces.
/// @param core  closed, consistently oriented, with an origin near its centre
/// @param clear_radius  radius, at least `radius`, for which overlaps must be clear of the far
///                      edges; radii with a common value have overlaps at the same edges
OffsetLayer decompose_offset_layer(const TriangleMesh& core, double radius, double clear_radius);

}  // namespace clast::massprops_detail
