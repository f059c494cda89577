#include "shapes/detail/gauss_image.hpp"

#include <cmath>
#include <span>
#include <utility>

#include "mesh/half_edges.hpp"
#include "shapes/convex_outline.hpp"
#include "shapes/detail/calipers.hpp"

namespace clast {

namespace {

// Sine of the angle within which a face counts as seen on edge.
constexpr double kOnEdge = 1e-11;
// Minimum arc between the normals of two faces, and minimum difference from half a turn, rad.
constexpr double kNoArc = 1e-12;

}  // namespace

GaussImage::GaussImage(const TriangleMesh& mesh, double radius)
    : vertices_(mesh.vertices), radius_(radius), next_(mesh.vertices.size(), 0) {
  const auto count = static_cast<Eigen::Index>(vertices_.size());
  coordinates_.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) coordinates_.row(i) = vertices_[i].transpose();
  const auto faces = static_cast<Eigen::Index>(mesh.triangles.size());
  normals_.resize(faces, 3);
  weighted_normals_.resize(faces, 3);
  areas_.resize(faces);
  up_.resize(mesh.triangles.size());
  for (Eigen::Index f = 0; f < faces; ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const Vec3 cross = (vertices_[b] - vertices_[a]).cross(vertices_[c] - vertices_[a]);
    const double twice = cross.norm();
    areas_[f] = 0.5 * twice;
    // A face without area adds no direction of its own; any will do, as every box is measured.
    const Vec3 normal = twice > 0.0 ? Vec3(cross / twice) : Vec3::UnitX();
    normals_.row(f) = normal.transpose();
    weighted_normals_.row(f) = 0.5 * cross.transpose();
  }
  for_each_edge(sorted_half_edges(mesh), [&](std::span<const HalfEdge> sides) {
    if (!is_interior_edge(sides)) return;
    const std::size_t out = sides[0].is_forward ? 0 : 1;
    edges_.push_back({sides[0].low, sides[0].high, sides[out].triangle, sides[1 - out].triangle});
  });
}

double GaussImage::arc_length(std::size_t edge) const {
  const Vec3 a = normal(edges_[edge].face), b = normal(edges_[edge].other_face);
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vec3 GaussImage::point_on_arc(std::size_t edge, double share) const {
  const Vec3 a = normal(edges_[edge].face), b = normal(edges_[edge].other_face);
  const double angle = arc_length(edge);
  // Opposite normals, of which one is that of a face without area, have no arc between them.
  if (!(angle > kNoArc && angle < kPi - kNoArc)) return a;
  return (std::sin((1.0 - share) * angle) * a + std::sin(share * angle) * b).normalized();
}

BoxCandidate GaussImage::smallest_box_along(const Vec3& direction, double limit) {
  along_.noalias() = coordinates_ * direction;
  const double width = along_.maxCoeff() - along_.minCoeff() + 2.0 * radius_;
  slopes_.noalias() = weighted_normals_ * direction;
  const double shadow = 0.5 * slopes_.cwiseAbs().sum();
  const double side = std::sqrt(shadow) + 2.0 * radius_;
  if (width * side * side > limit) return {};

  Mat3 frame;
  frame.col(0) = direction;
  frame.col(1) = direction.unitOrthogonal();
  frame.col(2) = direction.cross(frame.col(1));
  trace_outline(frame);
  const EnclosingRectangle rectangle = smallest_outline_rectangle(outline_, radius_);
  BoxCandidate posture;
  posture.axes.col(0) = direction;
  posture.axes.col(1) =
      (rectangle.direction.x() * frame.col(1) + rectangle.direction.y() * frame.col(2))
          .normalized();
  posture.axes.col(2) = posture.axes.col(0).cross(posture.axes.col(1));
  posture.volume = width * rectangle.area();
  return posture;
}

void GaussImage::trace_outline(const Mat3& frame) {
  for (std::size_t f = 0; f < up_.size(); ++f) {
    const auto i = static_cast<Eigen::Index>(f);
    // All faces on edge count as facing up; if rounding decided, the outline would zigzag.
    up_[f] = slopes_[i] >= -kOnEdge * areas_[i];
  }
  std::size_t count = 0;
  std::uint32_t start = 0;
  for (const Edge& edge : edges_) {
    if (up_[edge.face] == up_[edge.other_face]) continue;
    const bool forward = up_[edge.face] != 0;
    start = forward ? edge.from : edge.to;
    next_[start] = forward ? edge.to : edge.from;
    ++count;
  }
  outline_.clear();
  const auto add = [&](std::uint32_t v) {
    outline_.emplace_back(frame.col(1).dot(vertices_[v]), frame.col(2).dot(vertices_[v]));
  };
  std::uint32_t v = start;
  do {
    add(v);
    v = next_[v];
  } while (v != start && outline_.size() < count);
  if (v == start && outline_.size() == count) {
    outline_ = remove_reflex_vertices(std::move(outline_));
    return;
  }
  // Faces on edge, up or down by rounding, can pinch the loop.
  outline_.clear();
  for (const Edge& edge : edges_) {
    if (up_[edge.face] == up_[edge.other_face]) continue;
    add(edge.from);
    add(edge.to);
  }
  outline_ = convex_hull_2d(std::move(outline_));
}

}  // namespace clast
