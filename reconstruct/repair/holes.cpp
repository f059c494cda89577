#include "reconstruct/repair/holes.hpp"

// Fairing needs a solver of sparse linear equations; Eigen is here anyway.
#define CGAL_EIGEN3_ENABLED 1
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/detail/cgal_mesh.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/mesh_topology.hpp"
#include "reconstruct/repair/detail/loop_filling.hpp"

namespace clast::reconstruct_detail {

namespace {

namespace Processing = CGAL::Polygon_mesh_processing;
using Triangle = TriangleMesh::Triangle;
using Halfedge = mesh_detail::CgalMesh::Halfedge_index;
using Face = mesh_detail::CgalMesh::Face_index;
using Vertex = mesh_detail::CgalMesh::Vertex_index;

/// Above this many border edges the search of all triangulations, cubic in them, takes minutes.
constexpr std::size_t kMaxForAllTriangulations = 400;
/// See `is_unobserved_side`: of a ball, a gap of 1 % of the surface leaves 0.03 % of the volume
/// open, one of 5 % leaves 0.7 %.
constexpr double kUnobservedFraction = 0.05, kMinUnobservedFraction = 0.01;
constexpr double kUnobservedWidth = 3.0;  ///< in mean sides of the border
/// A filling deviates from a membrane by this share of the hole's width at most: a cap of a ball
/// with a tenth of its surface does by a third, one with a seventh by this.
constexpr double kMaxBulge = 0.5;

/// The fan over `loop` from its corner `apex`.
std::vector<Triangle> fan(const std::vector<std::uint32_t>& loop, std::size_t apex) {
  std::vector<Triangle> triangles;
  const auto at = [&](std::size_t k) { return loop[(apex + k) % loop.size()]; };
  for (std::size_t k = 2; k < loop.size(); ++k) triangles.push_back({at(0), at(k - 1), at(k)});
  return triangles;
}

double area_of(const TriangleMesh& mesh, const std::vector<Triangle>& triangles) {
  double area = 0.0;
  for (const Triangle& t : triangles) area += triangle_area(mesh, t);
  return area;
}

Vec3 point_of(const mesh_detail::CgalMesh& mesh, Vertex v) {
  const mesh_detail::CgalPoint& p = mesh.point(v);
  return {p.x(), p.y(), p.z()};
}

/// Makes a star over the middle of the border and returns its middle.
Vertex star_over(mesh_detail::CgalMesh& mesh, Halfedge border) {
  std::vector<Vec3> points;
  for (const Vertex v : CGAL::vertices_around_face(border, mesh)) {
    points.push_back(point_of(mesh, v));
  }
  CGAL::Euler::fill_hole(border, mesh);
  const Vertex middle = mesh.target(CGAL::Euler::add_center_vertex(border, mesh));
  const Vec3 centre = measure_hole(points).centre;
  mesh.point(middle) = mesh_detail::CgalPoint(centre.x(), centre.y(), centre.z());
  return middle;
}

/// Six times the volume under faces, over `origin`.
double sixfold_volume(const mesh_detail::CgalMesh& mesh, const std::vector<Face>& faces,
                      const Vec3& origin) {
  double sum = 0.0;
  for (const Face f : faces) {
    std::array<Vec3, 3> corner;
    std::size_t k = 0;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      corner[k++] = point_of(mesh, v) - origin;
    }
    sum += corner[0].dot(corner[1].cross(corner[2]));
  }
  return sum;
}

double area_of(const mesh_detail::CgalMesh& mesh, const std::vector<Face>& faces) {
  double area = 0.0;
  for (const Face f : faces) area += Processing::face_area(f, mesh);
  return area;
}

std::vector<Vec3> points_of(const mesh_detail::CgalMesh& mesh,
                            const std::vector<Vertex>& vertices) {
  std::vector<Vec3> points;
  for (const Vertex v : vertices) points.push_back(point_of(mesh, v));
  return points;
}

void set_points(mesh_detail::CgalMesh& mesh, const std::vector<Vertex>& vertices,
                const std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    mesh.point(vertices[i]) = mesh_detail::CgalPoint(points[i].x(), points[i].y(), points[i].z());
  }
}

