#include "reconstruct/repair/soup.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "mesh/half_edges.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/sub_mesh.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "mesh/vertex_corners.hpp"
#include "mesh/weld.hpp"
#include "reconstruct/repair/non_manifold_split.hpp"

namespace clast::reconstruct_detail {

namespace {

using Triangle = TriangleMesh::Triangle;

/// Rounds of dropping fins: one that stands on another is seen when that is gone.
constexpr int kFinRounds = 8;
/// Share of the triangles that may disagree with a neighbour where nearly all face one way.
constexpr double kFewDisagree = 0.01;

/// The two sides of an edge that go on most smoothly from one to the other.
std::array<std::size_t, 2> smoothest_pair(const std::vector<Vec3>& wing) {
  std::array<std::size_t, 2> best = {0, 1};
  double flattest = 2.0;
  for (std::size_t i = 0; i < wing.size(); ++i) {
    for (std::size_t j = i + 1; j < wing.size(); ++j) {
      const double cosine = wing[i].dot(wing[j]);  // -1: flat
      if (cosine < flattest) {
        flattest = cosine;
        best = {i, j};
      }
    }
  }
  return best;
}

/// Removes the triangles at edges where both neighbours run the same way, where they are few.
RepairChange drop_disagreeing(TriangleMesh& mesh) {
  std::vector<bool> drop(mesh.triangles.size(), false);
  RepairChange result;
  for_each_edge(sorted_half_edges(mesh), [&](std::span<const HalfEdge> sides) {
    if (sides.size() != 2 || sides[0].is_forward != sides[1].is_forward) return;
    if (result.count++ == 0) result.position = mesh.vertices[sides[0].low];
    for (const HalfEdge& side : sides) drop[side.triangle] = true;
  });
  const auto dropped = static_cast<double>(std::count(drop.begin(), drop.end(), true));
  if (dropped > kFewDisagree * static_cast<double>(drop.size())) return {};
  result.area = remove_triangles(mesh, drop).area;
  return result;
}

/// Patches between edges of more than two triangles that a fin may be.
struct FinVotes {
  std::vector<std::uint32_t> patch;                             ///< of each triangle
  std::vector<std::uint32_t> candidates;                        ///< patches, the smallest first
  std::map<std::uint32_t, std::vector<std::uint32_t>> kept_by;  ///< patch: those that stay instead
};

/// Votes out all but the smoothest pair at each non-manifold edge.
FinVotes fin_votes(const TriangleMesh& mesh, double max_fin_fraction) {
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  FinVotes votes{manifold_components(triangle_neighbours(mesh, sorted)), {}, {}};
  const std::vector<std::uint32_t>& patch = votes.patch;
  std::vector<double> area(mesh.triangles.size(), 0.0), voted(area), bordered(area);
  double whole = 0.0;
  for (std::size_t t = 0; t < patch.size(); ++t) {
    const double here = triangle_area(mesh, mesh.triangles[t]);
    area[patch[t]] += here;
    whole += here;
  }
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() < 3) return;
    const double length = (mesh.vertices[sides[0].high] - mesh.vertices[sides[0].low]).norm();
    const std::array<std::size_t, 2> stay =
        smoothest_pair(triangle_directions_at_edge(mesh, sides));
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const std::uint32_t here = patch[sides[i].triangle];
      bordered[here] += length;
      if (i == stay[0] || i == stay[1]) continue;
      voted[here] += length;
      for (const std::size_t k : stay) votes.kept_by[here].push_back(patch[sides[k].triangle]);
    }
  });
  for (const auto& [here, stay] : votes.kept_by) {
    if (2.0 * voted[here] >= bordered[here] && area[here] < max_fin_fraction * whole) {
      votes.candidates.push_back(here);
    }
  }
  std::sort(votes.candidates.begin(), votes.candidates.end(),
            [&](std::uint32_t a, std::uint32_t b) {
              return area[a] != area[b] ? area[a] < area[b] : a < b;
            });
  return votes;
}

/// Removes the patches voted out; those kept instead of a removed one stay in this round.
RepairChange drop_voted_out(TriangleMesh& mesh, const FinVotes& votes) {
  std::vector<char> fate(mesh.triangles.size(), 0);
  enum : char { kOpen, kDrop, kStay };
  for (const std::uint32_t here : votes.candidates) {
    if (fate[here] != kOpen) continue;
    fate[here] = kDrop;
    for (const std::uint32_t stay : votes.kept_by.at(here)) {
      if (fate[stay] == kOpen) fate[stay] = kStay;
    }
  }
  std::vector<bool> drop(mesh.triangles.size());
  for (std::size_t t = 0; t < drop.size(); ++t) drop[t] = fate[votes.patch[t]] == kDrop;
  return remove_triangles(mesh, drop);
}

}  // namespace

