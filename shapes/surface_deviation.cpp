#include "shapes/surface_deviation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/surface_samples.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_tree.hpp"
#include "shapes/detail/rounded_surface_distance.hpp"

namespace clast {

namespace {

/// The search for the largest distance ends when no patch can hold one larger than the largest met
/// by more than this share of the scan's diagonal.
constexpr double kGap = 2e-4;
/// Height above a core face, as a share of the diagonal, that still lies in its plane.
constexpr double kInFacePlane = 1e-9;
/// Patches looked at before the search ends with the bound it has.
constexpr std::size_t kMaxPatches = 1'000'000;
/// Share of the radius by which a point may lie inside the body and still count as on its skin.
constexpr double kOnCoreSkin = 1e-9, kNearCoreSkin = 1e-6;

/// A triangle of a surface on which the distance to another is to be bounded: corners on a core,
/// each carried `radius` along its unit direction. A flat triangle has radius 0.
struct Patch {
  std::array<Vec3, 3> points, directions;
  std::uint32_t vertex = kNoVertex;  ///< of the core, for patches of the ball about it
  std::uint32_t near = 0;            ///< a triangle of the other surface that was closest

  static constexpr std::uint32_t kNoVertex = 0xffffffffu;

  Vec3 foot() const { return (points[0] + points[1] + points[2]) / 3.0; }
  Vec3 direction() const { return (directions[0] + directions[1] + directions[2]).normalized(); }
  double spread_of_directions() const {
    const Vec3 middle = direction();
    double result = 0.0;
    for (const Vec3& d : directions) result = std::max(result, (d - middle).norm());
    return result;
  }
  /// No point of the patch is farther from its centre.
  double reach(double radius) const {
    const Vec3 middle = foot();
    double result = 0.0;
    for (const Vec3& p : points) result = std::max(result, (p - middle).norm());
    return radius > 0.0 ? result + radius * spread_of_directions() : result;
  }
  /// No point of the patch is farther from triangle `t` of `tree`: a distance to something convex
  /// is largest at a corner of the flat triangle, which the patch leaves by at most its sagitta.
  double farthest_from(const TriangleTree& tree, std::uint32_t t, double radius) const {
    double result = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      result = std::max(result, tree.distance_to(t, points[k] + radius * directions[k]));
    }
    if (radius == 0.0) return result;
    const double spread = spread_of_directions();
    return result + 0.5 * radius * spread * spread;
  }
  std::array<Patch, 4> quarters() const {
    std::array<Vec3, 3> p, d;  // middle of the side from corner k to k + 1
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = 0.5 * (points[k] + points[(k + 1) % 3]);
      d[k] = (directions[k] + directions[(k + 1) % 3]).normalized();
    }
    return {{{{points[0], p[0], p[2]}, {directions[0], d[0], d[2]}, vertex, near},
             {{points[1], p[1], p[0]}, {directions[1], d[1], d[0]}, vertex, near},
             {{points[2], p[2], p[1]}, {directions[2], d[2], d[1]}, vertex, near},
             {{p[0], p[1], p[2]}, {d[0], d[1], d[2]}, vertex, near}}};
  }
};

/// Bounds for one patch.
struct Bounded {
  double at_centre = 0.0;  ///< distance there, where `counts`
  double most = 0.0;       ///< no point of the patch has a larger one; negative: it has none at all
  bool counts = true;      ///< the centre belongs to the surface
};

/// Branch and bound: an upper bound of the largest distance over all patches, by at most `gap` (m)
/// too large unless `kMaxPatches` ends the search.
template <typename Bound>
double largest_over(std::vector<Patch> patches, double known, double gap, const Bound& bound) {
  struct Open {
    double most;
    std::size_t index;
    bool operator<(const Open& other) const {
      return most < other.most || (most == other.most && index > other.index);
    }
  };
  std::priority_queue<Open> open;
  std::size_t first = 0;
  const auto look = [&] {
    for (; first < patches.size(); ++first) {
      const Bounded found = bound(patches[first], known);
      if (found.counts) known = std::max(known, found.at_centre);
      if (found.most > known) open.push({found.most, first});
    }
  };
  look();
  while (!open.empty() && open.top().most > known + gap && patches.size() < kMaxPatches) {
    const std::array<Patch, 4> quarters = patches[open.top().index].quarters();
    open.pop();
    patches.insert(patches.end(), quarters.begin(), quarters.end());
    look();
  }
  return open.empty() ? known : std::max(known, open.top().most);
}

