#include "reconstruct/detail/mend.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "core/types.hpp"
#include "shapes/detail/half_edges.hpp"
#include "shapes/mesh_topology.hpp"

namespace clast::detail {

namespace {

using Triangle = TriangleMesh::Triangle;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

TriangleMesh compacted(const TriangleMesh& source, const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> used;
  for (const Triangle& t : triangles) used.insert(used.end(), t.begin(), t.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  TriangleMesh result;
  for (const std::uint32_t v : used) result.vertices.push_back(source.vertices[v]);
  const auto renumbered = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  };
  for (const Triangle& t : triangles) {
    result.triangles.push_back({renumbered(t[0]), renumbered(t[1]), renumbered(t[2])});
  }
  return result;
}

/// The fan over `loop` from its corner `apex`.
std::vector<Triangle> fan(const std::vector<std::uint32_t>& loop, std::size_t apex) {
  std::vector<Triangle> triangles;
  const auto at = [&](std::size_t k) { return loop[(apex + k) % loop.size()]; };
  for (std::size_t k = 2; k < loop.size(); ++k) triangles.push_back({at(0), at(k - 1), at(k)});
  return triangles;
}

double area_of(const TriangleMesh& mesh, const std::vector<Triangle>& triangles) {
  double doubled = 0.0;
  for (const Triangle& t : triangles) {
    doubled += (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                   .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                   .norm();
  }
  return 0.5 * doubled;
}

}  // namespace

double signed_volume(const TriangleMesh& closed) {
  const Bounds box = bounds(closed);
  const Vec3 origin = 0.5 * (box.low + box.high);
  double sixfold = 0.0;
  for (const Triangle& t : closed.triangles) {
    sixfold += (closed.vertices[t[0]] - origin)
                   .dot((closed.vertices[t[1]] - origin).cross(closed.vertices[t[2]] - origin));
  }
  return sixfold / 6.0;
}

bool encloses(const TriangleMesh& closed, const Vec3& point) {
  const Bounds box = bounds(closed);
  if ((point.array() < box.low.array()).any() || (point.array() > box.high.array()).any()) {
    return false;
  }
  // Solid angle of every triangle (Van Oosterom & Strackee 1983).
  double half_angles = 0.0;
  for (const Triangle& t : closed.triangles) {
    const Vec3 a = closed.vertices[t[0]] - point, b = closed.vertices[t[1]] - point,
               c = closed.vertices[t[2]] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    half_angles +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return std::abs(half_angles) > kPi;
}

std::array<std::uint32_t, 2> first_non_manifold_edge(const TriangleMesh& mesh) {
  std::optional<std::array<std::uint32_t, 2>> found;
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() > 2 && !found) found = {sides[0].low, sides[0].high};
  });
  return found.value();
}

std::vector<TriangleMesh> split_components(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> component = triangle_components(mesh);
  std::vector<std::vector<Triangle>> groups;
  for (std::size_t t = 0; t < component.size(); ++t) {
    if (component[t] >= groups.size()) groups.resize(component[t] + 1);
    groups[component[t]].push_back(mesh.triangles[t]);
  }
  std::vector<TriangleMesh> parts;
  for (const std::vector<Triangle>& group : groups) parts.push_back(compacted(mesh, group));
  return parts;
}

std::size_t drop_opposite_pairs(TriangleMesh& mesh) {
  std::vector<std::pair<Triangle, std::uint32_t>> order;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    order.emplace_back(corners, t);
  }
  std::sort(order.begin(), order.end());
  std::vector<bool> first(mesh.triangles.size(), false), second(mesh.triangles.size(), false);
  std::size_t pairs = 0;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    if (order[i].first != order[i + 1].first) continue;
    first[order[i].second] = second[order[i + 1].second] = true;
    ++pairs;
    ++i;
  }
  if (pairs == 0) return 0;
  const bool two_sided = 2 * pairs == mesh.triangles.size();
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!second[t] && (two_sided || !first[t])) kept.push_back(mesh.triangles[t]);
  }
  const std::size_t dropped = mesh.triangles.size() - kept.size();
  mesh = compacted(mesh, kept);
  return dropped;
}

