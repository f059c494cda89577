#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "core/error.hpp"
#include "mesh/half_edges.hpp"
#include "shapes/edge_convexity.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

namespace {

/// Angle below which two directions at a core vertex are one skin vertex, rad.
constexpr double kSameDirection = 1e-7;

using Index = std::uint32_t;
using Loop = std::vector<Index>;

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Unit vector at share `t` of the way from unit `a` to unit `b`.
Vec3 turned(const Vec3& a, const Vec3& b, double t) {
  const double angle = angle_between(a, b);
  if (angle < kSameDirection) return a;
  const Vec3 ahead = (b - a.dot(b) * a).normalized();
  return std::cos(t * angle) * a + std::sin(t * angle) * ahead;
}

/// Builds the rounded layer. Points have a core vertex and a direction, so that patches share them.
class SkinBuilder {
 public:
  SkinBuilder(const SpheroPolyhedron& shape, int segments)
      : shape_(shape), segments_(segments), skin_points_(shape.vertices.size()) {
    normals_.reserve(shape.faces.size());
    for (const SpheroPolyhedron::Face& face : shape.faces) {
      normals_.push_back(face_normal(shape, face));
    }
  }

  TriangleMesh built() {
    find_neighbours();
    add_faces();
    for (Index f = 0; f < shape_.faces.size(); ++f) {
      for (Index k = 0; k < shape_.faces[f].size(); ++k) {
        if (vertex(f, k) < vertex(f, k + 1)) add_strip(f, k);
      }
    }
    add_patches();
    return std::move(mesh_);
  }

 private:
  Index vertex(Index face, Index corner) const {
    const SpheroPolyhedron::Face& f = shape_.faces[face];
    return f[corner % f.size()];
  }

  void find_neighbours() {
    for (const SpheroPolyhedron::Face& face : shape_.faces) neighbours_.emplace_back(face.size());
    const std::vector<HalfEdge> sides = sorted_half_edges(shape_.faces);
    for_each_edge(sides, [&](std::span<const HalfEdge> shared) {
      if (!is_interior_edge(shared)) {
        throw GeometryError("the core is not a closed surface at its edge between vertices " +
                            std::to_string(shared[0].low + 1) + " and " +
                            std::to_string(shared[0].high + 1) +
                            "; only a closed core has a rounded skin");
      }
      neighbours_[shared[0].triangle][shared[0].side] = {shared[1].triangle, shared[1].side};
      neighbours_[shared[1].triangle][shared[1].side] = {shared[0].triangle, shared[0].side};
    });
  }

  Index point(Index core_vertex, const Vec3& direction) {
    for (const auto& [known, index] : skin_points_[core_vertex]) {
      if ((known - direction).norm() < kSameDirection) return index;
    }
    const auto index = static_cast<Index>(mesh_.vertices.size());
    mesh_.vertices.push_back(shape_.vertices[core_vertex] + shape_.radius * direction);
    skin_points_[core_vertex].push_back({direction, index});
    return index;
  }

  void add_triangle(Index a, Index b, Index c) {
    if (a != b && b != c && c != a) mesh_.triangles.push_back({a, b, c});
  }

  void add_faces() {
    const TriangleMesh core = core_mesh(shape_);
    auto triangle = core.triangles.begin();
    for (Index f = 0; f < shape_.faces.size(); ++f) {
      for (std::size_t k = 2; k < shape_.faces[f].size(); ++k) {
        const auto& [a, b, c] = *triangle++;
        add_triangle(point(a, normals_[f]), point(b, normals_[f]), point(c, normals_[f]));
      }
    }
  }

  /// Directions over the edge at `corner`, from the normal of `face` to that of its neighbour. A
  /// reflex edge has no skin of its own: one straight piece closes the surface.
  std::vector<Vec3> arc(Index face, Index corner) const {
    const Vec3 &from = normals_[face], &to = normals_[neighbours_[face][corner].first];
    const Vec3 along =
        shape_.vertices[vertex(face, corner + 1)] - shape_.vertices[vertex(face, corner)];
    const double angle = angle_between(from, to);
    const bool reflex =
        edge_convexity(from, to, along.cross(to).normalized()) == EdgeConvexity::kReflex;
    const int pieces = reflex ? 1 : std::max(1, static_cast<int>(std::ceil(angle / step() - 1e-9)));
    std::vector<Vec3> directions = {from};
    for (int i = 1; i < pieces; ++i) directions.push_back(turned(from, to, double(i) / pieces));
    directions.push_back(to);
    return directions;
  }

