#include "mesh/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/half_edges.hpp"
#include "mesh/triangle_geometry.hpp"

namespace clast {

namespace {

constexpr std::uint32_t kLeaf = 4;  ///< triangles in a leaf
/// Share of a mesh's coordinates below which a distance is rounding.
constexpr double kOnSurface = 1e-13;

double squared_distance(const Bounds& box, const Vec3& p) {
  const Vec3 outside = (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0);
  return outside.squaredNorm();
}

struct OnTriangle {
  Vec3 point;
  int feature;
};

/// Closest point of triangle abc by the Voronoi regions of its corners and sides.
OnTriangle closest_on(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {a, 1};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {b, 2};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + d1 / (d1 - d3) * ab, 4};
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {c, 3};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + d2 / (d2 - d6) * ac, 6};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
    return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 5};
  }
  const double sum = va + vb + vc;
  return {a + vb / sum * ab + vc / sum * ac, 0};
}

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(mesh) {
  order_.resize(mesh.triangles.size());
  for (std::uint32_t t = 0; t < order_.size(); ++t) order_[t] = t;
  nodes_.reserve(mesh.triangles.size());
  build(0, static_cast<std::uint32_t>(order_.size()));
  prepare_normals();
}

void TriangleTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Bounds box, centres;
  const auto centre = [&](std::uint32_t t) {
    const TriangleMesh::Triangle& corners = mesh_.triangles[t];
    return Vec3(mesh_.vertices[corners[0]] + mesh_.vertices[corners[1]] +
                mesh_.vertices[corners[2]]);
  };
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const std::uint32_t v : mesh_.triangles[order_[i]]) box.include(mesh_.vertices[v]);
    centres.include(centre(order_[i]));
  }
  nodes_[index].box = box;
  if (end - begin <= kLeaf) {
    nodes_[index].first = begin;
    nodes_[index].count = end - begin;
    return;
  }
  Eigen::Index axis = 0;
  (centres.high - centres.low).maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double ca = centre(a)[axis], cb = centre(b)[axis];
                     return ca < cb || (ca == cb && a < b);
                   });
  build(begin, middle);
  nodes_[index].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

void TriangleTree::prepare_normals() {
  vertex_normals_.assign(mesh_.vertices.size(), Vec3::Zero());
  for (const TriangleMesh::Triangle& t : mesh_.triangles) {
    const Vec3 normal = unit_normal(mesh_, t);
    face_normals_.push_back(normal);
    side_normals_.push_back({normal, normal, normal});
    for (std::size_t k = 0; k < 3; ++k) {
      vertex_normals_[t[k]] += corner_angle(mesh_, t, k) * normal;
    }
  }
  const auto side_of = [&](const HalfEdge& half) -> Vec3& {
    const TriangleMesh::Triangle& t = mesh_.triangles[half.triangle];
    const std::size_t k = t[0] == half.from() ? 0 : t[1] == half.from() ? 1 : 2;
    return side_normals_[half.triangle][k];
  };
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh_);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    if (sides.size() != 2) return;
    const Vec3 sum = face_normals_[sides[0].triangle] + face_normals_[sides[1].triangle];
    side_of(sides[0]) = side_of(sides[1]) = sum;
  });
}

double TriangleTree::distance_to(std::uint32_t triangle, const Vec3& point) const {
  const TriangleMesh::Triangle& t = mesh_.triangles[triangle];
  const Vec3& a = mesh_.vertices[t[0]];
  return (closest_on(a, mesh_.vertices[t[1]], mesh_.vertices[t[2]], point).point - point).norm();
}

bool TriangleTree::has_point_above(const Vec3& normal, double height, const Vec3& centre,
                                   double radius) const {
  std::array<std::uint32_t, 64> open;  // the tree is balanced: depth under 32
  std::size_t size = 0;
  open[size++] = 0;
  while (size > 0) {
    const std::uint32_t index = open[--size];
    const Node& node = nodes_[index];
    const Vec3 highest = (normal.array() > 0.0).select(node.box.high, node.box.low);
    if (normal.dot(highest) <= height) continue;
    if (squared_distance(node.box, centre) > radius * radius) continue;
    if (node.count == 0) {
      open[size++] = index + 1;
      open[size++] = node.right;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      for (const std::uint32_t v : mesh_.triangles[order_[i]]) {
        if (normal.dot(mesh_.vertices[v]) > height) return true;
      }
    }
  }
  return false;
}

TriangleTree::Closest TriangleTree::closest_point(const Vec3& point, std::uint32_t hint) const {
  Closest best;
  // A hair above the hint's distance, so that of equally near triangles the same one is found.
  const double known = distance_to(hint, point) * (1.0 + 1e-9);
  best.squared_distance = std::nextafter(known * known, std::numeric_limits<double>::infinity());
  struct Visit {
    std::uint32_t node;
    double squared_distance;
  };
  std::array<Visit, 64> open;  // the tree is balanced: depth under 32
  std::size_t size = 0;
  open[size++] = {0, squared_distance(nodes_[0].box, point)};
  while (size > 0) {
    const Visit visit = open[--size];
    if (visit.squared_distance >= best.squared_distance) continue;
    const Node& node = nodes_[visit.node];
    if (node.count == 0) {
      Visit left = {visit.node + 1, squared_distance(nodes_[visit.node + 1].box, point)};
      Visit right = {node.right, squared_distance(nodes_[node.right].box, point)};
      if (left.squared_distance < right.squared_distance) std::swap(left, right);
      open[size++] = left;  // the nearer one is looked at first
      open[size++] = right;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const TriangleMesh::Triangle& t = mesh_.triangles[order_[i]];
      const OnTriangle found =
          closest_on(mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]], point);
      const double distance = (found.point - point).squaredNorm();
      if (distance < best.squared_distance) {
        best = {found.point, distance, order_[i], found.feature};
      }
    }
  }
  return best;
}

