#pragma once
/// Overlay of two terrain surfaces, and the closed bodies between them.
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "terrain/gdal/zone_polygons.hpp"

namespace clast::terrain_detail {

/// Two surfaces on a common triangulation in plan view, with both heights at each vertex.
struct SurfaceOverlay {
  std::vector<Vec2> plan;                         ///< m
  std::vector<double> top, base;                  ///< heights per vertex, m
  std::vector<TriangleMesh::Triangle> triangles;  ///< counter-clockwise from above

  double thickness(std::uint32_t vertex) const { return top[vertex] - base[vertex]; }
};

/// Computes the overlay of two surfaces. The edges of both surfaces and of the outlines become
/// edges of the overlay, so that both surfaces are plane on each of its triangles. It covers the
/// area where `top` is more than `thickness` above `base`, and some triangles around it. Edges
/// closer than a micrometre are merged. Vertical and overhanging triangles are omitted. At steps,
/// adjacent triangles have separate vertices.
/// @param outlines  polygons outside which the overlay is omitted, in the frame of the meshes; if
///                  empty, nothing is omitted
SurfaceOverlay overlay_surfaces(const TriangleMesh& top, const TriangleMesh& base, double thickness,
                                std::span<const ZonePolygon> outlines);

/// Smallest and largest height difference (top minus base) of two surfaces, with their positions.
struct HeightDifferenceRange {
  double low = 1e300, high = -1e300;  ///< m; `low` exceeds `high` if the surfaces do not overlap
  Vec3 low_position = Vec3::Zero(), high_position = Vec3::Zero();  ///< on the upper surface
};
HeightDifferenceRange height_difference_range(const TriangleMesh& top, const TriangleMesh& base);

/// Closed body between two surfaces.
struct BodyBetweenSurfaces {
  TriangleMesh mesh;  ///< outward-facing; the triangles of the top come first
  std::size_t top_triangles = 0;
  double plan_area = 0.0;             ///< m^2
  double max_thickness = 0.0;         ///< m
  double max_wall_height = 0.0;       ///< m
  Vec3 wall_position = Vec3::Zero();  ///< top of the highest wall
};

/// Extracts the bodies between two surfaces where the top is more than `thickness` above the base.
/// A body is connected over edges of the overlay. It has vertical walls of height `thickness` along
/// its outline. At the border of the overlay, the walls are as high as the body. Its volume is the
/// integral of the vertical thickness over the plan.
std::vector<BodyBetweenSurfaces> extract_bodies_between(const SurfaceOverlay& pair,
                                                        double thickness);

}  // namespace clast::terrain_detail