/// Upper bound of the distance of a flat patch of the scan from the rounded surface, from the plane
/// of the core face nearest to the patch centre. If no part of the core nearby is above that plane,
/// the rounded surface over it is exposed: a point inside the body is at most its depth below the
/// raised plane away from it.
std::optional<double> most_by_plane(const Patch& patch, const TriangleTree& core, double radius,
                                    double in_plane) {
  const Vec3& normal = core.face_normal(patch.near);
  const double height = normal.dot(core.first_vertex(patch.near));
  double deepest = 0.0;
  for (const Vec3& point : patch.points) {
    deepest = std::max(deepest, radius - (normal.dot(point) - height));
  }
  const Vec3 centre = patch.foot();
  const Vec3 raised = centre + (radius - (normal.dot(centre) - height)) * normal;
  if (core.has_point_above(normal, height + in_plane, raised, patch.reach(0.0) + radius)) {
    return std::nullopt;
  }
  const double outside = patch.farthest_from(core, patch.near, 0.0) - radius;
  return std::max(deepest + in_plane, outside);
}

std::vector<Patch> patches_of(const TriangleMesh& mesh) {
  std::vector<Patch> patches;
  patches.reserve(mesh.triangles.size());
  const Vec3 none = Vec3::UnitX();
  for (const auto& [a, b, c] : mesh.triangles) {
    patches.push_back({{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, {none, none, none}});
  }
  return patches;
}

/// Patches that hold the skin of a body: faces moved out, strips over edges, balls over vertices.
/// What of them is buried in the body is left to the search.
std::vector<Patch> skin_patches(const TriangleMesh& core, double radius) {
  std::vector<Patch> patches;
  std::vector<Vec3> normals;
  for (const TriangleMesh::Triangle& t : core.triangles) {
    const Vec3 n = unit_normal(core, t);
    normals.push_back(n);
    if (n.isZero()) continue;
    patches.push_back({{core.vertices[t[0]], core.vertices[t[1]], core.vertices[t[2]]}, {n, n, n}});
  }
  if (radius == 0.0) return patches;

  const auto strip = [&](const Vec3& p, const Vec3& q, const Vec3& n1, const Vec3& n2) {
    patches.push_back({{p, q, q}, {n1, n1, n2}});
    patches.push_back({{p, q, p}, {n1, n2, n2}});
  };
  const std::vector<HalfEdge> sorted = sorted_half_edges(core);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() != 2) return;
    const Vec3& p = core.vertices[sides[0].from()];
    const Vec3& q = core.vertices[sides[1].from()];
    const Vec3& n1 = normals[sides[0].triangle];
    const Vec3& n2 = normals[sides[1].triangle];
    const Vec3 along = (q - p).normalized();
    if (n1.isZero() || n2.isZero() || along.dot(n1.cross(n2)) < 0.0) return;  // reflex
    const Vec3 middle = (n1 + n2 + 1e-6 * along.cross(n1)).normalized();
    strip(p, q, n1, middle);
    strip(p, q, middle, n2);
  });

  for (std::uint32_t v = 0; v < core.vertices.size(); ++v) {
    const Vec3& p = core.vertices[v];
    for (int octant = 0; octant < 8; ++octant) {
      const Vec3 x = (octant & 1 ? -1.0 : 1.0) * Vec3::UnitX();
      const Vec3 y = (octant & 2 ? -1.0 : 1.0) * Vec3::UnitY();
      const Vec3 z = (octant & 4 ? -1.0 : 1.0) * Vec3::UnitZ();
      patches.push_back({{p, p, p}, {x, y, z}, v});
    }
  }
  return patches;
}

