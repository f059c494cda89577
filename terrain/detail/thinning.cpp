#include "terrain/detail/thinning.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "terrain/detail/mending.hpp"
#include "terrain/detail/plan_index.hpp"
#include "terrain/detail/triangle_links.hpp"

namespace clast::detail {
namespace {

constexpr double kSteep = 0.05;  // cosine to the vertical: walls steeper than 87 degrees stay

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<std::vector<std::uint32_t>, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Point = Triangulation::Point;

/// Triangles that must stay: overhangs, walls, and all whose plan boxes they reach into.
std::vector<bool> kept_triangles(const TriangleMesh& mesh) {
  std::vector<bool> kept(mesh.triangles.size(), false);
  const std::vector<PlanBox> boxes = plan_boxes(mesh);
  std::vector<PlanBox> steep;
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    const Vec3 area = area_vector(mesh, t);
    if (area.z() <= kSteep * area.norm()) steep.push_back(boxes[t]);
  }
  if (steep.empty()) return kept;
  const PlanIndex index(steep);
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    for (const std::uint32_t s : index.near(boxes[t])) {
      kept[t] = kept[t] || ((steep[s].low.array() <= boxes[t].high.array()).all() &&
                            (steep[s].high.array() >= boxes[t].low.array()).all());
    }
  }
  return kept;
}

/// The triangulation that grows by the point that is farthest off until none is too far.
class Growing {
 public:
  Growing(const std::vector<Vec3>& points, double tolerance)
      : points_(points),
        tolerance_(tolerance),
        vertex_of_(points.size()),
        errors_(points.size(), 0.0) {}

  void constrain(std::uint32_t a, std::uint32_t b) {
    triangulation_.insert_constraint(vertex(a), vertex(b));
  }

  /// @param open  points that may be inserted
  void grow(const std::vector<std::uint32_t>& open) {
    Triangulation::Face_handle near;
    for (const std::uint32_t p : open) {
      near = triangulation_.locate(plan(p), near);
      near->info().push_back(p);
    }
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end();
         ++face) {
      for (const std::uint32_t p : face->info()) measure(p, face);
    }
    while (!queue_.empty()) {
      const auto [error, negative] = queue_.top();
      queue_.pop();
      const auto p = static_cast<std::uint32_t>(-negative);
      if (error == errors_[p] && vertex_of_[p] == Triangulation::Vertex_handle()) insert(p);
    }
  }

  const Triangulation& triangulation() const { return triangulation_; }

 private:
  Point plan(std::uint32_t p) const { return {points_[p].x(), points_[p].y()}; }

  Triangulation::Vertex_handle vertex(std::uint32_t p) {
    if (vertex_of_[p] == Triangulation::Vertex_handle()) {
      vertex_of_[p] = triangulation_.insert(plan(p));
      vertex_of_[p]->info() = p;
    }
    return vertex_of_[p];
  }

  /// How far the point is off the plane of its face; waits to be inserted when that is too far.
  void measure(std::uint32_t p, Triangulation::Face_handle face) {
    errors_[p] = 0.0;
    if (triangulation_.is_infinite(face)) return;
    const Vec3& a = points_[face->vertex(0)->info()];
    const Vec3 ab = points_[face->vertex(1)->info()] - a;
    const Vec3 ac = points_[face->vertex(2)->info()] - a;
    const Vec3 ap = points_[p] - a;
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    const double v = (ap.x() * ac.y() - ap.y() * ac.x()) / area;
    const double w = (ab.x() * ap.y() - ab.y() * ap.x()) / area;
    errors_[p] = std::abs(ap.z() - v * ab.z() - w * ac.z());
    if (!(errors_[p] <= tolerance_)) queue_.emplace(errors_[p], -static_cast<std::int64_t>(p));
  }

  void insert(std::uint32_t p) {
    const Triangulation::Face_handle home = triangulation_.locate(plan(p), last_);
    std::vector<Triangulation::Face_handle> replaced;
    std::vector<Triangulation::Edge> rim;
    triangulation_.get_conflicts_and_boundary(plan(p), std::back_inserter(replaced),
                                              std::back_inserter(rim), home);
    std::vector<std::uint32_t> orphans;
    for (const Triangulation::Face_handle& face : replaced) {
      orphans.insert(orphans.end(), face->info().begin(), face->info().end());
      face->info().clear();
    }
    std::sort(orphans.begin(), orphans.end());
    vertex_of_[p] = triangulation_.insert(plan(p), home);
    vertex_of_[p]->info() = p;
    // CGAL recycles faces: whatever is around the new vertex starts without points.
    auto around = triangulation_.incident_faces(vertex_of_[p]), end = around;
    std::vector<Triangulation::Face_handle> fan;
    do {
      around->info().clear();
      fan.push_back(around);
    } while (++around != end);
    for (const std::uint32_t orphan : orphans) {
      if (orphan == p) continue;
      const Triangulation::Face_handle face = triangulation_.locate(plan(orphan), fan.front());
      face->info().push_back(orphan);
      measure(orphan, face);
    }
    last_ = fan.front();
  }

  const std::vector<Vec3>& points_;
  double tolerance_;
  Triangulation triangulation_;
  std::vector<Triangulation::Vertex_handle> vertex_of_;
  std::vector<double> errors_;
  Triangulation::Face_handle last_;
  // Largest error first, then the smallest number.
  std::priority_queue<std::pair<double, std::int64_t>> queue_;
};

