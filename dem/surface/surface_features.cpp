#include "dem/surface/surface_features.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"

namespace clast::dem_detail {
namespace {

/// Sine of the angle between face normals below which an edge is flat. It exceeds the rounding
/// error of single-precision files with metre-sized triangles; no contact is lost by it.
constexpr double kFlatSine = 1e-7;
void make_faces(SurfaceFeatures& surface, const TriangleMesh& mesh) {
  surface.faces.reserve(mesh.triangles.size());
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    SurfaceFace face{triangle, {}, Vec3::Zero()};
    const Vec3& a = mesh.vertices[triangle[0]];
    const Vec3& b = mesh.vertices[triangle[1]];
    const Vec3& c = mesh.vertices[triangle[2]];
    const Vec3 area = (b - a).cross(c - a);
    if (!(area.norm() > 0.0)) {
      throw GeometryError("triangle at " + format_point(a) +
                          " has no area; remove degenerate triangles");
    }
    face.normal = area.normalized();
    surface.faces.push_back(face);
  }
}

EdgeKind kind_of(const SurfaceFace& first, const SurfaceFace& second, const Vec3& into_second) {
  const double rise = first.normal.dot(into_second);
  if (rise > kFlatSine) return EdgeKind::kReflex;
  if (rise < -kFlatSine || first.normal.dot(second.normal) < 0.0) return EdgeKind::kConvex;
  return EdgeKind::kFlat;
}

/// Adds the edge that has these half-edges.
void add_edge(SurfaceFeatures& surface, std::span<const HalfEdge> sides) {
  const std::uint32_t low = sides[0].low, high = sides[0].high;
  if (sides.size() > 2) {
    throw GeometryError(std::to_string(sides.size()) + " triangles meet in the edge at " +
                        format_point(surface.vertices[low]) + "; the surface must be manifold");
  }
  SurfaceEdge edge;
  edge.vertices = {low, high};
  const Vec3 reach = surface.vertices[high] - surface.vertices[low];
  edge.length = reach.norm();
  edge.direction = reach / edge.length;
  edge.faces = {kNoFeature, kNoFeature};
  edge.kind = EdgeKind::kBorder;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    SurfaceFace& face = surface.faces[sides[i].triangle];
    const auto corner = std::find(face.vertices.begin(), face.vertices.end(), sides[i].from());
    face.edges[corner - face.vertices.begin()] = static_cast<std::uint32_t>(surface.edges.size());
    edge.faces[i] = sides[i].triangle;
    edge.forward[i] = sides[i].is_forward;
  }
  if (sides.size() == 2) {
    const SurfaceFace& second = surface.faces[edge.faces[1]];
    edge.kind = kind_of(surface.faces[edge.faces[0]], second,
                        inward_direction(second, edge.direction, edge.forward[1]));
  }
  surface.edges.push_back(edge);
}

void make_edges(SurfaceFeatures& surface, const TriangleMesh& mesh, std::size_t wires) {
  const std::vector<HalfEdge> sides = sorted_half_edges(mesh);
  std::size_t count = wires;
  for_each_edge(sides, [&](std::span<const HalfEdge>) { ++count; });
  surface.edges.reserve(count);
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) { add_edge(surface, edge); });
}

void add_wires(SurfaceFeatures& surface, std::span<const std::array<std::uint32_t, 2>> wires) {
  for (const auto& [a, b] : wires) {
    SurfaceEdge edge;
    edge.vertices = {a, b};
    edge.faces = {kNoFeature, kNoFeature};
    const Vec3 reach = surface.vertices[b] - surface.vertices[a];
    edge.length = reach.norm();
    edge.direction = reach / edge.length;
    edge.kind = EdgeKind::kWire;
    surface.edges.push_back(edge);
  }
}

