#include "classify/equilibria.hpp"

#include <algorithm>
#include <vector>

#include "core/disjoint_sets.hpp"
#include "mesh/half_edges.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {
namespace {

// Triangles that meet at less than this angle are parts of one face, rad.
constexpr double kOneFace = 1e-6;

/// An edge between two faces of the hull, counter-clockwise around the first.
struct Ridge {
  std::uint32_t from, to;
  std::uint32_t face, other_face;
};

/// The hull with coplanar triangles joined.
struct Polytope {
  std::vector<Vec3> vertices;
  std::vector<Vec3> normals;  ///< of every face, unit; zero for numbers that are not in use
  std::vector<Ridge> ridges;
};

Polytope polytope(const TriangleMesh& hull) {
  const auto count = static_cast<std::uint32_t>(hull.triangles.size());
  std::vector<Vec3> area(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    const auto& [a, b, c] = hull.triangles[t];
    area[t] = (hull.vertices[b] - hull.vertices[a]).cross(hull.vertices[c] - hull.vertices[a]);
  }
  const std::vector<HalfEdge> sides = sorted_half_edges(hull);
  // The hull is closed: two triangles at each edge, one of which runs along it from low to high.
  const auto each_edge = [&](const auto& use) {
    for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
      const std::size_t left = edge[0].is_forward ? 0 : 1;
      use(edge[0].low, edge[0].high, edge[left].triangle, edge[1 - left].triangle);
    });
  };
  DisjointSets faces(count);
  each_edge([&](std::uint32_t, std::uint32_t, std::uint32_t t, std::uint32_t u) {
    if (area[t].cross(area[u]).norm() <= kOneFace * area[t].norm() * area[u].norm()) {
      faces.join(t, u);
    }
  });
  Polytope result;
  result.vertices = hull.vertices;
  result.normals.assign(count, Vec3::Zero());
  for (std::uint32_t t = 0; t < count; ++t) {
    result.normals[faces.find(t)] += area[t];
  }
  for (Vec3& normal : result.normals) {
    if (normal.squaredNorm() > 0.0) normal.normalize();
  }
  each_edge([&](std::uint32_t from, std::uint32_t to, std::uint32_t t, std::uint32_t u) {
    const std::uint32_t f = faces.find(t), g = faces.find(u);
    if (f != g) result.ridges.push_back({from, to, f, g});
  });
  return result;
}

std::size_t count_stable(const Polytope& p, const Vec3& centre) {
  std::vector<char> inside(p.normals.size(), 0);
  for (std::size_t f = 0; f < inside.size(); ++f) inside[f] = p.normals[f].squaredNorm() > 0.0;
  const auto keep = [&](std::uint32_t face, const Vec3& from, const Vec3& to) {
    // The foot of the centre on the face lies to the left of its border exactly if the centre does.
    if ((to - from).cross(centre - from).dot(p.normals[face]) < 0.0) inside[face] = 0;
  };
  for (const Ridge& ridge : p.ridges) {
    keep(ridge.face, p.vertices[ridge.from], p.vertices[ridge.to]);
    keep(ridge.other_face, p.vertices[ridge.to], p.vertices[ridge.from]);
  }
  return static_cast<std::size_t>(std::count(inside.begin(), inside.end(), 1));
}

std::size_t count_unstable(const Polytope& p, const Vec3& centre) {
  std::vector<char> highest(p.vertices.size(), 1);
  for (const Ridge& ridge : p.ridges) {
    const Vec3 along = p.vertices[ridge.to] - p.vertices[ridge.from];
    if (along.dot(p.vertices[ridge.from] - centre) > 0.0) highest[ridge.from] = 0;
    if (along.dot(p.vertices[ridge.to] - centre) < 0.0) highest[ridge.to] = 0;
  }
  return static_cast<std::size_t>(std::count(highest.begin(), highest.end(), 1));
}

std::size_t count_saddles(const Polytope& p, const Vec3& centre) {
  std::size_t count = 0;
  for (const Ridge& ridge : p.ridges) {
    const Vec3 from = p.vertices[ridge.from], along = p.vertices[ridge.to] - from;
    const double share = along.dot(centre - from) / along.squaredNorm();
    if (!(share > 0.0 && share < 1.0)) continue;
    // Outward from the centre to the edge must lie between the normals of the two faces.
    const Vec3 out = from + share * along - centre;
    const Vec3 into_face = p.normals[ridge.face].cross(along);
    const Vec3 into_other = -p.normals[ridge.other_face].cross(along);
    if (out.dot(into_face) < 0.0 && out.dot(into_other) < 0.0) ++count;
  }
  return count;
}

}  // namespace

StaticEquilibriumCounts count_static_equilibria(const SpheroPolyhedron& body, const Vec3& centre) {
  const Polytope hull = polytope(convex_hull(body.vertices));
  return {count_stable(hull, centre), count_unstable(hull, centre), count_saddles(hull, centre)};
}

}  // namespace clast