/// The free triangle under a place of the plan.
std::optional<std::uint32_t> triangle_under(const TriangleMesh& mesh, const PlanIndex& index,
                                            const std::vector<bool>& kept, const Vec2& at) {
  for (const std::uint32_t t : index.near(at)) {
    if (!kept[t] && height_on(mesh, t, at)) return t;
  }
  return std::nullopt;
}

}  // namespace

void thin(RawSurface& surface, double tolerance, TerrainReport& report) {
  TriangleMesh& mesh = surface.mesh;
  const std::vector<bool> kept = kept_triangles(mesh);
  const TriangleLinks links = triangle_links(mesh);
  std::vector<Vec3> points = mesh.vertices;
  std::vector<bool> fixed(mesh.vertices.size(), false);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> constraints;
  std::vector<std::uint32_t> open;
  std::vector<bool> in_free(mesh.vertices.size(), false);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (kept[t]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      in_free[a] = true;
      const std::uint32_t other = links.across[t][k];
      if (other == kNoTriangle || kept[other] || surface.source[other] != surface.source[t]) {
        fixed[a] = fixed[b] = true;
        constraints.emplace_back(std::min(a, b), std::max(a, b));
      } else if (t < other) {
        open.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2.0);
      }
    }
  }
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (in_free[v] && !fixed[v]) open.push_back(v);
  }
  std::sort(open.begin(), open.end());
  std::sort(constraints.begin(), constraints.end());
  constraints.erase(std::unique(constraints.begin(), constraints.end()), constraints.end());

  Growing growing(points, tolerance);
  try {
    for (const auto& [a, b] : constraints) growing.constrain(a, b);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    throw GeometryError(
        "the border of the ground crosses itself in plan, so that it can't be thinned; leave out "
        "tolerance, or cut the ground there");
  }
  growing.grow(open);

  RawSurface result{.mesh = {.vertices = points, .triangles = {}},
                    .source = {},
                    .crs = surface.crs,
                    .notes = surface.notes};
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!kept[t]) continue;
    result.mesh.triangles.push_back(mesh.triangles[t]);
    result.source.push_back(surface.source[t]);
  }
  const PlanIndex index(plan_boxes(mesh));
  std::vector<std::pair<TriangleMesh::Triangle, std::uint16_t>> fresh;
  for (auto face = growing.triangulation().finite_faces_begin();
       face != growing.triangulation().finite_faces_end(); ++face) {
    TriangleMesh::Triangle corners;
    Vec2 middle = Vec2::Zero();
    for (int k = 0; k < 3; ++k) {
      corners[static_cast<std::size_t>(k)] = face->vertex(k)->info();
      middle += points[face->vertex(k)->info()].head<2>() / 3.0;
    }
    const std::optional<std::uint32_t> under = triangle_under(mesh, index, kept, middle);
    if (!under) continue;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    fresh.emplace_back(corners, surface.source[*under]);
  }
  std::sort(fresh.begin(), fresh.end());
  for (const auto& [corners, source] : fresh) {
    result.mesh.triangles.push_back(corners);
    result.source.push_back(source);
  }
  drop_unused_vertices(result.mesh);
  report.notes.push_back("thinned within " + with_digits(tolerance, 4) +
                         " m: " + std::to_string(result.mesh.triangles.size()) + " of " +
                         std::to_string(mesh.triangles.size()) + " triangles");
  surface = std::move(result);
}

}  // namespace clast::detail
