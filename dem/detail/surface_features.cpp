#include "dem/detail/surface_features.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

/// Sine of the angle between faces below which an edge counts as flat: single-precision files leave
/// less than this on a true plane of metre-sized triangles, and no contact is lost by it.
constexpr double kFlatSine = 1e-7;
/// Slack of the arc and cone tests, a sine.
constexpr double kConeSlack = 1e-9;
/// Share of the turn at an edge or vertex that its arc or cone gives: 3 degrees at a right angle,
/// as much as a block of the settled depth tilts.
constexpr double kGiveShare = 1.0 / 30.0;

double give_of(const Vec3& normal, const Vec3& other) {
  return std::sin(kGiveShare * std::atan2(normal.cross(other).norm(), normal.dot(other)));
}

struct HalfEdge {
  std::uint32_t low, high, face, side;
};

void make_faces(SurfaceFeatures& surface, const TriangleMesh& mesh) {
  surface.faces.reserve(mesh.triangles.size());
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    SurfaceFace face{triangle, {}, {}, Vec3::Zero()};
    const Vec3& a = mesh.vertices[triangle[0]];
    const Vec3& b = mesh.vertices[triangle[1]];
    const Vec3& c = mesh.vertices[triangle[2]];
    const Vec3 area = (b - a).cross(c - a);
    if (!(area.norm() > 0.0)) {
      throw GeometryError("triangle at " + place(a) + " has no area; remove degenerate triangles");
    }
    face.normal = area.normalized();
    for (int k = 0; k < 3; ++k) {
      const Vec3 along = mesh.vertices[triangle[(k + 1) % 3]] - mesh.vertices[triangle[k]];
      face.inward[k] = face.normal.cross(along).normalized();
    }
    surface.faces.push_back(face);
  }
}

EdgeKind kind_of(const SurfaceFace& first, const SurfaceFace& second, const Vec3& into_second) {
  const double rise = first.normal.dot(into_second);
  if (rise > kFlatSine) return EdgeKind::kValley;
  if (rise < -kFlatSine || first.normal.dot(second.normal) < 0.0) return EdgeKind::kRidge;
  return EdgeKind::kFlat;
}

void make_edges(SurfaceFeatures& surface) {
  std::vector<HalfEdge> halves;
  halves.reserve(3 * surface.faces.size());
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = surface.faces[f].vertices[k];
      const std::uint32_t b = surface.faces[f].vertices[(k + 1) % 3];
      halves.push_back({std::min(a, b), std::max(a, b), f, k});
    }
  }
  std::sort(halves.begin(), halves.end(), [](const HalfEdge& p, const HalfEdge& q) {
    return std::tie(p.low, p.high, p.face) < std::tie(q.low, q.high, q.face);
  });
  for (std::size_t i = 0; i < halves.size();) {
    std::size_t end = i + 1;
    while (end < halves.size() && halves[end].low == halves[i].low &&
           halves[end].high == halves[i].high) {
      ++end;
    }
    const HalfEdge& half = halves[i];
    if (end - i > 2) {
      throw GeometryError(std::to_string(end - i) + " triangles meet in the edge at " +
                          place(surface.vertices[half.low]) + "; the surface must be manifold");
    }
    SurfaceEdge edge;
    edge.vertices = {half.low, half.high};
    const Vec3 along = surface.vertices[half.high] - surface.vertices[half.low];
    edge.length = along.norm();
    edge.direction = along / edge.length;
    SurfaceFace& first = surface.faces[half.face];
    first.edges[half.side] = static_cast<std::uint32_t>(surface.edges.size());
    edge.faces = {half.face, kNoFeature};
    edge.inward = {first.inward[half.side], Vec3::Zero()};
    edge.normal = first.normal;
    edge.kind = EdgeKind::kBorder;
    if (end - i == 2) {
      const HalfEdge& other = halves[i + 1];
      SurfaceFace& second = surface.faces[other.face];
      second.edges[other.side] = static_cast<std::uint32_t>(surface.edges.size());
      edge.faces[1] = other.face;
      edge.inward[1] = second.inward[other.side];
      edge.kind = kind_of(first, second, edge.inward[1]);
      const Vec3 sum = first.normal + second.normal;
      if (sum.norm() > kFlatSine) edge.normal = sum.normalized();
      if (edge.kind == EdgeKind::kRidge) edge.give = give_of(first.normal, second.normal);
    }
    surface.edges.push_back(edge);
    i = end;
  }
}

void add_wires(SurfaceFeatures& surface, std::span<const std::array<std::uint32_t, 2>> wires) {
  for (const auto& [a, b] : wires) {
    SurfaceEdge edge;
    edge.vertices = {a, b};
    edge.faces = {kNoFeature, kNoFeature};
    const Vec3 along = surface.vertices[b] - surface.vertices[a];
    edge.length = along.norm();
    edge.direction = along / edge.length;
    edge.inward = {Vec3::Zero(), Vec3::Zero()};
    edge.normal = Vec3::UnitZ();
    edge.kind = EdgeKind::kWire;
    surface.edges.push_back(edge);
  }
}

