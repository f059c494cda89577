#pragma once
/// Terrain surface as read: map coordinates, z up.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

struct RawSurface {
  TriangleMesh mesh;
  std::vector<std::uint16_t> source_file;  ///< per triangle: index of the surface file
  std::string crs;
  std::vector<std::string> notes;
  double cell = 0.0;  ///< smaller cell size of its grid, m; 0 for meshes
};

/// Removes all triangles that are not marked in `keep`, and vertices without triangles.
/// @pre one flag per triangle
void retain_triangles(RawSurface& surface, const std::vector<bool>& keep);

/// Height grid, row-major from the south; NaN where unknown.
struct HeightGrid {
  std::size_t columns = 0;
  std::size_t rows = 0;
  Vec2 first_centre = Vec2::Zero();  ///< centre of the south-west cell
  Vec2 cell_size = Vec2::Ones();     ///< cell size, m, both positive
  std::vector<double> heights;

  Vec2 centre(std::size_t column, std::size_t row) const {
    return {first_centre.x() + cell_size.x() * static_cast<double>(column),
            first_centre.y() + cell_size.y() * static_cast<double>(row)};
  }
};

/// Triangulates a height grid. Any four adjacent cell centres with heights are joined by two
/// triangles. Diagonals alternate to avoid a directional bias.
/// @throws InputError  if there are no such four cells; the message names `path`
TriangleMesh triangulate_grid(const HeightGrid& grid, const std::filesystem::path& path);

}  // namespace clast::terrain_detail
