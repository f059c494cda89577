#pragma once
/// Who is next to whom on a triangle mesh.
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::terrain_detail {

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

/// The triangle across every side; side k runs from corner k to corner k + 1.
struct TriangleLinks {
  std::vector<std::array<std::uint32_t, 3>> across;  ///< kNoTriangle: border, or a crowded edge
  std::size_t border_edges = 0;
  std::size_t crowded_edges = 0;   ///< where more than two triangles meet
  Vec3 crowded_at = Vec3::Zero();  ///< middle of the first of them

  bool on_border(std::uint32_t triangle, std::size_t side) const {
    return across[triangle][side] == kNoTriangle;
  }
};

TriangleLinks triangle_links(const TriangleMesh& mesh);

/// For every triangle the number of its piece; pieces are joined over edges of two triangles.
std::vector<std::uint32_t> pieces_of(const TriangleMesh& mesh, const TriangleLinks& links);

/// The side of `triangle` whose corners are `a` and `b`, in either order; 3 when it has none.
std::size_t side_between(const TriangleMesh::Triangle& triangle, std::uint32_t a, std::uint32_t b);

/// Twice the area along the normal; of a triangle seen from above, z is twice its plan area.
Vec3 area_vector(const TriangleMesh& mesh, std::uint32_t triangle);

Vec3 centroid(const TriangleMesh& mesh, std::uint32_t triangle);

/// The median length of all edges, m.
double median_edge(const TriangleMesh& mesh);

}  // namespace clast::terrain_detail
