#include "terrain/repair/simplification.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/sub_mesh.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "terrain/plan_index.hpp"

namespace clast::terrain_detail {
namespace {

constexpr double kSteep = 0.05;  // cosine to the vertical: walls steeper than 87 degrees stay

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
/// The vertex over or under a face that is farthest off it.
struct Farthest {
  double error = 0.0;  ///< m
  std::uint32_t vertex = 0;
};
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<Farthest, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// Triangles that must stay: overhangs, walls, and all whose plan boxes they reach into.
std::vector<bool> kept_triangles(const TriangleMesh& mesh) {
  std::vector<bool> kept(mesh.triangles.size(), false);
  const std::vector<PlanBox> boxes = plan_boxes(mesh);
  std::vector<PlanBox> steep;
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    const Vec3 area = doubled_area_vector(mesh, mesh.triangles[t]);
    if (area.z() <= kSteep * area.norm()) steep.push_back(boxes[t]);
  }
  if (steep.empty()) return kept;
  const PlanIndex index(steep);
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    for (const std::uint32_t s : index.boxes_near(boxes[t])) {
      kept[t] = kept[t] || ((steep[s].low.array() <= boxes[t].high.array()).all() &&
                            (steep[s].high.array() >= boxes[t].low.array()).all());
    }
  }
  return kept;
}

/// The triangulation that grows, in rounds, by what is farthest off.
class Growing {
 public:
  /// @param edges   of the old surface, apart from those that stay
  /// @param length  of a usual edge, m
  Growing(const std::vector<Vec3>& vertices, std::span<const EdgeKey> edges, double length,
          double tolerance)
      : vertices_(vertices),
        edges_(edges),
        length_(length),
        tolerance_(tolerance),
        handles_(vertices.size()),
        edge_index_(boxes_of(vertices, edges)) {}

  void constrain(const EdgeKey& edge) {
    triangulation_.insert_constraint(handle(edge[0]), handle(edge[1]));
  }

  /// Brings in vertices that are off by more than the tolerance; where edges cross that far apart,
  /// an end of the old one, or, with both there, the edge itself: at worst the old triangles come
  /// back. Two surfaces of triangles are farthest apart over a vertex or a crossing of edges, so
  /// that then they are nowhere farther apart.
  void grow(std::span<const std::uint32_t> vertices) {
    for (;;) {
      largest_ = 0.0;
      const std::vector<std::uint32_t> wanted = far_vertices(vertices);
      for (const std::uint32_t v : wanted) handle(v);
      if (!wanted.empty()) continue;
      const std::vector<std::uint32_t> crossed = far_edges();
      if (crossed.empty()) return;
      for (const std::uint32_t i : crossed) {
        const EdgeKey& edge = edges_[i];
        if (!is_in(edge[0])) {
          handle(edge[0]);
        } else if (!is_in(edge[1])) {
          handle(edge[1]);
        } else {
          constrain(edge);
        }
      }
    }
  }

  const Triangulation& triangulation() const { return triangulation_; }
  /// Largest vertical distance of the two surfaces, anywhere, and a place of it.
  double largest() const { return largest_; }
  const Vec3& largest_at() const { return largest_at_; }

 private:
  static std::vector<PlanBox> boxes_of(const std::vector<Vec3>& vertices,
                                       std::span<const EdgeKey> edges) {
    std::vector<PlanBox> boxes(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (const std::uint32_t v : edges[i]) boxes[i].include(vertices[v].head<2>());
    }
    return boxes;
  }

  bool is_in(std::uint32_t v) const { return handles_[v] != Triangulation::Vertex_handle(); }

  Triangulation::Vertex_handle handle(std::uint32_t v) {
    if (!is_in(v)) {
      // Faces come and go; a vertex stays, and with it some face to begin the search at.
      const bool is_first = last_ == Triangulation::Vertex_handle();
      handles_[v] = triangulation_.insert({vertices_[v].x(), vertices_[v].y()},
                                          is_first ? Triangulation::Face_handle() : last_->face());
      handles_[v]->info() = v;
      last_ = handles_[v];
    }
    return handles_[v];
  }

  void note(double off, const Vec3& at) {
    if (off <= largest_) return;
    largest_ = off;
    largest_at_ = at;
  }

  double error(const Vec3& point, const Triangulation::Face_handle& face) const {
    const Vec3& a = vertices_[face->vertex(0)->info()];
    const Vec3 ab = vertices_[face->vertex(1)->info()] - a;
    const Vec3 ac = vertices_[face->vertex(2)->info()] - a;
    const Vec3 ap = point - a;
    const Vec2 plan_ab = ab.head<2>(), plan_ac = ac.head<2>(), plan_ap = ap.head<2>();
    const double area = cross(plan_ab, plan_ac);
    const double v = cross(plan_ap, plan_ac) / area, w = cross(plan_ab, plan_ap) / area;
    return std::abs(ap.z() - v * ab.z() - w * ac.z());
  }