Orientation orient_consistently(TriangleMesh& mesh) {
  struct Link {
    std::uint32_t triangle;
    bool agrees;
    std::uint32_t vertex;
  };
  std::vector<std::vector<Link>> links(mesh.triangles.size());
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() != 2) return;
    const bool agrees = sides[0].forward != sides[1].forward;
    links[sides[0].triangle].push_back({sides[1].triangle, agrees, sides[0].low});
    links[sides[1].triangle].push_back({sides[0].triangle, agrees, sides[0].low});
  });

  enum : char { kUnseen, kAsIs, kTurned };
  std::vector<char> state(mesh.triangles.size(), kUnseen);
  Orientation result;
  for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (state[seed] != kUnseen) continue;
    std::vector<std::uint32_t> piece = {seed};
    state[seed] = kAsIs;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (const Link& link : links[piece[i]]) {
        const char wanted = (state[piece[i]] == kAsIs) == link.agrees ? kAsIs : kTurned;
        char& there = state[link.triangle];
        if (there == kUnseen) {
          there = wanted;
          turned += wanted == kTurned;
          piece.push_back(link.triangle);
        } else if (there != wanted) {
          if (result.orientable) result.conflict = link.vertex;
          result.orientable = false;
        }
      }
    }
    const bool majority_turned = 2 * turned > piece.size();
    for (const std::uint32_t t : piece) {
      if ((state[t] == kTurned) != majority_turned) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        ++result.turned;
      }
    }
  }
  return result;
}

std::vector<std::size_t> fill_small_holes(TriangleMesh& mesh, std::size_t most_edges) {
  std::vector<std::size_t> filled;
  std::vector<std::vector<std::uint32_t>> loops = boundary_loops(mesh);
  std::erase_if(loops,
                [&](const auto& loop) { return loop.size() > most_edges || loop.size() < 3; });
  if (loops.empty()) return filled;
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const HalfEdge& side : sorted_half_edges(mesh)) edges.insert({side.low, side.high});
  for (const std::vector<std::uint32_t>& loop : loops) {
    std::vector<Triangle> best;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t apex = 0; apex < loop.size(); ++apex) {
      bool crosses = false;
      for (std::size_t k = 2; k + 1 < loop.size(); ++k) {
        const std::uint32_t other = loop[(apex + k) % loop.size()];
        crosses |= edges.contains({std::min(loop[apex], other), std::max(loop[apex], other)});
      }
      std::vector<Triangle> candidate = fan(loop, apex);
      const double area = area_of(mesh, candidate);
      if (crosses || area >= smallest) continue;
      smallest = area;
      best = std::move(candidate);
    }
    if (best.empty()) continue;
    for (const Triangle& t : best) {
      for (std::size_t k = 0; k < 3; ++k) {
        edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
      }
    }
    mesh.triangles.insert(mesh.triangles.end(), best.begin(), best.end());
    filled.push_back(loop.size());
  }
  return filled;
}

std::size_t split_pinched_vertices(TriangleMesh& mesh) {
  const std::vector<std::uint32_t> fans = corner_fans(mesh, sorted_half_edges(mesh));
  std::vector<std::uint32_t> owner(mesh.vertices.size(), kNone);  // fan that keeps the vertex
  std::vector<std::uint32_t> vertex_of_fan(fans.size(), kNone);
  std::vector<bool> split(mesh.vertices.size(), false);
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
    std::uint32_t& vertex = mesh.triangles[corner / 3][corner % 3];
    const std::uint32_t fan_here = fans[corner];
    if (owner[vertex] == kNone) owner[vertex] = fan_here;
    if (owner[vertex] == fan_here) continue;
    if (vertex_of_fan[fan_here] == kNone) {
      split[vertex] = true;
      vertex_of_fan[fan_here] = static_cast<std::uint32_t>(mesh.vertices.size());
      const Vec3 copy = mesh.vertices[vertex];
      mesh.vertices.push_back(copy);
    }
    vertex = vertex_of_fan[fan_here];
  }
  return static_cast<std::size_t>(std::count(split.begin(), split.end(), true));
}

}  // namespace clast::detail
