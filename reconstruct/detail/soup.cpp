#include "reconstruct/detail/soup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "core/types.hpp"
#include "shapes/detail/half_edges.hpp"
#include "shapes/mesh_topology.hpp"

namespace clast::detail {

namespace {

using Triangle = TriangleMesh::Triangle;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
/// Rounds of dropping fins: one that stands on another is seen when that is gone.
constexpr int kFinRounds = 8;

/// Takes the marked triangles out.
Mended taken_out(TriangleMesh& mesh, const std::vector<bool>& drop) {
  Mended result;
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!drop[t]) {
      kept.push_back(mesh.triangles[t]);
      continue;
    }
    if (result.count++ == 0) result.place = mesh.vertices[mesh.triangles[t][0]];
    result.area += triangle_area(mesh, mesh.triangles[t]);
  }
  if (result.count > 0) mesh = compacted(mesh, kept);
  return result;
}

std::uint32_t opposite(const TriangleMesh& mesh, const HalfEdge& side) {
  for (const std::uint32_t v : mesh.triangles[side.triangle]) {
    if (v != side.low && v != side.high) return v;
  }
  return side.low;
}

/// Directions from an edge into its triangles, square to the edge.
std::vector<Vec3> wings(const TriangleMesh& mesh, std::span<const HalfEdge> sides) {
  const Vec3 start = mesh.vertices[sides[0].low];
  const Vec3 along = (mesh.vertices[sides[0].high] - start).normalized();
  std::vector<Vec3> result;
  for (const HalfEdge& side : sides) {
    const Vec3 to = mesh.vertices[opposite(mesh, side)] - start;
    const Vec3 across = to - to.dot(along) * along;
    result.push_back(across.normalized());
  }
  return result;
}

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

/// Patches of triangles connected over edges of two.
std::vector<std::uint32_t> manifold_patches(const TriangleMesh& mesh,
                                            std::span<const HalfEdge> sorted) {
  DisjointSets sets(mesh.triangles.size());
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() == 2) sets.join(sides[0].triangle, sides[1].triangle);
  });
  std::vector<std::uint32_t> patch(mesh.triangles.size());
  for (std::uint32_t t = 0; t < patch.size(); ++t) patch[t] = sets.find(t);
  return patch;
}

/// The next pair of sides that part an edge's triangles: around the edge, each pair has rock
/// between its two.
std::vector<std::array<std::size_t, 2>> rock_pairs(const TriangleMesh& mesh,
                                                   std::span<const HalfEdge> sides) {
  const std::vector<Vec3> wing = wings(mesh, sides);
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
    if (!paired[i] && !paired[j] && !sides[i].forward && sides[j].forward) join(i, j);
  }
  for (const bool alike : {false, true}) {  // what is left, better those that agree
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t j = i + 1; j < sides.size(); ++j) {
        if (paired[i] || paired[j]) continue;
        if ((sides[i].forward == sides[j].forward) == alike) join(i, j);
      }
    }
  }
  return pairs;
}

/// Gives each group of corners at a vertex a vertex of its own; the group of the first corner keeps
/// the old one. Returns which vertices were split.
std::vector<bool> split_by_groups(TriangleMesh& mesh, const std::vector<std::uint32_t>& group) {
  std::vector<std::uint32_t> owner(mesh.vertices.size(), kNone);
  std::vector<std::uint32_t> vertex_of_group(group.size(), kNone);
  std::vector<bool> split(mesh.vertices.size(), false);
  for (std::uint32_t corner = 0; corner < group.size(); ++corner) {
    std::uint32_t& vertex = mesh.triangles[corner / 3][corner % 3];
    const std::uint32_t here = group[corner];
    if (owner[vertex] == kNone) owner[vertex] = here;
    if (owner[vertex] == here) continue;
    if (vertex_of_group[here] == kNone) {
      split[vertex] = true;
      vertex_of_group[here] = static_cast<std::uint32_t>(mesh.vertices.size());
      const Vec3 copy = mesh.vertices[vertex];
      mesh.vertices.push_back(copy);
    }
    vertex = vertex_of_group[here];
  }
  return split;
}

}  // namespace