  /// Farthest vertex of each face, if beyond the tolerance; ascending.
  std::vector<std::uint32_t> far_vertices(std::span<const std::uint32_t> vertices) {
    for (auto face = triangulation_.all_faces_begin(); face != triangulation_.all_faces_end();
         ++face) {
      face->info() = {};
    }
    Triangulation::Face_handle near;
    for (const std::uint32_t v : vertices) {
      if (is_in(v)) continue;
      const Vec3& point = vertices_[v];
      near = triangulation_.locate({point.x(), point.y()}, near);
      if (triangulation_.is_infinite(near)) continue;
      const double off = error(point, near);
      note(off, point);
      if (off > tolerance_ && off > near->info().error) near->info() = {off, v};
    }
    std::vector<std::uint32_t> wanted;
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end();
         ++face) {
      if (face->info().error > 0.0) wanted.push_back(face->info().vertex);
    }
    std::sort(wanted.begin(), wanted.end());
    return wanted;
  }

  /// For each new edge, the old edge that it crosses at the largest distance, if beyond the
  /// tolerance; ascending, unique.
  std::vector<std::uint32_t> far_edges() {
    std::vector<std::uint32_t> wanted;
    for (auto edge = triangulation_.finite_edges_begin(); edge != triangulation_.finite_edges_end();
         ++edge) {
      if (triangulation_.is_constrained(*edge)) continue;  // an old one: no other crosses it
      const EdgeKey ends = {edge->first->vertex(Triangulation::cw(edge->second))->info(),
                            edge->first->vertex(Triangulation::ccw(edge->second))->info()};
      const std::optional<std::uint32_t> farthest = farthest_across(ends);
      if (farthest) wanted.push_back(*farthest);
    }
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    return wanted;
  }

  std::optional<std::uint32_t> farthest_across(const EdgeKey& ends) {
    const Vec3 &from = vertices_[ends[0]], &to = vertices_[ends[1]];
    const Vec3 along = to - from;
    const Vec2 plan_along = along.head<2>();
    std::optional<std::uint32_t> farthest;
    double most = tolerance_;
    // Long edges are divided: their boxes would contain many distant vertices.
    const double parts = std::ceil(plan_along.norm() / (kPart * length_));
    for (double part = 0.0; part < parts; ++part) {
      PlanBox box;
      box.include((from + part / parts * along).head<2>());
      box.include((from + (part + 1.0) / parts * along).head<2>());
      for (const std::uint32_t i : edge_index_.boxes_near(box)) {
        const auto& [a, b] = edges_[i];
        if (a == ends[0] || a == ends[1] || b == ends[0] || b == ends[1]) continue;
        const Vec3 across = vertices_[b] - vertices_[a], apart = vertices_[a] - from;
        const double turn = cross(plan_along, across.head<2>());
        if (turn == 0.0) continue;
        const double t = cross(apart.head<2>(), across.head<2>()) / turn;
        const double u = cross(apart.head<2>(), plan_along) / turn;
        if (t < 0.0 || t > 1.0 || u < 0.0 || u > 1.0) continue;
        const Vec3 old = vertices_[a] + u * across;
        const double off = std::abs(old.z() - from.z() - t * along.z());
        note(off, old);
        if (off <= most) continue;
        most = off;
        farthest = i;
      }
    }
    return farthest;
  }

  static constexpr double kPart = 4.0;  // usual edges

  const std::vector<Vec3>& vertices_;
  std::span<const EdgeKey> edges_;
  double length_;
  double tolerance_;
  Triangulation triangulation_;
  std::vector<Triangulation::Vertex_handle> handles_;
  Triangulation::Vertex_handle last_;
  PlanIndex edge_index_;
  double largest_ = 0.0;  ///< m, in the last round
  Vec3 largest_at_ = Vec3::Zero();
};

/// Alternating row direction, so that consecutive vertices are close.
void put_in_rows(std::vector<std::uint32_t>& vertices, const std::vector<Vec3>& points,
                 double row) {
  std::vector<std::tuple<std::int64_t, double, std::uint32_t>> order;
  order.reserve(vertices.size());
  for (const std::uint32_t v : vertices) {
    const auto number = static_cast<std::int64_t>(std::floor(points[v].y() / row));
    order.emplace_back(number, number % 2 == 0 ? points[v].x() : -points[v].x(), v);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) vertices[i] = std::get<2>(order[i]);
}

/// The free triangle under a place of the plan.
std::optional<std::uint32_t> triangle_under(const TriangleMesh& mesh, const PlanIndex& index,
                                            const std::vector<bool>& kept, const Vec2& at) {
  for (const std::uint32_t t : index.boxes_near(at)) {
    if (!kept[t] && height_on_triangle(mesh, t, at)) return t;
  }
  return std::nullopt;
}

