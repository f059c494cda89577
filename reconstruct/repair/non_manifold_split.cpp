#include "reconstruct/repair/non_manifold_split.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "core/disjoint_sets.hpp"
#include "mesh/triangle_geometry.hpp"

namespace clast::reconstruct_detail {

namespace {

using Triangle = TriangleMesh::Triangle;

constexpr int kCutRounds =
    8;  ///< a triangle is cut once in each, for at most three edges of its own

/// Pairs up the half-edges of an edge: adjacent ones with rock between them, then the rest.
std::vector<std::array<std::size_t, 2>> rock_pairs(const TriangleMesh& mesh,
                                                   std::span<const HalfEdge> sides) {
  const std::vector<Vec3> wing = triangle_directions_at_edge(mesh, sides);
  const Vec3 axis = (mesh.vertices[sides[0].high] - mesh.vertices[sides[0].low]).normalized();
  std::vector<std::pair<double, std::size_t>> around;
  for (std::size_t i = 0; i < wing.size(); ++i) {
    const double angle = std::atan2(axis.dot(wing[0].cross(wing[i])), wing[0].dot(wing[i]));
    around.emplace_back(angle, i);
  }
  std::sort(around.begin(), around.end());
  // The normal of a forward side points the way angles grow, so rock lies before it.
  std::vector<bool> paired(sides.size(), false);
  std::vector<std::array<std::size_t, 2>> pairs;
  const auto join = [&](std::size_t i, std::size_t j) {
    pairs.push_back({i, j});
    paired[i] = paired[j] = true;
  };
  for (std::size_t k = 0; k < around.size(); ++k) {
    const std::size_t i = around[k].second, j = around[(k + 1) % around.size()].second;
    if (!paired[i] && !paired[j] && !sides[i].is_forward && sides[j].is_forward) join(i, j);
  }
  for (const bool alike : {false, true}) {  // what is left, better those that agree
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t j = i + 1; j < sides.size(); ++j) {
        if (paired[i] || paired[j]) continue;
        if ((sides[i].is_forward == sides[j].is_forward) == alike) join(i, j);
      }
    }
  }
  return pairs;
}

/// Triangles that lie on one another meet anew at every edge that is cut: they are dropped.
void drop_touching(TriangleMesh& mesh, EdgeSplitResult& touching) {
  std::vector<bool> drop(mesh.triangles.size(), false);
  for_each_edge(sorted_half_edges(mesh), [&](std::span<const HalfEdge> sides) {
    if (sides.size() < 3) return;
    for (const HalfEdge& side : sides) drop[side.triangle] = true;
  });
  std::vector<std::uint32_t> source;
  for (std::size_t t = 0; t < drop.size(); ++t) {
    if (!drop[t]) source.push_back(touching.original_triangle[t]);
  }
  touching.original_triangle = std::move(source);
  touching.split.area = remove_triangles(mesh, drop).area;
}

/// Gives each group of corners at a vertex a vertex of its own; the group of the first corner keeps
/// the old one. Returns which vertices were split.
std::vector<bool> split_by_groups(TriangleMesh& mesh, const std::vector<std::uint32_t>& group) {
  std::vector<std::uint32_t> owner(mesh.vertices.size(), kNoIndex);
  std::vector<std::uint32_t> vertex_of_group(group.size(), kNoIndex);
  std::vector<bool> split(mesh.vertices.size(), false);
  for (std::uint32_t corner = 0; corner < group.size(); ++corner) {
    std::uint32_t& vertex = mesh.triangles[corner / 3][corner % 3];
    const std::uint32_t here = group[corner];
    if (owner[vertex] == kNoIndex) owner[vertex] = here;
    if (owner[vertex] == here) continue;
    if (vertex_of_group[here] == kNoIndex) {
      split[vertex] = true;
      vertex_of_group[here] = static_cast<std::uint32_t>(mesh.vertices.size());
      const Vec3 copy = mesh.vertices[vertex];
      mesh.vertices.push_back(copy);
    }
    vertex = vertex_of_group[here];
  }
  return split;
}

/// Cuts a triangle in two from the middle of a side, a vertex of the mesh, to the corner opposite.
void halve(TriangleMesh& mesh, const HalfEdge& side, std::uint32_t middle) {
  Triangle& t = mesh.triangles[side.triangle];
  Triangle other = t;
  other[side.side] = middle;
  t[(side.side + 1) % 3] = middle;
  mesh.triangles.push_back(other);
}