/// Moves vertices so that the patch around them bends evenly. Where triangles without an area leave
/// the equations without a solution, they go to `otherwise`: CGAL would compute on with what is no
/// number, and end the program.
/// @param continuity  0: a membrane; 1: tangential to what is around
/// @return where they are
std::vector<Vec3> fair(mesh_detail::CgalMesh& mesh, const std::vector<Vertex>& vertices,
                       unsigned continuity, const std::vector<Vec3>& otherwise) {
  Processing::fair(mesh, vertices, CGAL::parameters::fairing_continuity(continuity));
  std::vector<Vec3> points = points_of(mesh, vertices);
  const bool solved = std::all_of(points.begin(), points.end(),
                                  [](const Vec3& point) { return point.allFinite(); });
  if (solved) return points;
  set_points(mesh, vertices, otherwise);
  return otherwise;
}

/// Moves the vertices to a surface that is smooth at the border, but no farther from a membrane
/// over it than half its width. Returns six times the volume under the membrane.
double bulge(mesh_detail::CgalMesh& mesh, const std::vector<Face>& patch,
             const std::vector<Vertex>& added, const FilledHole& hole) {
  const std::vector<Vec3> membrane = fair(mesh, added, 0, points_of(mesh, added));
  const double membrane_volume = sixfold_volume(mesh, patch, hole.centre);
  const double limit = kMaxBulge * 2.0 * area_of(mesh, patch) / hole.perimeter;
  std::vector<Vec3> bulged = fair(mesh, added, 1, membrane);
  double highest = 0.0;
  for (std::size_t i = 0; i < added.size(); ++i) {
    highest = std::max(highest, (bulged[i] - membrane[i]).norm());
  }
  if (highest <= limit) return membrane_volume;
  for (std::size_t i = 0; i < added.size(); ++i) {
    bulged[i] = membrane[i] + limit / highest * (bulged[i] - membrane[i]);
  }
  set_points(mesh, added, bulged);
  return membrane_volume;
}

/// Unit normals of the triangles beyond the sides of a border, in the order of its vertices.
std::vector<Vec3> normals_beyond(const mesh_detail::CgalMesh& mesh, Halfedge border) {
  std::vector<Vec3> normals;
  for (const Halfedge h : CGAL::halfedges_around_face(border, mesh)) {
    const Halfedge inner = mesh.opposite(mesh.next(h));
    const Vec3 a = point_of(mesh, mesh.source(inner)), b = point_of(mesh, mesh.target(inner)),
               c = point_of(mesh, mesh.target(mesh.next(inner)));
    normals.push_back((b - a).cross(c - a).normalized());
  }
  return normals;
}

/// Fills one hole and sets its area (0 if it stays open) and the bounds of its volume.
/// @param points  of the border
void fill(mesh_detail::CgalMesh& mesh, Halfedge border, const std::vector<Vec3>& points,
          FilledHole& hole) {
  const TangentConeVolumes cones = tangent_cone_volumes(points, normals_beyond(mesh, border));
  std::vector<Face> patch, more;
  std::vector<Vertex> added;
  Processing::triangulate_hole(
      mesh, border, std::back_inserter(patch),
      CGAL::parameters::do_not_use_cubic_algorithm(hole.border_edges > kMaxForAllTriangulations));
  if (patch.empty()) {
    if (hole.border_edges < 3) return;
    added.push_back(star_over(mesh, border));
    for (const Face f : CGAL::faces_around_target(mesh.halfedge(added[0]), mesh)) {
      patch.push_back(f);
    }
  }
  Processing::refine(mesh, patch, std::back_inserter(more), std::back_inserter(added));
  patch.insert(patch.end(), more.begin(), more.end());
  const double membrane =
      added.empty() ? sixfold_volume(mesh, patch, hole.centre) : bulge(mesh, patch, added, hole);
  const double bulged = (sixfold_volume(mesh, patch, hole.centre) - membrane) / 6.0;
  hole.volume_below = std::max(0.0, cones.below + bulged);
  hole.volume_above = std::max(0.0, cones.above - bulged);
  hole.area = area_of(mesh, patch);
}

}  // namespace

