#include "shapes/convex_cell.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mesh/triangle_geometry.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/coplanar_faces.hpp"

namespace clast {
namespace {

/// Fraction of the diagonal within which points lie on a plane.
constexpr double kCellSlack = 1e-9;
/// Vertices of a cell nearer than this share of its size are one.
constexpr double kSameVertex = 1e-4;

/// Twice the area of a face along its normal.
Vec3 face_area_vector(const std::vector<Vec3>& vertices, const std::vector<std::uint32_t>& face) {
  Vec3 sum = Vec3::Zero();
  const Vec3& first = vertices[face[0]];
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    sum += (vertices[face[i]] - first).cross(vertices[face[i + 1]] - first);
  }
  return sum;
}

/// The corners of a convex face, counter-clockwise about its normal.
void put_around(std::vector<std::uint32_t>& face, const std::vector<Vec3>& vertices,
                const Vec3& normal) {
  Vec3 middle = Vec3::Zero();
  for (const std::uint32_t vertex : face) middle += vertices[vertex];
  middle /= static_cast<double>(face.size());
  const Vec3 across = normal.unitOrthogonal();
  const Vec3 along = normal.cross(across);
  const auto angle = [&](std::uint32_t vertex) {
    const Vec3 arm = vertices[vertex] - middle;
    return std::atan2(along.dot(arm), across.dot(arm));
  };
  std::sort(face.begin(), face.end(),
            [&](std::uint32_t a, std::uint32_t b) { return angle(a) < angle(b); });
}

}  // namespace

ConvexCell::ConvexCell(const Bounds& box) {
  for (int i = 0; i < 8; ++i) {
    vertices_.emplace_back(i & 1 ? box.high.x() : box.low.x(), i & 2 ? box.high.y() : box.low.y(),
                           i & 4 ? box.high.z() : box.low.z());
  }
  faces_ = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
}

std::optional<ConvexCell> ConvexCell::clipped_below(const Plane& plane, double tolerance) const {
  std::vector<double> heights;
  bool any_above = false, any_below = false;
  for (const Vec3& vertex : vertices_) {
    const double height = plane.signed_distance(vertex);
    heights.push_back(std::abs(height) <= tolerance ? 0.0 : height);
    any_above |= heights.back() > 0.0;
    any_below |= heights.back() < 0.0;
  }
  if (!any_below) return std::nullopt;
  if (!any_above) return *this;

  ConvexCell part;
  std::map<std::uint32_t, std::uint32_t> kept;                             // by old number
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> added;  // by old edge
  std::vector<std::uint32_t> on_plane;
  const auto keep = [&](std::uint32_t old) {
    const auto [at, is_new] = kept.emplace(old, static_cast<std::uint32_t>(part.vertices_.size()));
    if (is_new) {
      part.vertices_.push_back(vertices_[old]);
      if (heights[old] == 0.0) on_plane.push_back(at->second);
    }
    return at->second;
  };
  const auto crossing = [&](std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);  // the same point from both sides of the edge
    const auto [at, is_new] =
        added.emplace(std::pair(a, b), static_cast<std::uint32_t>(part.vertices_.size()));
    if (is_new) {
      const double share = heights[a] / (heights[a] - heights[b]);
      part.vertices_.push_back(vertices_[a] + share * (vertices_[b] - vertices_[a]));
      on_plane.push_back(at->second);
    }
    return at->second;
  };
  for (const std::vector<std::uint32_t>& face : faces_) {
    std::vector<std::uint32_t> remaining;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
      if (heights[a] <= 0.0) remaining.push_back(keep(a));
      if (heights[a] * heights[b] < 0.0) remaining.push_back(crossing(a, b));
    }
    if (remaining.size() > 2) part.faces_.push_back(std::move(remaining));
  }
  put_around(on_plane, part.vertices_, plane.normal);
  part.faces_.push_back(std::move(on_plane));
  return part;
}

std::vector<Plane> ConvexCell::planes() const {
  std::vector<Plane> planes;
  for (const std::vector<std::uint32_t>& face : faces_) {
    const Vec3 normal = face_area_vector(vertices_, face).normalized();
    if (normal.allFinite() && !normal.isZero()) {
      planes.push_back({normal, normal.dot(vertices_[face[0]])});
    }
  }
  return planes;
}

Bounds ConvexCell::box() const {
  Bounds box;
  for (const Vec3& vertex : vertices_) box.include(vertex);
  return box;
}

Vec3 ConvexCell::centre() const {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& vertex : vertices_) sum += vertex;
  return sum / static_cast<double>(vertices_.size());
}

double ConvexCell::volume() const {
  const Vec3 inside = centre();
  double sum = 0.0;
  for (const std::vector<std::uint32_t>& face : faces_) {
    sum += face_area_vector(vertices_, face).dot(vertices_[face[0]] - inside);
  }
  return sum / 6.0;
}

TriangleMesh ConvexCell::mesh() const {
  TriangleMesh mesh;
  mesh.vertices = vertices_;
  for (const std::vector<std::uint32_t>& face : faces_) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      mesh.triangles.push_back({face[0], face[i], face[i + 1]});
    }
  }
  return mesh;
}

std::optional<TriangleMesh> ConvexCell::welded_mesh() const {
  const double near = kSameVertex * std::cbrt(volume());
  std::vector<Vec3> distinct;
  for (const Vec3& vertex : vertices_) {
    if (std::none_of(distinct.begin(), distinct.end(),
                     [&](const Vec3& other) { return (vertex - other).norm() <= near; })) {
      distinct.push_back(vertex);
    }
  }
  if (affine_span(distinct).dimension < 3) return std::nullopt;
  return convex_hull(distinct);
}

std::optional<SpheroPolyhedron> inscribed_rounded_body(const TriangleMesh& polyhedron,
                                                       double radius) {
  const Bounds box = bounds(polyhedron);
  // Far from the origin heights above planes would lose digits.
  const Vec3 origin = 0.5 * (box.low + box.high);
  Bounds local;
  local.include(box.low - origin);
  local.include(box.high - origin);
  const double tolerance = kCellSlack * box.diagonal();
  std::optional<ConvexCell> core = ConvexCell(local);
  for (const TriangleMesh::Triangle& triangle : polyhedron.triangles) {
    const Vec3 normal = unit_normal(polyhedron, triangle);
    if (normal.isZero()) continue;
    const double offset = normal.dot(polyhedron.vertices[triangle[0]] - origin);
    core = core->clipped_below({normal, offset - radius}, tolerance);
    if (!core) return std::nullopt;
  }
  const std::optional<TriangleMesh> hull = core->welded_mesh();
  if (!hull) return std::nullopt;
  Pose to_place;
  to_place.translation = origin;
  return merge_coplanar_faces(make_sphero_polyhedron(transformed(*hull, to_place), radius),
                              kFileFlatnessTolerance);
}

}  // namespace clast