/// Splits non-manifold edges in the middle: each pair of triangles that bounds rock, and each
/// unpaired triangle, gets its own vertex. Edges of triangles that were cut in this round are left
/// for the next.
/// @param source  of each triangle, the one that it is half of; extended
/// @returns whether an edge was cut
bool halve_touching_edges(TriangleMesh& mesh, std::vector<std::uint32_t>& source) {
  std::vector<bool> cut(mesh.triangles.size(), false);
  bool any = false;
  for_each_edge(sorted_half_edges(mesh), [&](std::span<const HalfEdge> sides) {
    const auto was_cut = [&](const HalfEdge& side) { return cut[side.triangle]; };
    if (sides.size() < 3 || std::any_of(sides.begin(), sides.end(), was_cut)) return;
    any = true;
    std::vector<std::size_t> partner(sides.size());
    std::iota(partner.begin(), partner.end(), std::size_t{0});
    for (const auto& [i, j] : rock_pairs(mesh, sides)) {
      if (sides[i].is_forward != sides[j].is_forward) partner[std::max(i, j)] = std::min(i, j);
    }
    const Vec3 position = 0.5 * (mesh.vertices[sides[0].low] + mesh.vertices[sides[0].high]);
    std::vector<std::uint32_t> middle(sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (partner[i] == i) {
        middle[i] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(position);
      } else {
        middle[i] = middle[partner[i]];
      }
      cut[sides[i].triangle] = true;
      source.push_back(source[sides[i].triangle]);
    }
    for (std::size_t i = 0; i < sides.size(); ++i) halve(mesh, sides[i], middle[i]);
  });
  return any;
}

}  // namespace

std::vector<Vec3> triangle_directions_at_edge(const TriangleMesh& mesh,
                                              std::span<const HalfEdge> sides) {
  const Vec3 start = mesh.vertices[sides[0].low];
  const Vec3 along = (mesh.vertices[sides[0].high] - start).normalized();
  std::vector<Vec3> result;
  for (const HalfEdge& side : sides) {
    const Vec3 to = mesh.vertices[mesh.triangles[side.triangle][(side.side + 2) % 3]] - start;
    const Vec3 across = to - to.dot(along) * along;
    result.push_back(across.normalized());
  }
  return result;
}

EdgeSplitResult split_non_manifold_edges(TriangleMesh& mesh) {
  EdgeSplitResult result;
  result.original_triangle.resize(mesh.triangles.size());
  std::iota(result.original_triangle.begin(), result.original_triangle.end(), 0u);
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  DisjointSets corners(3 * mesh.triangles.size());
  const auto join = [&](const HalfEdge& a, const HalfEdge& b) {
    corners.join(a.low_corner(), b.low_corner());
    corners.join(a.high_corner(), b.high_corner());
  };
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() == 2) join(sides[0], sides[1]);
    if (sides.size() < 3) return;
    if (result.split.count++ == 0) result.split.position = mesh.vertices[sides[0].low];
    for (const auto& [i, j] : rock_pairs(mesh, sides)) join(sides[i], sides[j]);
  });
  if (result.split.count == 0) return result;
  std::vector<std::uint32_t> group(3 * mesh.triangles.size());
  for (std::uint32_t c = 0; c < group.size(); ++c) group[c] = corners.find(c);
  split_by_groups(mesh, group);
  for (int round = 0; round < kCutRounds; ++round) {
    if (!halve_touching_edges(mesh, result.original_triangle)) return result;
  }
  drop_touching(mesh, result);
  return result;
}

RepairChange split_non_manifold_vertices(TriangleMesh& mesh) {
  const std::vector<bool> split = split_by_groups(mesh, corner_fans(mesh, sorted_half_edges(mesh)));
  RepairChange result;
  result.count = static_cast<std::size_t>(std::count(split.begin(), split.end(), true));
  if (result.count > 0) {
    result.position = mesh.vertices[static_cast<std::size_t>(
        std::find(split.begin(), split.end(), true) - split.begin())];
  }
  return result;
}

void separate_touching_vertices(TriangleMesh& mesh, double distance) {
  std::map<std::array<double, 3>, std::vector<std::uint32_t>> at_place;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vec3& p = mesh.vertices[v];
    at_place[{p.x(), p.y(), p.z()}].push_back(v);
  }
  std::erase_if(at_place, [](const auto& entry) { return entry.second.size() < 2; });
  if (at_place.empty()) return;
  std::vector<bool> touching(mesh.vertices.size(), false);
  for (const auto& [position, vertices] : at_place) {
    for (const std::uint32_t v : vertices) touching[v] = true;
  }
  // Normal of each fan, and its mean direction from the vertex.
  std::map<std::uint32_t, std::pair<Vec3, Vec3>> fans;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 doubled = doubled_area_vector(mesh, t), middle = centroid(mesh, t);
    for (const std::uint32_t v : t) {
      if (!touching[v]) continue;
      auto& [normal, lean] = fans.try_emplace(v, Vec3::Zero(), Vec3::Zero()).first->second;
      normal += doubled;
      lean += (middle - mesh.vertices[v]).normalized();
    }
  }
  std::vector<std::pair<std::uint32_t, Vec3>> moves;
  for (const auto& [position, vertices] : at_place) {
    for (const std::uint32_t v : vertices) {
      const Vec3 normal = fans.at(v).first.normalized();
      Vec3 others = Vec3::Zero();
      for (const std::uint32_t other : vertices) {
        if (other != v) others += fans.at(other).second;
      }
      moves.emplace_back(v, (others.dot(normal) < 0.0 ? distance : -distance) * normal);
    }
  }
  for (const auto& [v, move] : moves) mesh.vertices[v] += move;
}

}  // namespace clast::reconstruct_detail