void index_edges(SurfaceFeatures& surface) {
  surface.edge_offsets.assign(surface.vertices.size() + 1, 0);
  for (const SurfaceEdge& edge : surface.edges) {
    for (const std::uint32_t v : edge.vertices) ++surface.edge_offsets[v + 1];
  }
  std::partial_sum(surface.edge_offsets.begin(), surface.edge_offsets.end(),
                   surface.edge_offsets.begin());
  surface.edges_at_vertex.resize(surface.edge_offsets.back());
  std::vector<std::uint32_t> next(surface.edge_offsets.begin(), surface.edge_offsets.end() - 1);
  for (std::uint32_t e = 0; e < surface.edges.size(); ++e) {
    for (const std::uint32_t v : surface.edges[e].vertices) surface.edges_at_vertex[next[v]++] = e;
  }
}

void find_pointed(SurfaceFeatures& surface) {
  surface.is_pointed_vertex.assign(surface.vertices.size(), 0);
  for (std::uint32_t v = 0; v < surface.vertices.size(); ++v) {
    const std::span<const std::uint32_t> edges = surface.edges_at(v);
    bool is_convex = edges.empty();  // a lone ball
    std::array<std::uint32_t, 2> sharp{};
    std::size_t sharp_count = 0;
    for (const std::uint32_t e : edges) {
      is_convex = is_convex || surface.edges[e].is_convex();
      if (surface.edges[e].kind == EdgeKind::kFlat) continue;
      if (sharp_count < 2) sharp[sharp_count] = e;
      ++sharp_count;
    }
    const bool goes_on =
        sharp_count == 2 && are_collinear(surface.edge_direction_from(sharp[0], v),
                                          surface.edge_direction_from(sharp[1], v));
    surface.is_pointed_vertex[v] = is_convex && !goes_on;
  }
}

void make_vertex_normals(SurfaceFeatures& surface) {
  surface.vertex_normals.assign(surface.vertices.size(), Vec3::Zero());
  for (const SurfaceFace& face : surface.faces) {
    for (int k = 0; k < 3; ++k) {
      const Vec3& here = surface.vertices[face.vertices[k]];
      const Vec3 out = surface.vertices[face.vertices[(k + 1) % 3]] - here;
      const Vec3 back = surface.vertices[face.vertices[(k + 2) % 3]] - here;
      const double angle = std::atan2(out.cross(back).norm(), out.dot(back));
      surface.vertex_normals[face.vertices[k]] += angle * face.normal;
    }
  }
  for (Vec3& normal : surface.vertex_normals) {
    if (normal.norm() > 0.0) normal.normalize();
  }
}

}  // namespace

SurfaceFeatures extract_surface_features(const TriangleMesh& mesh,
                                         std::span<const std::array<std::uint32_t, 2>> wires) {
  SurfaceFeatures surface;
  surface.vertices = mesh.vertices;
  make_faces(surface, mesh);
  make_edges(surface, mesh, wires.size());
  add_wires(surface, wires);
  make_vertex_normals(surface);
  index_edges(surface);
  find_pointed(surface);
  return surface;
}

Vec3 SurfaceFeatures::edge_normal(const SurfaceEdge& edge) const {
  if (edge.faces[0] == kNoFeature) return Vec3::UnitZ();
  const Vec3& first = faces[edge.faces[0]].normal;
  if (edge.faces[1] == kNoFeature) return first;
  const Vec3 sum = first + faces[edge.faces[1]].normal;
  const double length = sum.norm();
  return length > kFlatSine ? Vec3(sum / length) : first;
}

double distance_inside_face(const SurfaceFeatures& surface, const SurfaceFace& face,
                            const Vec3& point) {
  double depth = 1e300;
  for (int k = 0; k < 3; ++k) {
    const Vec3& corner = surface.vertices[face.vertices[k]];
    const Vec3 along = surface.vertices[face.vertices[(k + 1) % 3]] - corner;
    const double twice_area = face.normal.cross(along).dot(point - corner);
    if (twice_area < 0.0) return -1.0;
    depth = std::min(depth, twice_area / along.norm());
  }
  return depth;
}

bool are_collinear(const Vec3& first_ray, const Vec3& second_ray) {
  return first_ray.cross(second_ray).norm() < kFlatSine && first_ray.dot(second_ray) < 0.0;
}

}  // namespace clast::dem_detail