TriangleMesh compacted(const TriangleMesh& source, const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> number(source.vertices.size(), kNone);
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) number[v] = 0;
  }
  TriangleMesh result;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    number[v] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(source.vertices[v]);
  }
  result.triangles.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    result.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  return result;
}

TriangleMesh with_triangles(const TriangleMesh& mesh, const std::vector<bool>& keep) {
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (keep[t]) kept.push_back(mesh.triangles[t]);
  }
  return compacted(mesh, kept);
}

double triangle_area(const TriangleMesh& mesh, const Triangle& t) {
  return 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                   .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                   .norm();
}

std::array<std::uint32_t, 2> first_non_manifold_edge(const TriangleMesh& mesh) {
  std::optional<std::array<std::uint32_t, 2>> found;
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() > 2 && !found) found = {sides[0].low, sides[0].high};
  });
  return found.value();
}

Mended drop_opposite_pairs(TriangleMesh& mesh) {
  std::vector<std::pair<Triangle, std::uint32_t>> order;
  order.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    order.emplace_back(corners, t);
  }
  std::sort(order.begin(), order.end());
  std::vector<bool> second(mesh.triangles.size(), false);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    if (order[i].first != order[i + 1].first) continue;
    pairs.push_back({order[i].second, order[i + 1].second});
    second[order[i + 1].second] = true;
    ++i;
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
  return taken_out(mesh, drop);
}

Mended drop_fins(TriangleMesh& mesh, double largest_share) {
  Mended result;
  for (int round = 0; round < kFinRounds; ++round) {
    const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
    const std::vector<std::uint32_t> patch = manifold_patches(mesh, sorted);
    std::vector<double> area(mesh.triangles.size(), 0.0), voted(area), bordered(area);
    double whole = 0.0;
    for (std::size_t t = 0; t < patch.size(); ++t) {
      const double here = triangle_area(mesh, mesh.triangles[t]);
      area[patch[t]] += here;
      whole += here;
    }
    // At each edge of more than two triangles, all but the smoothest pair are voted out.
    std::map<std::uint32_t, std::vector<std::uint32_t>> kept_by;  // patch: those that stay instead
    for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
      if (sides.size() < 3) return;
      const double length = (mesh.vertices[sides[0].high] - mesh.vertices[sides[0].low]).norm();
      const std::array<std::size_t, 2> stay = smoothest_pair(wings(mesh, sides));
      for (std::size_t i = 0; i < sides.size(); ++i) {
        const std::uint32_t here = patch[sides[i].triangle];
        bordered[here] += length;
        if (i == stay[0] || i == stay[1]) continue;
        voted[here] += length;
        for (const std::size_t k : stay) kept_by[here].push_back(patch[sides[k].triangle]);
      }
    });
    std::vector<std::uint32_t> candidates;
    for (const auto& [here, stay] : kept_by) {
      if (2.0 * voted[here] >= bordered[here] && area[here] < largest_share * whole) {
        candidates.push_back(here);
      }
    }
    std::sort(candidates.begin(), candidates.end(), [&](std::uint32_t a, std::uint32_t b) {
      return area[a] != area[b] ? area[a] < area[b] : a < b;
    });
    // What was to stay in place of a dropped one must stay in this round.
    std::vector<char> fate(mesh.triangles.size(), 0);
    enum : char { kOpen, kDrop, kStay };
    for (const std::uint32_t here : candidates) {
      if (fate[here] != kOpen) continue;
      fate[here] = kDrop;
      for (const std::uint32_t stay : kept_by[here]) {
        if (fate[stay] == kOpen) fate[stay] = kStay;
      }
    }
    std::vector<bool> drop(mesh.triangles.size());
    for (std::size_t t = 0; t < drop.size(); ++t) drop[t] = fate[patch[t]] == kDrop;
    const Mended now = taken_out(mesh, drop);
    if (now.count == 0) break;
    if (result.count == 0) result.place = now.place;
    result.count += now.count;
    result.area += now.area;
  }
  return result;
}

