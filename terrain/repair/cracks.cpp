#include "terrain/repair/cracks.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "mesh/vertex_corners.hpp"
#include "terrain/plan_index.hpp"

namespace clast::terrain_detail {
namespace {

using Triangle = TriangleMesh::Triangle;

// T-junctions on both sides of a triangle are divided one after the other; a tile border with
// vertices in a row on every triangle needs two rounds.
constexpr int kCrackRounds = 6;

struct BorderSide {
  std::uint32_t triangle;
  std::size_t side;
};

std::vector<PlanBox> boxes_of(const TriangleMesh& mesh, const std::vector<BorderSide>& sides) {
  std::vector<PlanBox> boxes(sides.size());
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto& [t, k] = sides[s];
    boxes[s].include(mesh.vertices[mesh.triangles[t][k]].head<2>());
    boxes[s].include(mesh.vertices[mesh.triangles[t][(k + 1) % 3]].head<2>());
  }
  return boxes;
}

struct Border {
  std::vector<BorderSide> sides;
  std::vector<std::uint32_t> vertices;  ///< rising, each once
  VertexCorners corners;
};

std::vector<BorderSide> border_sides(const TriangleMesh& mesh, const TriangleNeighbours& links) {
  std::vector<BorderSide> sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (links.is_border_side(t, k)) sides.push_back({t, k});
    }
  }
  return sides;
}

Border border_of(const TriangleMesh& mesh) {
  Border border{border_sides(mesh, triangle_neighbours(mesh)), {}, VertexCorners(mesh)};
  for (const auto& [t, k] : border.sides) {
    border.vertices.push_back(mesh.triangles[t][k]);
    border.vertices.push_back(mesh.triangles[t][(k + 1) % 3]);
  }
  std::sort(border.vertices.begin(), border.vertices.end());
  border.vertices.erase(std::unique(border.vertices.begin(), border.vertices.end()),
                        border.vertices.end());
  return border;
}

/// Ends of the edges that leave the vertices of a cluster.
std::set<std::uint32_t> neighbours_of(const TriangleMesh& mesh, const Border& border,
                                      const std::vector<std::uint32_t>& cluster) {
  std::set<std::uint32_t> result;
  for (const std::uint32_t v : cluster) {
    for (const std::uint32_t corner : border.corners.corners_of(v)) {
      const Triangle& t = mesh.triangles[corner / 3];
      result.insert(t.begin(), t.end());
    }
  }
  for (const std::uint32_t v : cluster) result.erase(v);
  return result;
}

/// True if the triangles at `vertex` keep their orientation when it moves to `to`.
bool may_move(const TriangleMesh& mesh, const Border& border, std::uint32_t vertex,
              const Vec3& to) {
  for (const std::uint32_t corner : border.corners.corners_of(vertex)) {
    const Triangle& t = mesh.triangles[corner / 3];
    std::array<Vec3, 3> place = {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    place[corner % 3] = to;
    const Vec3 after = (place[1] - place[0]).cross(place[2] - place[0]);
    if (after.dot(doubled_area_vector(mesh, t)) <= 0.0) return false;
  }
  return true;
}

struct Closed {
  std::size_t joined = 0;
  std::size_t divided = 0;
  double widest = 0.0;
  Vec3 at = Vec3::Zero();

  void note(double gap, const Vec3& place) {
    if (joined + divided == 1 || gap > widest) {
      widest = gap;
      at = place;
    }
  }
};

/// Border vertices within `width` of each other become one: the one that was read first.
void join_vertices(TriangleMesh& mesh, double width, Closed& closed) {
  const Border border = border_of(mesh);
  std::vector<PlanBox> boxes;
  for (const std::uint32_t v : border.vertices) {
    const Vec2 at = mesh.vertices[v].head<2>();
    boxes.push_back({at, at});
  }
  const PlanIndex index(boxes);
  std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const std::uint32_t v = border.vertices[i];
    for (const std::uint32_t k : index.boxes_near(boxes[i].expanded(width))) {
      const std::uint32_t other = border.vertices[k];
      const double gap = (mesh.vertices[v] - mesh.vertices[other]).norm();
      if (k > i && gap <= width) pairs.emplace_back(gap, v, other);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::map<std::uint32_t, std::vector<std::uint32_t>> clusters;  // by their first vertex
  std::map<std::uint32_t, std::uint32_t> first_of;
  for (const auto& [gap, v, other] : pairs) {
    for (const std::uint32_t each : {v, other}) {
      if (first_of.emplace(each, each).second) clusters[each] = {each};
    }
    const std::uint32_t keep = std::min(first_of[v], first_of[other]);
    const std::uint32_t leave = std::max(first_of[v], first_of[other]);
    if (keep == leave) continue;
    const std::set<std::uint32_t> around = neighbours_of(mesh, border, clusters[keep]);
    const Vec3 place = mesh.vertices[keep];
    bool fits = true;
    for (const std::uint32_t each : clusters[leave]) {
      fits = fits && !around.contains(each) && (mesh.vertices[each] - place).norm() <= width &&
             may_move(mesh, border, each, place);
    }
    if (!fits) continue;
    for (const std::uint32_t each : clusters[leave]) {
      first_of[each] = keep;
      mesh.vertices[each] = place;
      clusters[keep].push_back(each);
    }
    clusters.erase(leave);
    ++closed.joined;
    closed.note(gap, place);
  }
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) {
      const auto known = first_of.find(corner);
      if (known != first_of.end()) corner = known->second;
    }
  }
}

