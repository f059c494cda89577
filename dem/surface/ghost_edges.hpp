#pragma once
/// Normal cones of edges and vertices. A contact at an edge or a vertex is real only if its normal
/// lies in the normal cone there; without that test a block that slides over a flat mesh is hit by
/// its inner edges, the ghost edges (docs/theory.md, No ghost edges).
#include "dem/surface/surface_features.hpp"

namespace clast::dem_detail {

/// True when `direction` points out of the solid at the edge: within the arc between the normals
/// of its faces (to 1e-9).
bool is_in_normal_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge, const Vec3& direction);
/// The same, and beyond it 3 degrees where the edge's faces stand at a right angle and nothing
/// where they are smooth. Where a flat face of one body lies partly over another, the edges that
/// bound the overlap then carry their share whichever way the two are tilted a little.
bool is_near_normal_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge, const Vec3& direction);

/// How far beyond the arc or the cone `is_near_normal_arc` and `is_near_normal_cone` go, a sine.
double normal_arc_slack(const SurfaceFeatures& surface, const SurfaceEdge& edge);
double normal_cone_slack(const SurfaceFeatures& surface, std::uint32_t vertex);

/// True when no edge leaving the vertex rises along `direction`, and it points out of the solid: it
/// lies in the normal cone.
bool is_in_normal_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction);
/// The same with such a slack, from the largest angle between the vertex's faces and its normal.
bool is_near_normal_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction);

}  // namespace clast::dem_detail