  double step() const { return 0.5 * kPi / segments_; }

  void add_strip(Index face, Index corner) {
    const Index p = vertex(face, corner), q = vertex(face, corner + 1);
    const std::vector<Vec3> directions = arc(face, corner);
    for (std::size_t i = 1; i < directions.size(); ++i) {
      const Index p0 = point(p, directions[i - 1]), p1 = point(p, directions[i]);
      const Index q0 = point(q, directions[i - 1]), q1 = point(q, directions[i]);
      add_triangle(p0, p1, q1);
      add_triangle(p0, q1, q0);
    }
  }

  /// One patch per fan of faces around a vertex, over the arcs between their normals.
  void add_patches() {
    std::vector<std::vector<bool>> done;
    for (const SpheroPolyhedron::Face& face : shape_.faces) done.emplace_back(face.size(), false);
    for (Index f = 0; f < shape_.faces.size(); ++f) {
      for (Index k = 0; k < shape_.faces[f].size(); ++k) {
        if (done[f][k]) continue;
        std::vector<Vec3> loop;
        Index face = f, corner = k;
        do {  // counter-clockwise: over the side that arrives at this corner
          done[face][corner] = true;
          const Index size = static_cast<Index>(shape_.faces[face].size());
          const Index arriving = (corner + size - 1) % size;
          const auto [next, side] = neighbours_[face][arriving];
          const std::vector<Vec3> over = arc(face, arriving);
          loop.insert(loop.end(), over.begin(), over.end() - 1);
          face = next;
          corner = side;
        } while (face != f || corner != k);
        add_patch(vertex(f, k), loop);
      }
    }
  }

  using Rim = std::vector<std::pair<Index, Vec3>>;  ///< points and their directions

  /// Removes back-and-forth runs of a loop, as over both sides of a straight edge, without area.
  Rim rim_of(Index core_vertex, const std::vector<Vec3>& loop) {
    Rim rim;
    for (const Vec3& direction : loop) {
      const Index index = point(core_vertex, direction);
      if (!rim.empty() && rim.back().first == index) continue;
      if (rim.size() > 1 && rim[rim.size() - 2].first == index) {
        rim.pop_back();
      } else {
        rim.emplace_back(index, direction);
      }
    }
    const auto shrinks = [&] {
      return rim.size() > 1 &&
             (rim.front().first == rim.back().first ||
              (rim.size() > 2 && (rim[1].first == rim.back().first ||
                                  rim.front().first == rim[rim.size() - 2].first)));
    };
    while (shrinks()) {
      if (rim.front().first == rim.back().first) {
        rim.pop_back();
      } else if (rim[1].first == rim.back().first) {
        rim.erase(rim.begin());
      } else {
        rim.pop_back();
      }
    }
    return rim;
  }

  void add_patch(Index core_vertex, const std::vector<Vec3>& loop) {
    const Rim rim = rim_of(core_vertex, loop);
    if (rim.size() < 3) return;
    if (rim.size() == 3) return add_triangle(rim[0].first, rim[1].first, rim[2].first);

    Vec3 centre = Vec3::Zero();
    for (std::size_t i = 0; i < rim.size(); ++i) {
      centre += rim[i].second.cross(rim[(i + 1) % rim.size()].second);
    }
    if (centre.norm() < kSameDirection) centre = rim[0].second;
    centre.normalize();
    double widest = 0.0;
    for (const auto& [index, direction] : rim) {
      widest = std::max(widest, angle_between(centre, direction));
    }
    const int rings = std::max(1, static_cast<int>(std::ceil(widest / step() - 1e-9)));
    Loop outer;
    for (const auto& [index, direction] : rim) outer.push_back(index);
    for (int ring = rings - 1; ring > 0; --ring) {
      Loop inner;
      for (const auto& [index, direction] : rim) {
        inner.push_back(fresh(core_vertex, turned(centre, direction, double(ring) / rings)));
      }
      for (std::size_t i = 0; i < rim.size(); ++i) {
        const std::size_t j = (i + 1) % rim.size();
        add_triangle(outer[i], outer[j], inner[j]);
        add_triangle(outer[i], inner[j], inner[i]);
      }
      outer = inner;
    }
    const Index top = fresh(core_vertex, centre);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      add_triangle(outer[i], outer[(i + 1) % rim.size()], top);
    }
  }

