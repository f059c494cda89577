#include "terrain/raw_surface.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "mesh/sub_mesh.hpp"

namespace clast::terrain_detail {

TriangleMesh triangulate_grid(const HeightGrid& grid, const std::filesystem::path& path) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  if (grid.heights.size() >= kNone) {
    throw InputError(path.string() + ": " + std::to_string(grid.heights.size()) +
                     " cells are too many; reduce the area or use `resolution`");
  }
  TriangleMesh mesh;
  std::vector<std::uint32_t> number(grid.heights.size(), kNone);
  const auto vertex = [&](std::size_t column, std::size_t row) {
    const std::size_t cell = row * grid.columns + column;
    if (number[cell] == kNone) {
      number[cell] = static_cast<std::uint32_t>(mesh.vertices.size());
      const Vec2 centre = grid.centre(column, row);
      mesh.vertices.emplace_back(centre.x(), centre.y(), grid.heights[cell]);
    }
    return number[cell];
  };
  const auto known = [&](std::size_t column, std::size_t row) {
    return std::isfinite(grid.heights[row * grid.columns + column]);
  };
  for (std::size_t j = 0; j + 1 < grid.rows; ++j) {
    for (std::size_t i = 0; i + 1 < grid.columns; ++i) {
      if (!known(i, j) || !known(i + 1, j) || !known(i + 1, j + 1) || !known(i, j + 1)) continue;
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j);
      const std::uint32_t c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      if ((i + j) % 2 == 0) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  }
  if (mesh.triangles.empty()) {
    throw InputError(path.string() + ": no 2 x 2 neighbouring cells have heights (" +
                     std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
                     " cells); a surface needs at least four");
  }
  return mesh;
}

void retain_triangles(RawSurface& surface, const std::vector<bool>& keep) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (keep[t]) surface.source_file[kept++] = surface.source_file[t];
  }
  surface.source_file.resize(kept);
  surface.mesh = extract_triangles(surface.mesh, keep);
}

}  // namespace clast::terrain_detail
