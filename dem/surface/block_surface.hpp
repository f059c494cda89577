#pragma once
/// Surface of a block with precomputed data for contact searches.
#include "dem/surface/block_parts.hpp"
#include "dem/surface/feature_groups.hpp"
#include "dem/surface/local_ground.hpp"

namespace clast::dem_detail {

/// Possible contact normals of an edge: the arc between the normals of its two faces, extended by a
/// small angle.
struct EdgeNormalArc {
  EdgeNormalArc() = default;
  EdgeNormalArc(const SurfaceFeatures& surface, const SurfaceEdge& edge);
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();  ///< unit normals of the faces of the edge
  double slack = 0.0;  ///< angle by which the arc is extended, as a sine
  /// True for an edge without two faces, which can have any contact normal.
  bool is_unbounded = false;
};

/// Surface of a block shape, with precomputed data for contact searches. All contact pairs share
/// it.
struct BlockSurface : IndexedSurface {
  explicit BlockSurface(const SpheroPolyhedron& body);
  BlockParts parts;
  FeatureGroups groups;
  // All of them, by number.
  std::vector<LocalFaces::Face> local_faces;
  std::vector<EdgeNormalArc> edge_normal_arcs;  ///< possible contact normals of each edge
  /// Angular tolerance of the normal cone of each vertex, as a sine.
  std::vector<double> cone_slacks;
  double bounding_radius = 0.0;  ///< radius of the rounded block about its origin, m
};

}  // namespace clast::dem_detail
