#pragma once
/// Ground as read, before it is checked: map coordinates, z up.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

struct RawSurface {
  TriangleMesh mesh;
  std::vector<std::uint16_t> source;  ///< of every triangle, index of the surface file
  std::string crs;
  std::vector<std::string> notes;
  double cell = 0.0;  ///< of the grid it was made from, the shorter side, m; 0 for meshes
};

/// Drops the other triangles and vertices that nothing uses then.
/// @pre one flag for each triangle
void retain_triangles(RawSurface& surface, const std::vector<bool>& keep);

/// Heights on a regular grid, row by row from the south, NaN where unknown.
struct HeightGrid {
  std::size_t columns = 0;
  std::size_t rows = 0;
  Vec2 first = Vec2::Zero();  ///< centre of the south-west cell
  Vec2 step = Vec2::Ones();   ///< cell size, m, both positive
  std::vector<double> heights;

  Vec2 centre(std::size_t column, std::size_t row) const {
    return {first.x() + step.x() * static_cast<double>(column),
            first.y() + step.y() * static_cast<double>(row)};
  }
};

/// Two triangles between any four neighbouring cell centres that all have a height. Diagonals
/// alternate, so that the surface has no grain.
/// @throws InputError  no such four cells; the message is about `path`
TriangleMesh triangulate_grid(const HeightGrid& grid, const std::filesystem::path& path);

}  // namespace clast::terrain_detail
