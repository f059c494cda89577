#pragma once
/// Surface of a block with precomputed data for contact searches.
#include "dem/surface/block_parts.hpp"
#include "dem/surface/feature_groups.hpp"
#include "dem/surface/local_ground.hpp"

namespace clast::dem_detail {

/// Arc of contact normals of an edge: between its face normals, and slightly beyond
/// (`is_near_normal_arc`).
struct EdgeNormalArc {
  EdgeNormalArc() = default;
  EdgeNormalArc(const SurfaceFeatures& surface, const SurfaceEdge& edge);
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();  ///< unit normals of its faces
  double slack = 0.0;                                ///< sine
  bool is_unbounded = false;  ///< true for an edge without two faces, which has any normal
};

/// Block surface, one per shape, shared by all its pairs to save cache memory.
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
