#pragma once
/// Checked terrain with ground zones and map position.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dem/surface/terrain_surface.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Map position of the local frame: map = local + origin. The local origin is near the terrain, so
/// that no precision is lost by large map coordinates.
struct MapFrame {
  Vec3 origin = Vec3::Zero();  ///< m
  std::string crs;             ///< "EPSG:2154" or WKT; empty if unknown

  Vec3 to_local(const Vec3& map) const { return map - origin; }
  Vec3 to_map(const Vec3& local) const { return local + origin; }
};

/// Numbers of defects and repairs of a terrain's input.
struct TerrainReport {
  std::size_t triangles_read = 0;
  std::size_t welded_vertices = 0;
  std::size_t removed_degenerate = 0;
  std::size_t removed_duplicates = 0;
  std::size_t flipped_triangles = 0;   ///< triangles whose normal pointed down
  std::size_t closed_cracks = 0;       ///< border vertices moved onto an adjacent border
  std::size_t filled_holes = 0;        ///< filled holes of a mesh or of a cloud's grid
  std::size_t open_holes = 0;          ///< holes of a mesh that were too large to fill
  std::size_t levelled_spikes = 0;     ///< levelled vertices, including pits
  std::size_t removed_components = 0;  ///< small components that overlapped other ground
  std::size_t slivers = 0;             ///< triangles with a height below 1 mm, kept
  std::size_t boundary_edges = 0;      ///< edges at the outer border and at holes
  std::size_t components = 0;
  std::vector<std::string> notes;  ///< sentences with counts and positions
};

/// Terrain surface in the local frame, z up. Triangle normals point out of the ground.
struct Terrain {
  TriangleMesh surface;
  std::vector<std::uint16_t> zone;  ///< per triangle: index into zone_names
  std::vector<std::string> zone_names;
  MapFrame frame;
  TerrainReport report;
  std::vector<std::string> sources;  ///< "path sha256" of each input file
};

/// Makes the terrain surface with which simulated blocks collide, `radius` (m) above the triangles.
TerrainSurface make_terrain_surface(const Terrain& terrain, double radius = 0.0);

}  // namespace clast
