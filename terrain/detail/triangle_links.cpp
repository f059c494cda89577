#include "terrain/detail/triangle_links.hpp"

#include <algorithm>
#include <tuple>

namespace clast::terrain_detail {
namespace {

/// A side of a triangle, filed under the lower of its two vertices.
struct Side {
  std::uint32_t high;
  std::uint32_t triangle;
  std::uint32_t side;
};

}  // namespace

TriangleLinks triangle_links(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> offsets(mesh.vertices.size() + 1, 0);
  const auto each_side = [&](const auto& visit) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
        visit(std::min(a, b), Side{std::max(a, b), t, k});
      }
    }
  };
  each_side([&](std::uint32_t low, const Side&) { ++offsets[low + 1]; });
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) offsets[v + 1] += offsets[v];
  std::vector<Side> sides(offsets.back());
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  each_side([&](std::uint32_t low, const Side& side) { sides[next[low]++] = side; });

  TriangleLinks links;
  links.across.assign(mesh.triangles.size(), {kNoTriangle, kNoTriangle, kNoTriangle});
  for (std::uint32_t low = 0; low < mesh.vertices.size(); ++low) {
    const auto first = sides.begin() + offsets[low], last = sides.begin() + offsets[low + 1];
    std::sort(first, last, [](const Side& a, const Side& b) {
      return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
    });
    for (auto begin = first, end = first; begin != last; begin = end) {
      while (end != last && end->high == begin->high) ++end;
      if (end - begin == 1) {
        ++links.border_edges;
      } else if (end - begin == 2) {
        links.across[begin->triangle][begin->side] = begin[1].triangle;
        links.across[begin[1].triangle][begin[1].side] = begin->triangle;
      } else if (links.crowded_edges++ == 0) {
        links.crowded_at = (mesh.vertices[low] + mesh.vertices[begin->high]) / 2.0;
      }
    }
  }
  return links;
}

std::vector<std::uint32_t> pieces_of(const TriangleMesh& mesh, const TriangleLinks& links) {
  std::vector<std::uint32_t> piece(mesh.triangles.size(), kNoTriangle);
  std::vector<std::uint32_t> open;
  std::uint32_t count = 0;
  for (std::uint32_t seed = 0; seed < piece.size(); ++seed) {
    if (piece[seed] != kNoTriangle) continue;
    piece[seed] = count;
    open.assign(1, seed);
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (const std::uint32_t other : links.across[t]) {
        if (other == kNoTriangle || piece[other] != kNoTriangle) continue;
        piece[other] = count;
        open.push_back(other);
      }
    }
    ++count;
  }
  return piece;
}

std::size_t side_between(const TriangleMesh::Triangle& triangle, std::uint32_t a, std::uint32_t b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
    if ((from == a && to == b) || (from == b && to == a)) return k;
  }
  return 3;
}

Vec3 area_vector(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
}

Vec3 centroid(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
}

double median_edge(const TriangleMesh& mesh) {
  std::vector<double> lengths;
  lengths.reserve(3 * mesh.triangles.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      lengths.push_back((mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]).norm());
    }
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace clast::terrain_detail
