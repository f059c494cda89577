#pragma once
/// Closed bodies cut open, as a scan has them whose underside nobody saw.
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// What of `mesh` lies above z = `level`. Triangles that cross it are cut, so that the rim lies in
/// the plane; no vertex may lie in it.
inline TriangleMesh above_level(const TriangleMesh& mesh, double level) {
  TriangleMesh result;
  std::vector<std::uint32_t> number(mesh.vertices.size(), 0xffffffffu);
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> crossings;
  const auto above = [&](std::uint32_t v) { return mesh.vertices[v].z() > level; };
  const auto kept = [&](std::uint32_t v) {
    if (number[v] == 0xffffffffu) {
      number[v] = static_cast<std::uint32_t>(result.vertices.size());
      result.vertices.push_back(mesh.vertices[v]);
    }
    return number[v];
  };
  const auto crossing = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, fresh] = crossings.try_emplace(
        {std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(result.vertices.size()));
    if (fresh) {
      const Vec3 &p = mesh.vertices[std::min(a, b)], &q = mesh.vertices[std::max(a, b)];
      Vec3 point = p + (level - p.z()) / (q.z() - p.z()) * (q - p);
      point.z() = level;
      result.vertices.push_back(point);
    }
    return found->second;
  };
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    std::vector<std::uint32_t> corners;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (above(a)) corners.push_back(kept(a));
      if (above(a) != above(b)) corners.push_back(crossing(a, b));
    }
    for (std::size_t k = 2; k < corners.size(); ++k) {
      result.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
  }
  return result;
}

}  // namespace clast