/// Sets of numbers that are joined pairwise; each is named by its smallest member.
class Joined {
 public:
  explicit Joined(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t name(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = name(i), b = name(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

void number_planes(SurfaceFeatures& surface) {
  Joined planes(surface.faces.size());
  for (const SurfaceEdge& edge : surface.edges) {
    if (edge.kind == EdgeKind::kFlat) planes.join(edge.faces[0], edge.faces[1]);
  }
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    surface.faces[f].plane = planes.name(f);
  }
}

using Incident = std::vector<std::vector<std::uint32_t>>;

/// Rays, pointedness and the lines of edges that go straight on.
void describe_vertices(SurfaceFeatures& surface, const Incident& edges_at) {
  const std::size_t count = surface.vertices.size();
  surface.ray_offsets.assign(count + 1, 0);
  surface.pointed.assign(count, 0);
  Joined lines(surface.edges.size());
  for (std::size_t v = 0; v < count; ++v) {
    bool convex = edges_at[v].empty();  // a lone ball
    std::vector<std::uint32_t> sharp;
    const auto ray = [&](std::uint32_t e) {
      const SurfaceEdge& edge = surface.edges[e];
      return edge.vertices[0] == v ? edge.direction : Vec3(-edge.direction);
    };
    for (const std::uint32_t e : edges_at[v]) {
      surface.rays.push_back(ray(e));
      if (surface.edges[e].kind != EdgeKind::kFlat) sharp.push_back(e);
      convex = convex || surface.edges[e].convex();
    }
    const bool goes_straight_on = sharp.size() == 2 &&
                                  ray(sharp[0]).cross(ray(sharp[1])).norm() < kFlatSine &&
                                  ray(sharp[0]).dot(ray(sharp[1])) < 0.0;
    if (goes_straight_on) lines.join(sharp[0], sharp[1]);
    surface.pointed[v] = convex && !goes_straight_on;
    surface.ray_offsets[v + 1] = static_cast<std::uint32_t>(surface.rays.size());
  }
  for (std::uint32_t e = 0; e < surface.edges.size(); ++e) surface.edges[e].line = lines.name(e);
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
  surface.give.assign(surface.vertices.size(), 0.0);
  for (const SurfaceFace& face : surface.faces) {
    for (const std::uint32_t v : face.vertices) {
      surface.give[v] =
          std::max(surface.give[v], 2.0 * give_of(surface.vertex_normals[v], face.normal));
    }
  }
}

void gather_joints(SurfaceFeatures& surface, const Incident& edges_at) {
  const std::size_t count = surface.vertices.size();
  Incident joints_at(count);
  for (const SurfaceFace& face : surface.faces) {
    for (const std::uint32_t v : face.vertices) joints_at[v].push_back(face.plane);
  }
  surface.joint_offsets.assign(count + 1, 0);
  for (std::size_t v = 0; v < count; ++v) {
    std::vector<std::uint32_t>& joints = joints_at[v];
    for (const std::uint32_t e : edges_at[v]) {
      const SurfaceEdge& edge = surface.edges[e];
      if (edge.convex()) joints.push_back(surface.joint_of_line(edge.line));
    }
    std::sort(joints.begin(), joints.end());
    joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
    surface.joints.insert(surface.joints.end(), joints.begin(), joints.end());
    surface.joint_offsets[v + 1] = static_cast<std::uint32_t>(surface.joints.size());
  }
}

}  // namespace

SurfaceFeatures surface_features(const TriangleMesh& mesh,
                                 std::span<const std::array<std::uint32_t, 2>> wires) {
  SurfaceFeatures surface;
  surface.vertices = mesh.vertices;
  make_faces(surface, mesh);
  make_edges(surface);
  add_wires(surface, wires);
  number_planes(surface);
  make_vertex_normals(surface);
  Incident edges_at(surface.vertices.size());
  for (std::uint32_t e = 0; e < surface.edges.size(); ++e) {
    for (const std::uint32_t v : surface.edges[e].vertices) edges_at[v].push_back(e);
  }
  describe_vertices(surface, edges_at);
  gather_joints(surface, edges_at);
  return surface;
}

namespace {

bool within(const SurfaceEdge& edge, const Vec3& direction, double slack) {
  return direction.dot(edge.inward[0]) <= slack && direction.dot(edge.inward[1]) <= slack;
}

bool within(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction,
            double slack) {
  for (const Vec3& ray : surface.rays_of(vertex)) {
    if (direction.dot(ray) > slack) return false;
  }
  return true;
}

}  // namespace

bool in_arc(const SurfaceEdge& edge, const Vec3& direction) {
  return within(edge, direction, kConeSlack);
}

bool near_arc(const SurfaceEdge& edge, const Vec3& direction) {
  return within(edge, direction, kConeSlack + edge.give);
}

bool in_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction) {
  return within(surface, vertex, direction, kConeSlack);
}

bool near_cone(const SurfaceFeatures& surface, std::uint32_t vertex, const Vec3& direction) {
  return within(surface, vertex, direction, kConeSlack + surface.give[vertex]);
}

}  // namespace clast