const Vec3& TriangleTree::feature_normal(const Closest& found) const {
  const TriangleMesh::Triangle& t = mesh_.triangles[found.triangle];
  if (found.feature == 0) return face_normals_[found.triangle];
  if (found.feature <= 3) return vertex_normals_[t[static_cast<std::size_t>(found.feature - 1)]];
  return side_normals_[found.triangle][static_cast<std::size_t>(found.feature - 4)];
}

double TriangleTree::signed_distance(const Vec3& point, std::uint32_t hint) const {
  const Closest found = closest_point(point, hint);
  const double distance = std::sqrt(found.squared_distance);
  return feature_normal(found).dot(point - found.point) < 0.0 ? -distance : distance;
}

TriangleTree::SignedClosest TriangleTree::signed_closest_point(const Vec3& point,
                                                               std::uint32_t hint) const {
  const Closest found = closest_point(point, hint);
  const TriangleMesh::Triangle& t = mesh_.triangles[found.triangle];
  const Vec3& a = mesh_.vertices[t[0]];
  const Vec3& b = mesh_.vertices[t[1]];
  const Vec3& c = mesh_.vertices[t[2]];
  const Vec3& normal = feature_normal(found);
  const Vec3 away = point - found.point;
  const double distance = std::sqrt(found.squared_distance);
  SignedClosest result;
  result.foot = found.point;
  result.triangle = found.triangle;
  result.distance = normal.dot(away) < 0.0 ? -distance : distance;
  // On the surface the direction from the closest point is undefined.
  const double size = a.cwiseAbs().maxCoeff() + (b - a).norm();
  const bool on_surface = distance <= kOnSurface * size;
  result.outward = on_surface ? Vec3(normal.normalized()) : Vec3(away / result.distance);
  const Vec3 area = (b - a).cross(c - a);
  const double square = area.squaredNorm();
  if (square > 0.0) {
    result.weights[0] = area.dot((c - b).cross(found.point - b)) / square;
    result.weights[1] = area.dot((a - c).cross(found.point - c)) / square;
    result.weights[2] = 1.0 - result.weights[0] - result.weights[1];
  } else {
    result.weights[0] = 1.0;
  }
  return result;
}

std::optional<TriangleTree::RayHit> TriangleTree::first_exit(const Vec3& origin,
                                                             const Vec3& direction,
                                                             std::uint32_t ignored) const {
  std::optional<RayHit> best;
  double nearest = std::numeric_limits<double>::infinity();
  const auto entry = [&](const Bounds& box) {
    double from = 0.0, to = nearest;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = box.low[axis] - origin[axis], high = box.high[axis] - origin[axis];
      if (direction[axis] == 0.0) {
        if (low > 0.0 || high < 0.0) return std::numeric_limits<double>::infinity();
        continue;
      }
      const double first = low / direction[axis], second = high / direction[axis];
      from = std::max(from, std::min(first, second));
      to = std::min(to, std::max(first, second));
    }
    return from <= to ? from : std::numeric_limits<double>::infinity();
  };
  std::array<std::uint32_t, 64> open;  // the tree is balanced: depth under 32
  std::size_t size = 0;
  open[size++] = 0;
  while (size > 0) {
    const std::uint32_t index = open[--size];
    const Node& node = nodes_[index];
    if (!(entry(node.box) < nearest)) continue;
    if (node.count == 0) {
      const bool left_first = entry(nodes_[index + 1].box) <= entry(nodes_[node.right].box);
      open[size++] = left_first ? node.right : index + 1;
      open[size++] = left_first ? index + 1 : node.right;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t triangle = order_[i];
      const Vec3& normal = face_normals_[triangle];
      const double along = normal.dot(direction);
      if (triangle == ignored || !(along > 0.0)) continue;
      const TriangleMesh::Triangle& t = mesh_.triangles[triangle];
      const double distance = normal.dot(mesh_.vertices[t[0]] - origin) / along;
      if (!(distance >= 0.0 && distance < nearest)) continue;
      const Vec3 point = origin + distance * direction;
      bool inside = true;
      for (std::size_t k = 0; k < 3 && inside; ++k) {
        const Vec3& from = mesh_.vertices[t[k]];
        inside = normal.dot((mesh_.vertices[t[(k + 1) % 3]] - from).cross(point - from)) >= 0.0;
      }
      if (!inside) continue;
      nearest = distance;
      best = RayHit{distance, triangle};
    }
  }
  return best;
}

}  // namespace clast
