#pragma once
/// Small grounds as files, and what is said when one is refused.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "core/error.hpp"
#include "mesh/mesh_io.hpp"
#include "terrain/terrain_input.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

inline std::string refusal(const TerrainOptions& options) {
  return refusal<Error>([&] { read_terrain(options); });
}

/// A plane that no symmetry of a grid hides: z over x and y on the map.
struct SlopedGround {
  double height = 100.0, slope_x = -0.37, slope_y = 0.21;
  double at(double x, double y) const { return height + slope_x * x + slope_y * y; }
};

/// Esri grid of `columns` x `rows` cells, north first, with the value that `value(x, y)` has at the
/// centre of each cell.
inline void write_asc(const std::filesystem::path& path, int columns, int rows, double west,
                      double south, double cell,
                      const std::function<double(double, double)>& value) {
  std::ofstream file(path);
  file.precision(17);
  file << "ncols " << columns << "\nnrows " << rows << "\nxllcorner " << west << "\nyllcorner "
       << south << "\ncellsize " << cell << "\nNODATA_value -9999\n";
  for (int j = rows - 1; j >= 0; --j) {
    for (int i = 0; i < columns; ++i) {
      file << value(west + cell * (i + 0.5), south + cell * (j + 0.5)) << ' ';
    }
    file << '\n';
  }
}

/// n x n squares of two triangles from (0, 0), all facing up.
inline TriangleMesh squares(int n, double cell, const std::function<double(double, double)>& z) {
  TriangleMesh mesh;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      mesh.vertices.emplace_back(cell * i, cell * j, z(cell * i, cell * j));
    }
  }
  const auto node = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      mesh.triangles.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
      mesh.triangles.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  }
  return mesh;
}

inline Vec3 normal_of(const Terrain& terrain, std::size_t triangle) {
  const auto& [a, b, c] = terrain.surface.triangles[triangle];
  const std::vector<Vec3>& v = terrain.surface.vertices;
  return (v[b] - v[a]).cross(v[c] - v[a]);
}

inline std::size_t facing_down(const Terrain& terrain) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < terrain.surface.triangles.size(); ++t) {
    if (!(normal_of(terrain, t).z() > 0.0)) ++count;
  }
  return count;
}

}  // namespace clast
