#pragma once
/// Normal cones of edges and vertices. A contact at an edge or vertex is valid only if its normal
/// lies in the normal cone. Otherwise, blocks that slide over a flat mesh would collide with its
/// inner edges, called ghost edges.
#include "dem/surface/surface_features.hpp"

namespace clast::dem_detail {

/// True if `direction` is in the normal arc of an edge, between the normals of its faces.
bool is_in_normal_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge,
                      const Vec3& direction);
/// True if `direction` is in the normal arc of an edge, within a tolerance. The tolerance grows
/// with the angle between the two face normals: zero for coplanar faces, 3 degrees at a right
/// angle. It keeps edges in contact when two flat faces tilt slightly.
bool is_near_normal_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge,
                        const Vec3& direction);

/// Returns the sine of the angle by which a direction may lie outside the normal arc of an edge.
double normal_arc_slack(const SurfaceFeatures& surface, const SurfaceEdge& edge);
double normal_cone_slack(const SurfaceFeatures& surface, std::uint32_t vertex);

/// True if `direction` is in the normal cone of a vertex: it points out of the solid, and no edge
/// leaving the vertex rises along it.
bool is_in_normal_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction);
/// True if `direction` is in the normal cone of a vertex, within a tolerance. The tolerance grows
/// with the largest angle between the vertex normal and the normals of the adjacent faces.
bool is_near_normal_cone(const SurfaceFeatures& surface, std::uint32_t vertex,
                         const Vec3& direction);

}  // namespace clast::dem_detail
