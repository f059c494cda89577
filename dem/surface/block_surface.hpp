#pragma once
/// The surface of a block with what every contact search needs of it.
#include "dem/surface/block_parts.hpp"
#include "dem/surface/feature_groups.hpp"
#include "dem/surface/local_ground.hpp"

namespace clast::dem_detail {

/// Along which normals an edge may touch: those between the normals of its faces, and a little
/// beyond (`is_near_normal_arc`).
struct EdgeNormalArc {
  EdgeNormalArc() = default;
  EdgeNormalArc(const SurfaceFeatures& surface, const SurfaceEdge& edge);
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();  ///< normals of its faces, unit
  double slack = 0.0;                                ///< a sine
  bool is_unbounded = false;                         ///< along any: an edge without two faces
};

/// One per shape: in a pile thousands of pairs refer to a few of these, so that they stay in the
/// caches.
struct BlockSurface : IndexedSurface {
  explicit BlockSurface(const SpheroPolyhedron& body);
  BlockParts parts;
  FeatureGroups groups;
  // All of them, by number.
  std::vector<LocalFaces::Face> local_faces;
  std::vector<EdgeNormalArc> arcs;  ///< of the edges
  std::vector<double> cone_slacks;  ///< of the vertices, sines
  double bounding_radius = 0.0;     ///< of the rounded block about its origin, m
};

}  // namespace clast::dem_detail