/// Part of the surface that is retriangulated: all but the triangles that are kept.
struct FreeSurface {
  std::vector<EdgeKey> constraints;     ///< borders of files, zones and triangles that stay; rising
  std::vector<EdgeKey> edges;           ///< the others
  std::vector<std::uint32_t> vertices;  ///< at no constraint; rising
};

FreeSurface free_surface(const RawSurface& surface, const std::vector<bool>& kept) {
  const TriangleMesh& mesh = surface.mesh;
  const TriangleNeighbours links = triangle_neighbours(mesh);
  std::vector<bool> fixed(mesh.vertices.size(), false), in_free(mesh.vertices.size(), false);
  FreeSurface free;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (kept[t]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      in_free[a] = true;
      const std::uint32_t other = links.neighbour[t][k];
      if (other == kNoIndex || kept[other] ||
          surface.source_file[other] != surface.source_file[t]) {
        fixed[a] = fixed[b] = true;
        free.constraints.push_back(make_edge_key(a, b));
      } else if (t < other) {
        free.edges.push_back({a, b});
      }
    }
  }
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (in_free[v] && !fixed[v]) free.vertices.push_back(v);
  }
  std::sort(free.constraints.begin(), free.constraints.end());
  free.constraints.erase(std::unique(free.constraints.begin(), free.constraints.end()),
                         free.constraints.end());
  return free;
}

/// @throws GeometryError  constraints that cross
void grow_from(Growing& growing, const std::vector<EdgeKey>& constraints,
               const std::vector<std::uint32_t>& vertices) {
  try {
    for (const EdgeKey& edge : constraints) growing.constrain(edge);
    growing.grow(vertices);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    throw GeometryError(
        "the border of the ground crosses itself in plan, so it can't be simplified; leave "
        "out tolerance, or cut the ground there");
  }
}

/// The faces that lie over free triangles of the old surface, in order of their corners, each with
/// the source of the triangle under its middle.
std::vector<std::pair<TriangleMesh::Triangle, std::uint16_t>> fresh_triangles(
    const Growing& growing, const RawSurface& surface, const std::vector<bool>& kept) {
  const TriangleMesh& mesh = surface.mesh;
  const PlanIndex index(plan_boxes(mesh));
  std::vector<std::pair<TriangleMesh::Triangle, std::uint16_t>> fresh;
  for (auto face = growing.triangulation().finite_faces_begin();
       face != growing.triangulation().finite_faces_end(); ++face) {
    TriangleMesh::Triangle corners;
    Vec2 middle = Vec2::Zero();
    for (int k = 0; k < 3; ++k) {
      corners[static_cast<std::size_t>(k)] = face->vertex(k)->info();
      middle += mesh.vertices[face->vertex(k)->info()].head<2>() / 3.0;
    }
    const std::optional<std::uint32_t> under = triangle_under(mesh, index, kept, middle);
    if (!under) continue;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    fresh.emplace_back(corners, surface.source_file[*under]);
  }
  std::sort(fresh.begin(), fresh.end());
  return fresh;
}

}  // namespace

void simplify_surface(RawSurface& surface, double tolerance, TerrainReport& report) {
  const TriangleMesh& mesh = surface.mesh;
  const std::vector<bool> kept = kept_triangles(mesh);
  FreeSurface free = free_surface(surface, kept);
  const double length = median_edge_length(mesh);
  put_in_rows(free.vertices, mesh.vertices, length);
  Growing growing(mesh.vertices, free.edges, length, tolerance);
  grow_from(growing, free.constraints, free.vertices);

  RawSurface result;
  result.mesh.vertices = mesh.vertices;
  result.crs = surface.crs;
  result.notes = surface.notes;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!kept[t]) continue;
    result.mesh.triangles.push_back(mesh.triangles[t]);
    result.source_file.push_back(surface.source_file[t]);
  }
  for (const auto& [corners, source] : fresh_triangles(growing, surface, kept)) {
    result.mesh.triangles.push_back(corners);
    result.source_file.push_back(source);
  }
  remove_unused_vertices(result.mesh);
  std::string note = "simplified within " + format_significant(tolerance, 4) +
                     " m: " + std::to_string(result.mesh.triangles.size()) + " of " +
                     std::to_string(mesh.triangles.size()) +
                     " triangles; the surface is nowhere more than " +
                     format_significant(growing.largest(), 4) + " m above or below the original";
  if (growing.largest() > 0.0) note += ", as at " + format_map_point(growing.largest_at());
  report.notes.push_back(note);
  surface = std::move(result);
}

}  // namespace clast::terrain_detail