RepairChange remove_triangles(TriangleMesh& mesh, const std::vector<bool>& drop) {
  RepairChange result;
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!drop[t]) {
      kept.push_back(mesh.triangles[t]);
      continue;
    }
    if (result.count++ == 0) result.position = mesh.vertices[mesh.triangles[t][0]];
    result.area += triangle_area(mesh, mesh.triangles[t]);
  }
  if (result.count > 0) mesh = extract_triangles(mesh, kept);
  return result;
}

RepairChange remove_opposite_pairs(TriangleMesh& mesh) {
  std::vector<bool> second(mesh.triangles.size(), false);
  std::vector<DuplicateTriangle> pairs;
  for (const DuplicateTriangle& copy :
       find_duplicate_triangles(mesh.triangles, WindingMatch::kEither)) {
    if (second[copy.first]) continue;  // is in a pair already
    pairs.push_back(copy);
    second[copy.duplicate] = true;
  }
  if (pairs.empty()) return {};
  // Sides of a triangle over which the surface goes on to just one other, pairs counted once.
  std::vector<int> goes_on(mesh.triangles.size(), 0);
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    const auto distinct = std::count_if(
        sides.begin(), sides.end(), [&](const HalfEdge& side) { return !second[side.triangle]; });
    if (distinct != 2) return;
    for (const HalfEdge& side : sides) ++goes_on[side.triangle];
  });
  std::vector<bool> drop = second;
  for (const auto& [first, other] : pairs) {
    if (goes_on[first] < 2) drop[first] = true;
  }
  return remove_triangles(mesh, drop);
}

RepairChange remove_fins(TriangleMesh& mesh, double max_fin_fraction) {
  RepairChange result;
  for (int round = 0; round < kFinRounds; ++round) {
    const RepairChange now = drop_voted_out(mesh, fin_votes(mesh, max_fin_fraction));
    if (now.count == 0) break;
    if (result.count == 0) result.position = now.position;
    result.count += now.count;
    result.area += now.area;
  }
  return result;
}

RepairChange remove_border_fins(TriangleMesh& mesh) {
  const VertexCorners around(mesh);
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  std::vector<int> shared(mesh.triangles.size(), 0);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() < 2) return;
    for (const HalfEdge& side : sides) ++shared[side.triangle];
  });
  std::vector<bool> drop(mesh.triangles.size());
  for (std::size_t t = 0; t < drop.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    drop[t] = shared[t] == 1 && std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
                return around.corners_of(v).size() == 1;
              });
  }
  return remove_triangles(mesh, drop);
}

OrientationResult orient_consistently(TriangleMesh& mesh) {
  const ConsistentOrientation facing = find_consistent_orientation(mesh, triangle_neighbours(mesh));
  OrientationResult result;
  result.orientable = !facing.conflict_vertex;
  result.conflict_vertex = facing.conflict_vertex.value_or(0);
  for (const std::vector<std::uint32_t>& component : facing.components) {
    const auto against = std::count_if(component.begin(), component.end(),
                                       [&](std::uint32_t t) { return facing.is_flipped[t]; });
    const bool most = 2 * static_cast<std::size_t>(against) > component.size();
    for (const std::uint32_t t : component) {
      if (facing.is_flipped[t] == most) continue;
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      if (result.flipped++ == 0) result.first_flipped_vertex = mesh.triangles[t][0];
    }
  }
  return result;
}

SoupRepairResult repair_soup(TriangleMesh& mesh, double max_fin_fraction) {
  SoupRepairResult repair;
  repair.removed_pairs = remove_opposite_pairs(mesh);
  if (mesh.triangles.empty()) return repair;
  if (inspect_mesh(mesh).non_manifold_edges > 0)
    repair.removed_fins = remove_fins(mesh, max_fin_fraction);
  if (repair.removed_fins.count > 0) {
    const RepairChange more = remove_border_fins(mesh);
    repair.removed_fins.count += more.count;
    repair.removed_fins.area += more.area;
  }
  const TriangleMesh as_faced = mesh;
  repair.orientation = orient_consistently(mesh);
  if (!repair.orientation.orientable) {
    // Two sheets that touched may leave two triangles that were never adjacent.
    mesh = as_faced;
    repair.split_edges = drop_disagreeing(mesh);
    repair.orientation = orient_consistently(mesh);
  }
  if (!repair.orientation.orientable || inspect_mesh(mesh).non_manifold_edges == 0) return repair;
  const RepairChange cut = split_non_manifold_edges(mesh).split;
  if (repair.split_edges.count == 0) repair.split_edges.position = cut.position;
  repair.split_edges.count += cut.count;
  repair.split_edges.area += cut.area;
  const OrientationResult again = orient_consistently(mesh);
  repair.orientation.flipped += again.flipped;
  repair.orientation.orientable = again.orientable;
  repair.orientation.conflict_vertex = again.conflict_vertex;
  return repair;
}

}  // namespace clast::reconstruct_detail
