#include "dem/surface/ghost_edges.hpp"

#include <algorithm>

namespace clast::dem_detail {
namespace {

/// Tolerance of the arc and cone tests, as a sine.
constexpr double kConeSlack = 1e-9;
/// Slack at an edge or vertex, as a fraction of the distance between its unit normals. It is 3
/// degrees at a right angle, the tilt of a block at the settled depth.
constexpr double kGiveFraction = 0.037;
/// Largest slack, for opposite normals. It is computed only for directions closer to the limit.
constexpr double kMaxGive = 2.0 * kGiveFraction;

double give_of(const Vec3& normal, const Vec3& other) {
  return kGiveFraction * (normal - other).norm();
}

bool within_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge, const Vec3& direction,
                double slack) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (edge.faces[i] == kNoFeature) return true;
    const SurfaceFace& face = surface.faces[edge.faces[i]];
    if (direction.dot(inward_direction(face, edge.direction, edge.forward[i])) > slack)
      return false;
  }
  return true;
}

bool within_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction,
                 double slack) {
  for (const std::uint32_t e : surface.edges_at(vertex)) {
    if (direction.dot(surface.edge_direction_from(e, vertex)) > slack) return false;
  }
  // At the bottom of a pit, the test of the edges also accepts directions into the solid. The
  // angle-weighted normal excludes them (Baerentzen & Aanaes 2005).
  return !(direction.dot(surface.vertex_normals[vertex]) < 0.0);
}

}  // namespace

bool is_in_normal_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge,
                      const Vec3& direction) {
  return within_arc(surface, edge, direction, kConeSlack);
}

double normal_arc_slack(const SurfaceFeatures& surface, const SurfaceEdge& edge) {
  if (edge.kind != EdgeKind::kConvex) return kConeSlack;
  return kConeSlack +
         give_of(surface.faces[edge.faces[0]].normal, surface.faces[edge.faces[1]].normal);
}

bool is_near_normal_arc(const SurfaceFeatures& surface, const SurfaceEdge& edge,
                        const Vec3& direction) {
  if (is_in_normal_arc(surface, edge, direction)) return true;
  if (edge.kind != EdgeKind::kConvex ||
      !within_arc(surface, edge, direction, kConeSlack + kMaxGive)) {
    return false;
  }
  return within_arc(surface, edge, direction, normal_arc_slack(surface, edge));
}

bool is_in_normal_cone(const SurfaceFeatures& surface, std::uint32_t vertex,
                       const Vec3& direction) {
  return within_cone(surface, vertex, direction, kConeSlack);
}

double normal_cone_slack(const SurfaceFeatures& surface, std::uint32_t vertex) {
  double extra_slack = 0.0;
  for (const std::uint32_t e : surface.edges_at(vertex)) {
    for (const std::uint32_t f : surface.edges[e].faces) {
      if (f == kNoFeature) continue;
      extra_slack = std::max(
          extra_slack, 2.0 * give_of(surface.vertex_normals[vertex], surface.faces[f].normal));
    }
  }
  return kConeSlack + extra_slack;
}

bool is_near_normal_cone(const SurfaceFeatures& surface, std::uint32_t vertex,
                         const Vec3& direction) {
  if (is_in_normal_cone(surface, vertex, direction)) return true;
  if (!within_cone(surface, vertex, direction, kConeSlack + 2.0 * kMaxGive)) return false;
  return within_cone(surface, vertex, direction, normal_cone_slack(surface, vertex));
}

}  // namespace clast::dem_detail
