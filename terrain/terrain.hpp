#pragma once
/// A checked ground surface with zones and its place on the map.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dem/surface/terrain_surface.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Where local coordinates lie on the map: map = local + origin. Chosen so that the terrain is near
/// the local origin; large map coordinates lose no digits.
struct MapFrame {
  Vec3 origin = Vec3::Zero();  ///< m
  std::string crs;             ///< "EPSG:2154" or WKT; empty when the input names none

  Vec3 to_local(const Vec3& map) const { return map - origin; }
  Vec3 to_map(const Vec3& local) const { return local + origin; }
};

/// What was found in the input and repaired.
struct TerrainReport {
  std::size_t triangles_read = 0;
  std::size_t welded_vertices = 0;
  std::size_t removed_degenerate = 0;
  std::size_t removed_duplicates = 0;
  std::size_t flipped_triangles = 0;   ///< normals that pointed down
  std::size_t closed_cracks = 0;       ///< border vertices brought onto the border beside them
  std::size_t filled_holes = 0;        ///< of a mesh or a cloud's grid
  std::size_t open_holes = 0;          ///< of a mesh, wider than those
  std::size_t levelled_spikes = 0;     ///< single vertices, pits too
  std::size_t removed_components = 0;  ///< small ones that lay over other ground
  std::size_t slivers = 0;             ///< triangles lower than 1 mm, kept
  std::size_t boundary_edges = 0;      ///< outer border and holes
  std::size_t components = 0;
  std::vector<std::string> notes;  ///< each in words, with counts and places
};

/// Triangles with normals out of the ground, z up, in the local frame, each in a zone.
struct Terrain {
  TriangleMesh surface;
  std::vector<std::uint16_t> zone;  ///< of every triangle, index into zone_names
  std::vector<std::string> zone_names;
  MapFrame frame;
  TerrainReport report;
  std::vector<std::string> sources;  ///< "path sha256" of every input file
};

/// The surface the dynamics runs on.
TerrainSurface make_terrain_surface(const Terrain& terrain, double radius = 0.0);

}  // namespace clast
