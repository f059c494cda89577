#pragma once
/// Normal cones of edges and vertices. A contact at an edge or vertex is valid only if its normal
/// lies in the normal cone; otherwise blocks sliding over a flat mesh would collide with its inner
/// edges, the ghost edges (docs/theory.md, No ghost edges).
#include "dem/surface/surface_features.hpp"

namespace clast::dem_detail {

/// True if `direction` is in the normal arc of an edge, between the normals of its faces (to 1e-9).
bool is_in_normal_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge,
                      const Vec3& direction);
/// True if `direction` is in the normal arc extended by a slack of up to 3 degrees, largest for
/// right-angled edges and zero for smooth ones. The edges that bound a partial overlap of flat
/// faces then carry load for both directions of a slight tilt.
bool is_near_normal_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge,
                        const Vec3& direction);

/// Returns the slack of `is_near_normal_arc` and `is_near_normal_cone`, as a sine.
double normal_arc_slack(const SurfaceFeatures& surface, const SurfaceEdge& edge);
double normal_cone_slack(const SurfaceFeatures& surface, std::uint32_t vertex);

/// True if `direction` is in the normal cone of a vertex: no edge leaving it rises along
/// `direction`, and it points out of the solid.
bool is_in_normal_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction);
/// True if `direction` is in the normal cone extended by a slack, from the largest angle between
/// its faces and its normal.
bool is_near_normal_cone(const SurfaceFeatures& surface, std::uint32_t vertex,
                         const Vec3& direction);

}  // namespace clast::dem_detail