  /// A point of its own: a patch that folds must not be sewn to itself.
  Index fresh(Index core_vertex, const Vec3& direction) {
    mesh_.vertices.push_back(shape_.vertices[core_vertex] + shape_.radius * direction);
    return static_cast<Index>(mesh_.vertices.size() - 1);
  }

  const SpheroPolyhedron& shape_;
  int segments_;
  TriangleMesh mesh_;
  std::vector<Vec3> normals_;
  std::vector<std::vector<std::pair<Vec3, Index>>> skin_points_;
  std::vector<std::vector<std::pair<Index, Index>>> neighbours_;
};

/// Ball or capsule: rings of points around the axis from `bottom` to `top`, poles at both ends.
TriangleMesh capsule_skin(const Vec3& bottom, const Vec3& top, double radius, int segments) {
  const Vec3 axis = bottom == top ? Vec3(Vec3::UnitZ()) : Vec3((top - bottom).normalized());
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  const Index around = static_cast<Index>(4 * segments);
  TriangleMesh mesh;
  mesh.vertices.push_back(bottom - radius * axis);
  const auto add_ring = [&](const Vec3& centre, double latitude) {
    for (Index i = 0; i < around; ++i) {
      const double longitude = 2.0 * kPi * i / around;
      const Vec3 outward = std::cos(longitude) * u + std::sin(longitude) * v;
      mesh.vertices.push_back(centre +
                              radius * (std::cos(latitude) * outward + std::sin(latitude) * axis));
    }
  };
  const int southern = bottom == top ? -1 : 0;  // the equator is there twice on a capsule
  for (int i = 1 - segments; i <= southern; ++i) add_ring(bottom, 0.5 * kPi * i / segments);
  for (int i = 0; i < segments; ++i) add_ring(top, 0.5 * kPi * i / segments);
  mesh.vertices.push_back(top + radius * axis);

  const auto last = static_cast<Index>(mesh.vertices.size() - 1);
  const Index rings = (last - 1) / around;
  for (Index i = 0; i < around; ++i) {
    const Index j = (i + 1) % around;
    mesh.triangles.push_back({0, 1 + j, 1 + i});
    for (Index ring = 1; ring < rings; ++ring) {
      const Index low = 1 + (ring - 1) * around, high = low + around;
      mesh.triangles.push_back({low + i, low + j, high + j});
      mesh.triangles.push_back({low + i, high + j, high + i});
    }
    mesh.triangles.push_back({last - around + i, last - around + j, last});
  }
  return mesh;
}

}  // namespace

TriangleMesh rounded_surface_mesh(const SpheroPolyhedron& shape, int segments) {
  if (segments < 1) {
    throw InputError("segments = " + std::to_string(segments) +
                     ": a quarter circle needs at least one segment");
  }
  if (shape.faces.empty()) {
    const std::size_t count = shape.vertices.size();
    if (count == 0 || count > 2 || !(shape.radius > 0.0)) {
      throw GeometryError(
          "a core without faces has a skin only as a ball (1 vertex) or a capsule " +
          std::string("(2 vertices) with a radius; this one has ") + std::to_string(count) +
          " vertices");
    }
    return capsule_skin(shape.vertices.front(), shape.vertices.back(), shape.radius, segments);
  }
  if (shape.radius == 0.0) return core_mesh(shape);
  return SkinBuilder(shape, segments).built();
}

}  // namespace clast