/// Edges of the triangles at the border: those on it, and the others.
struct EdgesNearBorder {
  std::set<EdgeKey> on_border, others;
};

EdgesNearBorder edges_near(const TriangleMesh& mesh, const Border& border) {
  EdgesNearBorder edges;
  for (const auto& [t, k] : border.sides) {
    edges.on_border.insert(make_edge_key(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]));
  }
  for (const std::uint32_t v : border.vertices) {
    for (const std::uint32_t corner : border.corners.corners_of(v)) {
      const Triangle& t = mesh.triangles[corner / 3];
      for (std::size_t k = 0; k < 3; ++k) {
        const EdgeKey edge = make_edge_key(t[k], t[(k + 1) % 3]);
        if (!edges.on_border.contains(edge)) edges.others.insert(edge);
      }
    }
  }
  return edges;
}

/// A border vertex that lies on a border side of a triangle that does not have it.
struct Junction {
  double along;  ///< share of the side
  std::uint32_t vertex;
  double gap;
  bool operator<(const Junction& other) const {
    return std::tie(along, vertex) < std::tie(other.along, other.vertex);
  }
};

/// Sorted by border side, then along it.
std::map<std::size_t, std::vector<Junction>> junctions_within(double width,
                                                              const TriangleMesh& mesh,
                                                              const Border& border) {
  const PlanIndex index(boxes_of(mesh, border.sides));
  std::map<std::size_t, std::vector<Junction>> junctions;
  for (const std::uint32_t v : border.vertices) {
    const Vec3& point = mesh.vertices[v];
    PlanBox here;
    here.include(point.head<2>());
    for (const std::uint32_t s : index.boxes_near(here.expanded(width))) {
      const auto& [t, k] = border.sides[s];
      const Triangle& triangle = mesh.triangles[t];
      if (std::find(triangle.begin(), triangle.end(), v) != triangle.end()) continue;
      const Vec3 &a = mesh.vertices[triangle[k]], &b = mesh.vertices[triangle[(k + 1) % 3]];
      const double along = (point - a).dot(b - a) / (b - a).squaredNorm();
      if (!(along > 0.0 && along < 1.0)) continue;
      const double gap = (a + along * (b - a) - point).norm();
      if (gap <= width) junctions[s].push_back({along, v, gap});
    }
  }
  for (auto& [s, vertices] : junctions) std::sort(vertices.begin(), vertices.end());
  return junctions;
}

/// Vertices that can divide the triangle: orientations are kept, and no edge gets a third triangle.
std::vector<Junction> fitting(const std::vector<Junction>& junctions, const BorderSide& at,
                              const TriangleMesh& mesh, const EdgesNearBorder& edges) {
  const Triangle& triangle = mesh.triangles[at.triangle];
  const Vec3 normal = doubled_area_vector(mesh, triangle);
  const std::uint32_t last = triangle[(at.side + 1) % 3], apex = triangle[(at.side + 2) % 3];
  const auto fits = [&](std::uint32_t from, std::uint32_t to) {
    const Vec3 part =
        (mesh.vertices[to] - mesh.vertices[from]).cross(mesh.vertices[apex] - mesh.vertices[from]);
    return part.dot(normal) > 0.0 && !edges.others.contains(make_edge_key(from, to));
  };
  std::uint32_t before = triangle[at.side];
  std::vector<Junction> result;
  for (const Junction& junction : junctions) {
    const EdgeKey to_apex = make_edge_key(junction.vertex, apex);
    if (edges.others.contains(to_apex) || edges.on_border.contains(to_apex) ||
        !fits(before, junction.vertex) || !fits(junction.vertex, last)) {
      continue;
    }
    result.push_back(junction);
    before = junction.vertex;
  }
  return result;
}

