#include "shapes/convex_hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "core/error.hpp"
#include "shapes/convex_outline.hpp"

namespace clast {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using HullMesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Points thinner than this share of their extent are a plane, a line or a place: thinner than the
// rounding of map coordinates.
constexpr double kFlatHull = 1e-12;

bool is_before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// The point for which `measure` is largest, the first of equals.
template <class Measure>
Vec3 farthest(std::span<const Vec3> points, const Measure& measure) {
  return *std::max_element(points.begin(), points.end(),
                           [&](const Vec3& a, const Vec3& b) { return measure(a) < measure(b); });
}

void check_finite(std::span<const Vec3> points) {
  for (const Vec3& p : points) {
    if (!p.allFinite())
      throw GeometryError("convex hull: a point has coordinates that are not finite");
  }
}

/// Corners of the outline of sorted points that lie in a plane or on a line.
std::vector<Vec3> flat_corners(const std::vector<Vec3>& points, const Mat3& axes) {
  struct Flat {
    Vec2 place;
    Vec3 point;
  };
  std::vector<Flat> flat;
  std::vector<Vec2> places;
  for (const Vec3& p : points) {
    const Vec3 local = p - points.front();
    places.emplace_back(axes.col(0).dot(local), axes.col(1).dot(local));
    flat.push_back({places.back(), p});
  }
  std::vector<Vec3> corners;
  for (const Vec2& corner : convex_hull_2d(std::move(places))) {
    const auto found =
        std::find_if(flat.begin(), flat.end(), [&](const Flat& f) { return f.place == corner; });
    corners.push_back(found->point);
  }
  return sorted_unique_points(corners);
}

/// The corners of every flat face of a hull, seen from outside counterclockwise. CGAL has cut faces
/// of more than three corners into triangles, in an order that follows from places in memory; put
/// together again they are the same in every run.
std::vector<std::vector<HullMesh::Vertex_index>> outlines(const HullMesh& hull) {
  using Vertex = HullMesh::Vertex_index;
  using Face = HullMesh::Face_index;
  const auto corners = [&](Face face) {
    std::array<Vertex, 3> three;
    std::size_t i = 0;
    for (const Vertex v : hull.vertices_around_face(hull.halfedge(face))) three[i++] = v;
    return three;
  };
  std::vector<std::vector<Vertex>> found;
  std::vector<bool> done(hull.number_of_faces(), false);
  for (const Face seed : hull.faces()) {
    const auto [a, b, c] = corners(seed);
    const auto &p = hull.point(a), &q = hull.point(b), &r = hull.point(c);
    if (done[seed] || CGAL::collinear(p, q, r)) continue;
    const auto in_plane = [&](Face face) {
      const std::array<Vertex, 3> three = corners(face);
      return std::all_of(three.begin(), three.end(),
                         [&](Vertex v) { return CGAL::coplanar(p, q, r, hull.point(v)); });
    };
    std::vector<Face> open = {seed};
    done[seed] = true;
    std::map<Vertex, Vertex> next;  // along the border
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      for (const auto edge : hull.halfedges_around_face(hull.halfedge(face))) {
        const Face beside = hull.face(hull.opposite(edge));
        if (!in_plane(beside)) {
          next[hull.source(edge)] = hull.target(edge);
        } else if (!done[beside]) {
          done[beside] = true;
          open.push_back(beside);
        }
      }
    }
    std::vector<Vertex> border = {next.begin()->first}, outline;
    while (next[border.back()] != border.front()) border.push_back(next[border.back()]);
    for (std::size_t i = 0; i < border.size(); ++i) {
      const Vertex before = border[(i + border.size() - 1) % border.size()];
      const Vertex after = border[(i + 1) % border.size()];
      if (CGAL::collinear(hull.point(before), hull.point(border[i]), hull.point(after))) continue;
      outline.push_back(border[i]);
    }
    found.push_back(std::move(outline));
  }
  return found;
}

/// Triangles start at their smallest vertex and ascend.
void sort_triangles(TriangleMesh& mesh) {
  for (auto& t : mesh.triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(mesh.triangles.begin(), mesh.triangles.end());
}

}  // namespace