bool is_unobserved_side(const std::vector<Vec3>& border, double seen_area) {
  Vec3 doubled = Vec3::Zero();
  double around = 0.0;
  for (std::size_t i = 0; i < border.size(); ++i) {
    const Vec3& next = border[(i + 1) % border.size()];
    doubled += (border[i] - border[0]).cross(next - border[0]);
    around += (next - border[i]).norm();
  }
  const double flat = 0.5 * doubled.norm(), fraction = flat / (seen_area + flat);
  const double sides_wide = 2.0 * flat * static_cast<double>(border.size()) / (around * around);
  return fraction > kUnobservedFraction ||
         (fraction > kMinUnobservedFraction && sides_wide > kUnobservedWidth);
}

FilledHole measure_hole(const std::vector<Vec3>& border) {
  FilledHole hole;
  hole.border_edges = border.size();
  for (std::size_t i = 0; i < border.size(); ++i) {
    hole.perimeter += (border[(i + 1) % border.size()] - border[i]).norm();
    hole.centre += border[i] / static_cast<double>(border.size());
  }
  for (const Vec3& point : border)
    hole.radius = std::max(hole.radius, (point - hole.centre).norm());
  return hole;
}

std::vector<FilledHole> fill_holes_with_fans(TriangleMesh& mesh, std::size_t max_edges) {
  std::vector<FilledHole> filled;
  std::vector<std::vector<std::uint32_t>> loops = boundary_loops(mesh);
  std::erase_if(loops,
                [&](const auto& loop) { return loop.size() > max_edges || loop.size() < 3; });
  if (loops.empty()) return filled;
  std::set<EdgeKey> edges;
  for (const HalfEdge& side : sorted_half_edges(mesh)) edges.insert({side.low, side.high});
  for (const std::vector<std::uint32_t>& loop : loops) {
    std::vector<Triangle> best;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t apex = 0; apex < loop.size(); ++apex) {
      bool crosses = false;
      for (std::size_t k = 2; k + 1 < loop.size(); ++k) {
        const std::uint32_t other = loop[(apex + k) % loop.size()];
        crosses |= edges.contains(make_edge_key(loop[apex], other));
      }
      std::vector<Triangle> candidate = fan(loop, apex);
      const double area = area_of(mesh, candidate);
      if (crosses || area >= smallest) continue;
      smallest = area;
      best = std::move(candidate);
    }
    if (best.empty()) continue;
    for (const Triangle& t : best) {
      for (std::size_t k = 0; k < 3; ++k) edges.insert(make_edge_key(t[k], t[(k + 1) % 3]));
    }
    mesh.triangles.insert(mesh.triangles.end(), best.begin(), best.end());
    std::vector<Vec3> border;
    for (const std::uint32_t v : loop) border.push_back(mesh.vertices[v]);
    filled.push_back(measure_hole(border));
    filled.back().area = smallest;
    filled.back().is_fan = true;
  }
  return filled;
}

std::vector<FilledHole> fill_holes(TriangleMesh& mesh, bool fill_unobserved_sides) {
  const double area = surface_area(mesh);
  mesh_detail::CgalMesh work = mesh_detail::to_cgal_mesh(mesh);
  std::vector<Halfedge> starts;
  Processing::extract_boundary_cycles(work, std::back_inserter(starts));
  std::vector<FilledHole> filled;
  for (const Halfedge start : starts) {
    std::vector<Vec3> border;
    for (const Vertex v : CGAL::vertices_around_face(start, work)) {
      border.push_back(point_of(work, v));
    }
    FilledHole hole = measure_hole(border);
    if (!fill_unobserved_sides && is_unobserved_side(border, area)) continue;
    try {
      fill(work, start, border, hole);
    } catch (const CGAL::Failure_exception&) {  // met something that it takes for impossible
      throw GeometryError("the hole of " + std::to_string(border.size()) +
                          " border edges and a perimeter of " +
                          format_significant(hole.perimeter, 3) +
                          " m can't be filled; close it in MeshLab or CloudCompare first");
    }
    if (hole.area > 0.0) filled.push_back(hole);
  }
  mesh = mesh_detail::from_cgal_mesh(work);
  return filled;
}

}  // namespace clast::reconstruct_detail
