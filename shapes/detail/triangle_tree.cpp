#include "shapes/detail/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shapes/detail/edge_collapse.hpp"
#include "shapes/detail/half_edges.hpp"

namespace clast::detail {

namespace {

constexpr std::uint32_t kLeaf = 4;  ///< triangles in a leaf

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

TriangleTree::Closest TriangleTree::closest(const Vec3& point) const {
  Closest best;
  best.squared_distance = std::numeric_limits<double>::infinity();
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

double TriangleTree::signed_distance(const Vec3& point) const {
  const Closest found = closest(point);
  const TriangleMesh::Triangle& t = mesh_.triangles[found.triangle];
  const Vec3& normal =
      found.feature == 0 ? face_normals_[found.triangle]
      : found.feature <= 3
          ? vertex_normals_[t[static_cast<std::size_t>(found.feature - 1)]]
          : side_normals_[found.triangle][static_cast<std::size_t>(found.feature - 4)];
  const double distance = std::sqrt(found.squared_distance);
  return normal.dot(point - found.point) < 0.0 ? -distance : distance;
}

}  // namespace clast::detail