/// Unit directions of the edges that leave each vertex.
std::vector<std::vector<Vec3>> edge_directions(const TriangleMesh& core) {
  std::vector<std::vector<Vec3>> result(core.vertices.size());
  for (const TriangleMesh::Triangle& t : core.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 edge = core.vertices[t[(k + 1) % 3]] - core.vertices[t[k]];
      if (edge.squaredNorm() > 0.0) result[t[k]].push_back(edge.normalized());
    }
  }
  return result;
}

double skin_to_scan(const ScanSurface& scan, const TriangleMesh& core, const TriangleTree& tree,
                    double radius, double gap) {
  const std::vector<std::vector<Vec3>> edges = edge_directions(core);
  return largest_over(skin_patches(core, radius), 0.0, gap, [&](Patch& patch, double known) {
    const Bounded none{0.0, -1.0, false};
    if (patch.vertex != Patch::kNoVertex) {
      // The vertex is the closest core point only in directions that lead away from all its edges.
      const Vec3 direction = patch.direction();
      const double spread = patch.spread_of_directions();
      for (const Vec3& edge : edges[patch.vertex]) {
        if (direction.dot(edge) > spread) return none;
      }
    }
    const Vec3 centre = patch.foot() + radius * patch.direction();
    const double reach = patch.reach(radius);
    const TriangleTree::Closest on_scan = scan.tree().closest_point(centre, patch.near);
    patch.near = on_scan.triangle;
    const double distance = std::sqrt(on_scan.squared_distance);
    double most = distance + reach;
    if (most <= known) return none;
    most = std::min(most, patch.farthest_from(scan.tree(), patch.near, radius));
    if (most <= known || radius == 0.0) return Bounded{distance, most};
    const double from_core = tree.signed_distance(centre);
    if (from_core + reach < (1.0 - kOnCoreSkin) * radius) return none;
    return Bounded{distance, most, from_core >= (1.0 - kNearCoreSkin) * radius};
  });
}

}  // namespace

SurfaceDeviation measure_surface_deviation(const ScanSurface& scan, const SpheroPolyhedron& body,
                                           std::size_t samples) {
  if (body.faces.empty()) {
    throw GeometryError("a deviation needs two surfaces, but the body has none");
  }
  const TriangleMesh core = core_mesh(body);
  const TriangleTree tree(core);
  Bounds both = bounds(scan.mesh());
  const double gap = kGap * both.diagonal();
  for (const Vec3& vertex : core.vertices) both.include(vertex);
  const double in_plane = kInFacePlane * both.diagonal();
  const shapes_detail::RoundedSurfaceDistance skin(tree, body.radius,
                                                   both.diagonal() + body.radius);

  SurfaceDeviation result;
  double sum = 0.0, known = 0.0;
  std::uint32_t hint = 0;  // neighbours in the list are mostly neighbours in space
  const std::vector<Vec3> on_scan = sample_surface(scan.mesh(), std::max<std::size_t>(samples, 1));
  for (const Vec3& point : on_scan) {
    const double distance = std::abs(skin(point, hint));
    sum += distance;
    known = std::max(known, distance);
  }
  result.mean = sum / static_cast<double>(on_scan.size());
  // Corners stick out farthest: knowing them first leaves little to search.
  for (const Vec3& vertex : scan.mesh().vertices) {
    known = std::max(known, std::abs(skin(vertex, hint)));
  }
  result.scan_to_body =
      largest_over(patches_of(scan.mesh()), known, gap, [&](Patch& patch, double) {
        const double distance = skin(patch.foot(), patch.near);
        const double reach = patch.reach(0.0);
        double most = std::abs(distance) + reach;
        if (distance >= reach || body.radius == 0.0) {  // nowhere under the skin
          most = std::min(most, patch.farthest_from(tree, patch.near, 0.0) - body.radius);
        } else if (const auto flat = most_by_plane(patch, tree, body.radius, in_plane)) {
          most = std::min(most, *flat);
        }
        return Bounded{std::abs(distance), most};
      });
  result.body_to_scan = skin_to_scan(scan, core, tree, body.radius, gap);
  result.hausdorff = std::max(result.scan_to_body, result.body_to_scan);
  return result;
}

}  // namespace clast