/// Divides a triangle at vertices on its side into a fan about the corner opposite.
void divide_at(RawSurface& surface, const BorderSide& at, const std::vector<Junction>& junctions) {
  std::vector<Triangle>& triangles = surface.mesh.triangles;
  const Triangle whole = triangles[at.triangle];
  const std::uint32_t last = whole[(at.side + 1) % 3], apex = whole[(at.side + 2) % 3];
  triangles[at.triangle] = {whole[at.side], junctions[0].vertex, apex};
  for (std::size_t i = 0; i < junctions.size(); ++i) {
    const std::uint32_t next = i + 1 < junctions.size() ? junctions[i + 1].vertex : last;
    triangles.push_back({junctions[i].vertex, next, apex});
    surface.source_file.push_back(surface.source_file[at.triangle]);
  }
}

/// Divides triangles at border vertices that lie on their border side.
/// @return  whether any was
bool divide_sides(RawSurface& surface, double width, Closed& closed) {
  const TriangleMesh& mesh = surface.mesh;
  const Border border = border_of(mesh);
  const EdgesNearBorder edges = edges_near(mesh, border);
  std::vector<bool> divided(mesh.triangles.size(), false);
  bool any = false;
  for (const auto& [s, junctions] : junctions_within(width, mesh, border)) {
    const BorderSide& at = border.sides[s];
    if (divided[at.triangle]) continue;
    const std::vector<Junction> used = fitting(junctions, at, mesh, edges);
    if (used.empty()) continue;
    divided[at.triangle] = any = true;
    divide_at(surface, at, used);
    for (const Junction& junction : used) {
      ++closed.divided;
      closed.note(junction.gap, mesh.vertices[junction.vertex]);
    }
  }
  return any;
}

}  // namespace

void close_cracks(RawSurface& surface, double width, TerrainReport& report) {
  if (!(width > 0.0)) return;
  Closed closed;
  join_vertices(surface.mesh, width, closed);
  for (int round = 0; round < kCrackRounds && divide_sides(surface, width, closed); ++round) {
  }
  report.closed_cracks = closed.joined + closed.divided;
  if (report.closed_cracks == 0) return;
  report.notes.push_back("cracks were closed: " + std::to_string(closed.joined) +
                         " border vertices joined to others, " + std::to_string(closed.divided) +
                         " made corners of the neighbouring triangle; the widest crack, " +
                         format_significant(closed.widest, 3) + " m, at " +
                         format_map_point(closed.at));
}

void note_gaps(const RawSurface& surface, double reach, TerrainReport& report) {
  if (report.components < 2) return;
  const TriangleMesh& mesh = surface.mesh;
  const TriangleNeighbours links = triangle_neighbours(mesh);
  const std::vector<std::uint32_t> component = manifold_components(links);
  const std::vector<BorderSide> sides = border_sides(mesh, links);
  const PlanIndex index(boxes_of(mesh, sides));
  std::size_t apart = 0;
  double narrowest = 0.0;
  Vec3 at = Vec3::Zero();
  for (const auto& [triangle, side] : sides) {
    const Vec3& point = mesh.vertices[mesh.triangles[triangle][side]];
    PlanBox here;
    here.include(point.head<2>());
    double nearest = 1e300;
    for (const std::uint32_t s : index.boxes_near(here.expanded(reach))) {
      const auto& [other, k] = sides[s];
      if (component[other] == component[triangle]) continue;
      const Vec3& a = mesh.vertices[mesh.triangles[other][k]];
      const Vec3 along = mesh.vertices[mesh.triangles[other][(k + 1) % 3]] - a;
      // Beside it in plan: above or below it counts as near.
      const double share = std::clamp((point - a).head<2>().dot(along.head<2>()) /
                                          std::max(along.head<2>().squaredNorm(), 1e-300),
                                      0.0, 1.0);
      const Vec3 gap = a + share * along - point;
      if (gap.head<2>().norm() <= reach) nearest = std::min(nearest, gap.norm());
    }
    if (nearest == 1e300 || nearest == 0.0) continue;
    if (apart++ == 0 || nearest < narrowest) {
      narrowest = nearest;
      at = point;
    }
  }
  if (apart == 0) return;
  report.notes.push_back(
      "the ground is in " + std::to_string(report.components) +
      " components with gaps or steps between them: " + std::to_string(apart) +
      " border vertices are near another component without touching it, the smallest gap is " +
      format_significant(narrowest, 3) + " m, at " + format_map_point(at) +
      "; a block that reaches a gap leaves the terrain. Join the tiles, or give a crack width as "
      "large as the gap");
}

}  // namespace clast::terrain_detail
