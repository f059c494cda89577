#include "terrain/detail/thinning.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

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
/// The check in a face that is farthest off it.
struct Farthest {
  double error = 0.0;  ///< m
  std::uint32_t check = 0;
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

/// A place where the new surface must be near the old one: a vertex, or the middle of an edge.
struct Check {
  Vec3 point;
  std::uint32_t from, to;  ///< vertices; the same for a vertex

  bool is_vertex() const { return from == to; }
};

/// The triangulation that grows, in rounds, by what is farthest off in each of its faces.
class Growing {
 public:
  Growing(const std::vector<Vec3>& vertices, double tolerance)
      : vertices_(vertices), tolerance_(tolerance), handles_(vertices.size()) {}

  void constrain(std::uint32_t a, std::uint32_t b) {
    triangulation_.insert_constraint(handle(a), handle(b));
  }

  /// Every check that is off by more than the tolerance brings in its vertex; the middle of an edge
  /// one of its ends, or, with both there, the edge itself: at worst the old triangles come back.
  void grow(const std::vector<Check>& checks) {
    for (std::vector<std::uint32_t> wanted = farthest(checks); !wanted.empty();
         wanted = farthest(checks)) {
      for (const std::uint32_t i : wanted) {
        const Check& check = checks[i];
        if (!is_in(check.from)) {
          handle(check.from);
        } else if (!is_in(check.to)) {
          handle(check.to);
        } else if (!check.is_vertex()) {
          constrain(check.from, check.to);
        }
      }
    }
  }

  const Triangulation& triangulation() const { return triangulation_; }

 private:
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

  double error(const Check& check, const Triangulation::Face_handle& face) const {
    const Vec3& a = vertices_[face->vertex(0)->info()];
    const Vec3 ab = vertices_[face->vertex(1)->info()] - a;
    const Vec3 ac = vertices_[face->vertex(2)->info()] - a;
    const Vec3 ap = check.point - a;
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    const double v = (ap.x() * ac.y() - ap.y() * ac.x()) / area;
    const double w = (ab.x() * ap.y() - ab.y() * ap.x()) / area;
    return std::abs(ap.z() - v * ab.z() - w * ac.z());
  }

  /// Of every face the check that is farthest off, if by more than the tolerance; rising numbers.
  std::vector<std::uint32_t> farthest(const std::vector<Check>& checks) {
    for (auto face = triangulation_.all_faces_begin(); face != triangulation_.all_faces_end();
         ++face) {
      face->info() = {};
    }
    Triangulation::Face_handle near;
    for (std::uint32_t i = 0; i < checks.size(); ++i) {
      const Check& check = checks[i];
      if (check.is_vertex() && is_in(check.from)) continue;
      near = triangulation_.locate({check.point.x(), check.point.y()}, near);
      if (triangulation_.is_infinite(near)) continue;
      const double off = error(check, near);
      if (off > tolerance_ && off > near->info().error) near->info() = {off, i};
    }
    std::vector<std::uint32_t> wanted;
    for (auto face = triangulation_.finite_faces_begin(); face != triangulation_.finite_faces_end();
         ++face) {
      if (face->info().error > 0.0) wanted.push_back(face->info().check);
    }
    std::sort(wanted.begin(), wanted.end());
    return wanted;
  }

  const std::vector<Vec3>& vertices_;
  double tolerance_;
  Triangulation triangulation_;
  std::vector<Triangulation::Vertex_handle> handles_;
  Triangulation::Vertex_handle last_;
};

/// In rows that run to and fro, so that each is near the one before.
void put_in_rows(std::vector<Check>& checks, double row) {
  std::vector<std::tuple<std::int64_t, double, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < checks.size(); ++i) {
    const auto number = static_cast<std::int64_t>(std::floor(checks[i].point.y() / row));
    order.emplace_back(number, number % 2 == 0 ? checks[i].point.x() : -checks[i].point.x(), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<Check> sorted;
  for (const auto& entry : order) sorted.push_back(checks[std::get<2>(entry)]);
  checks.swap(sorted);
}

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
  std::vector<bool> fixed(mesh.vertices.size(), false), in_free(mesh.vertices.size(), false);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> constraints;
  std::vector<Check> checks;
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
        checks.push_back({(mesh.vertices[a] + mesh.vertices[b]) / 2.0, a, b});
      }
    }
  }
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (in_free[v] && !fixed[v]) checks.push_back({mesh.vertices[v], v, v});
  }
  put_in_rows(checks, median_edge(mesh));
  std::sort(constraints.begin(), constraints.end());
  constraints.erase(std::unique(constraints.begin(), constraints.end()), constraints.end());

  Growing growing(mesh.vertices, tolerance);
  try {
    for (const auto& [a, b] : constraints) growing.constrain(a, b);
    growing.grow(checks);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    throw GeometryError(
        "the border of the ground crosses itself in plan, so that it can't be thinned; leave out "
        "tolerance, or cut the ground there");
  }

  RawSurface result{.mesh = {.vertices = mesh.vertices, .triangles = {}},
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
      middle += mesh.vertices[face->vertex(k)->info()].head<2>() / 3.0;
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
