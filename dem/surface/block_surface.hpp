#pragma once
/// Surface of a block with precomputed data for contact searches.
#include "dem/surface/block_parts.hpp"
#include "dem/surface/feature_groups.hpp"
#include "dem/surface/local_ground.hpp"

namespace clast::dem_detail {

/// Arc of possible contact normals of an edge, between the normals of its two faces. It is extended
/// by a small slack (`is_near_normal_arc`).
struct EdgeNormalArc {
  EdgeNormalArc() = default;
  EdgeNormalArc(const SurfaceFeatures& surface, const SurfaceEdge& edge);
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();  ///< unit normals of its faces
  double slack = 0.0;                                ///< angular extension of the arc, as a sine
  bool is_unbounded = false;  ///< true for an edge without two faces, which has any normal
};

/// Surface of a block shape. All contact pairs of the shape share one, to save cache memory.
struct BlockSurface : IndexedSurface {
  explicit BlockSurface(const SpheroPolyhedron& body);
  BlockParts parts;
  FeatureGroups groups;
  // All of them, by number.
  std::vector<LocalFaces::Face> local_faces;
  std::vector<EdgeNormalArc> edge_normal_arcs;  ///< normal arc of each edge
  std::vector<double> cone_slacks;  ///< slack of the normal cone of each vertex, as a sine
  double bounding_radius = 0.0;     ///< of the rounded block about its origin, m
};

}  // namespace clast::dem_detail