std::vector<Vec3> sorted_unique_points(std::span<const Vec3> points) {
  std::vector<Vec3> sorted(points.begin(), points.end());
  // A zero of either sign is the same place.
  for (Vec3& p : sorted) p += Vec3::Zero();
  std::sort(sorted.begin(), sorted.end(), is_before);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

AffineSpan affine_span(std::span<const Vec3> points) {
  AffineSpan span;
  if (points.empty()) return span;
  const Vec3 origin = *std::min_element(points.begin(), points.end(), is_before);
  const Vec3 far = farthest(points, [&](const Vec3& p) { return (p - origin).norm(); });
  const double extent = (far - origin).norm();
  if (!(extent > 0.0)) return span;
  const Vec3 along = (far - origin) / extent;
  span.dimension = 1;
  span.axes.col(0) = along;
  span.axes.col(1) = along.unitOrthogonal();
  span.axes.col(2) = along.cross(span.axes.col(1));

  const auto beside = [&](const Vec3& p) {
    return Vec3(p - origin - (p - origin).dot(along) * along);
  };
  const Vec3 offset = beside(farthest(points, [&](const Vec3& p) { return beside(p).norm(); }));
  if (!(offset.norm() > kFlatHull * extent)) return span;
  span.dimension = 2;
  span.axes.col(1) = (offset - offset.dot(along) * along).normalized();
  const Vec3 normal = along.cross(span.axes.col(1));
  span.axes.col(2) = normal;

  const auto height = [&](const Vec3& p) { return std::abs((p - origin).dot(normal)); };
  if (height(farthest(points, height)) > kFlatHull * extent) span.dimension = 3;
  return span;
}

std::vector<Vec3> extreme_points(std::span<const Vec3> points) {
  check_finite(points);
  const std::vector<Vec3> sorted = sorted_unique_points(points);
  const AffineSpan span = affine_span(sorted);
  if (span.dimension == 3) return convex_hull(sorted).vertices;
  if (span.dimension == 2) return flat_corners(sorted, span.axes);
  // Along a line the order by x, y, z is the order along it.
  if (span.dimension == 1) return {sorted.front(), sorted.back()};
  return sorted;
}

TriangleMesh convex_hull(std::span<const Vec3> points) {
  check_finite(points);
  const std::vector<Vec3> sorted = sorted_unique_points(points);
  const int dimension = affine_span(sorted).dimension;
  if (sorted.size() < 4 || dimension < 3) {
    const char* what = dimension == 2   ? "in one plane"
                       : dimension == 1 ? "on one line"
                                        : "at one point";
    throw GeometryError("convex hull: the " + std::to_string(points.size()) + " points are all " +
                        what + ", so they enclose no volume");
  }
  std::vector<Kernel::Point_3> input;
  input.reserve(sorted.size());
  for (const Vec3& p : sorted) input.emplace_back(p.x(), p.y(), p.z());
  HullMesh hull;
  CGAL::convex_hull_3(input.begin(), input.end(), hull);

  const auto place = [&](HullMesh::Vertex_index v) {
    const auto& point = hull.point(v);
    return Vec3(point.x(), point.y(), point.z());
  };
  const std::vector<std::vector<HullMesh::Vertex_index>> faces = outlines(hull);
  TriangleMesh mesh;
  for (const auto& face : faces) {
    for (const auto v : face) mesh.vertices.push_back(place(v));
  }
  mesh.vertices = sorted_unique_points(mesh.vertices);
  for (const auto& face : faces) {
    std::vector<std::uint32_t> corners;
    for (const auto v : face) {
      const auto found =
          std::lower_bound(mesh.vertices.begin(), mesh.vertices.end(), place(v), is_before);
      corners.push_back(static_cast<std::uint32_t>(found - mesh.vertices.begin()));
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    for (std::size_t i = 2; i < corners.size(); ++i) {
      mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  sort_triangles(mesh);
  return mesh;
}

}  // namespace clast
