#pragma once
/// Two surfaces over one division of the plan, and the closed bodies between them.
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "terrain/gdal/zone_polygons.hpp"

namespace clast::terrain_detail {

/// Two heights at every vertex of one triangulation of the plan, both linear on each triangle.
struct SurfaceOverlay {
  std::vector<Vec2> plan;                         ///< m
  std::vector<double> top, base;                  ///< of every vertex, m
  std::vector<TriangleMesh::Triangle> triangles;  ///< counter-clockwise from above

  double thickness(std::uint32_t vertex) const { return top[vertex] - base[vertex]; }
};

/// The common division of two surfaces: each is on every triangle what it was, as edges of the
/// coarser one become edges of the finer one; these of outlines too. It holds all triangles with a
/// place where `top` is more than `thickness` above `base`, and some of those around. Heights are
/// exact but for edges closer than a micrometre, which are joined. Triangles that stand upright or
/// overhang are left out; at a step of a surface, triangles on either side have vertices of their
/// own.
/// @param outlines  in the frame of the meshes: what lies outside of all is left out; none: all
///                  counts
SurfaceOverlay overlay_surfaces(const TriangleMesh& top, const TriangleMesh& base, double thickness,
                                std::span<const ZonePolygon> outlines);

/// The least and the greatest height of one surface above another, with their places.
struct HeightDifferenceRange {
  double low = 1e300, high = -1e300;  ///< m; `low` exceeds `high` where they share no place
  Vec3 low_position = Vec3::Zero(), high_position = Vec3::Zero();  ///< on the upper surface
};
HeightDifferenceRange height_difference_range(const TriangleMesh& top, const TriangleMesh& base);

/// A closed body between two surfaces.
struct OverlayBody {
  TriangleMesh mesh;  ///< outward; the triangles of its top are the first ones
  std::size_t top_triangles = 0;
  double plan_area = 0.0;             ///< m^2
  double max_thickness = 0.0;         ///< m
  double max_wall_height = 0.0;       ///< m
  Vec3 wall_position = Vec3::Zero();  ///< top of the highest wall
};

/// The bodies where the top is more than `thickness` above the base, connected over edges in plan.
/// At their outline, where the thickness is `thickness`, they have upright walls of that height;
/// none when it is 0: top and base meet there. Where the pair ends, walls are as high as the body.
/// The volume is the integral of the thickness over the plan.
std::vector<OverlayBody> extract_bodies_between(const SurfaceOverlay& pair, double thickness);

}  // namespace clast::terrain_detail