Mended cut_touching_edges(TriangleMesh& mesh) {
  Mended result;
  std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  DisjointSets corners(3 * mesh.triangles.size());
  const auto corner = [&](std::uint32_t triangle, std::uint32_t vertex) {
    const Triangle& t = mesh.triangles[triangle];
    return 3 * triangle + (t[0] == vertex ? 0u : t[1] == vertex ? 1u : 2u);
  };
  const auto join = [&](const HalfEdge& a, const HalfEdge& b) {
    for (const std::uint32_t vertex : {a.low, a.high}) {
      corners.join(corner(a.triangle, vertex), corner(b.triangle, vertex));
    }
  };
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() == 2) join(sides[0], sides[1]);
    if (sides.size() < 3) return;
    if (result.count++ == 0) result.place = mesh.vertices[sides[0].low];
    for (const auto& [i, j] : rock_pairs(mesh, sides)) join(sides[i], sides[j]);
  });
  if (result.count == 0) return result;
  std::vector<std::uint32_t> group(3 * mesh.triangles.size());
  for (std::uint32_t c = 0; c < group.size(); ++c) group[c] = corners.find(c);
  split_by_groups(mesh, group);
  // Sheets that meet again at both ends of the edge can't be parted there.
  sorted = sorted_half_edges(mesh);
  std::vector<bool> drop(mesh.triangles.size(), false);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() < 3) return;
    for (const HalfEdge& side : sides) drop[side.triangle] = true;
  });
  result.area = taken_out(mesh, drop).area;
  return result;
}

void turn_over(TriangleMesh& mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
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
        if (result.turned++ == 0) result.first = mesh.triangles[t][0];
      }
    }
  }
  return result;
}

Mended split_pinched_vertices(TriangleMesh& mesh) {
  const std::vector<bool> split = split_by_groups(mesh, corner_fans(mesh, sorted_half_edges(mesh)));
  Mended result;
  result.count = static_cast<std::size_t>(std::count(split.begin(), split.end(), true));
  if (result.count > 0) {
    result.place = mesh.vertices[static_cast<std::size_t>(
        std::find(split.begin(), split.end(), true) - split.begin())];
  }
  return result;
}

void part_touching_vertices(TriangleMesh& mesh, double distance) {
  std::map<std::array<double, 3>, std::vector<std::uint32_t>> at_place;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vec3& p = mesh.vertices[v];
    at_place[{p.x(), p.y(), p.z()}].push_back(v);
  }
  std::erase_if(at_place, [](const auto& entry) { return entry.second.size() < 2; });
  if (at_place.empty()) return;
  std::vector<bool> touching(mesh.vertices.size(), false);
  for (const auto& [place, vertices] : at_place) {
    for (const std::uint32_t v : vertices) touching[v] = true;
  }
  // Of each fan the normal, and where on the whole it lies from its vertex.
  std::map<std::uint32_t, std::pair<Vec3, Vec3>> fans;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 doubled = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                             .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    for (const std::uint32_t v : t) {
      if (!touching[v]) continue;
      auto& [normal, lean] = fans.try_emplace(v, Vec3::Zero(), Vec3::Zero()).first->second;
      normal += doubled;
      lean += (middle - mesh.vertices[v]).normalized();
    }
  }
  std::vector<std::pair<std::uint32_t, Vec3>> moves;
  for (const auto& [place, vertices] : at_place) {
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

SoupMends mend_soup(TriangleMesh& mesh, double largest_fin) {
  SoupMends mends;
  mends.folded = drop_opposite_pairs(mesh);
  if (mesh.triangles.empty()) return mends;
  if (inspect(mesh).non_manifold_edges > 0) mends.fins = drop_fins(mesh, largest_fin);
  mends.orientation = orient_consistently(mesh);
  if (!mends.orientation.orientable || inspect(mesh).non_manifold_edges == 0) return mends;
  mends.touching = cut_touching_edges(mesh);
  const Orientation again = orient_consistently(mesh);
  mends.orientation.turned += again.turned;
  mends.orientation.orientable = again.orientable;
  mends.orientation.conflict = again.conflict;
  return mends;
}

}  // namespace clast::detail
