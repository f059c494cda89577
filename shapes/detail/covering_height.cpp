#include "shapes/detail/covering_height.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mesh/triangle_neighbours.hpp"
#include "mesh/triangle_tree.hpp"

namespace clast::shapes_detail {

namespace {

/// Triangles that a search has reached. It is kept between searches, so that each costs no more
/// than the triangles that it reaches.
class Reached {
 public:
  void restart(std::size_t triangles) {
    if (search_.size() < triangles) search_.resize(triangles, 0);
    if (++current_ == 0) {
      std::fill(search_.begin(), search_.end(), 0);
      current_ = 1;
    }
    open.clear();
  }
  void add(std::uint32_t triangle) {
    if (search_[triangle] == current_) return;
    search_[triangle] = current_;
    open.push_back(triangle);
  }

  std::vector<std::uint32_t> open;  ///< triangles whose neighbours were not looked at

 private:
  std::vector<std::uint32_t> search_;  ///< number of the last search that reached a triangle
  std::uint32_t current_ = 0;
};

/// Coordinates of a point relative to a flat triangle: how far inside it is of each side of the
/// triangle, times the length of the side, and its height above the plane.
using Coordinates = Eigen::Vector4d;

/// Converts points to coordinates relative to a flat triangle.
class FlatTriangle {
 public:
  FlatTriangle(const std::array<Vec3, 3>& corners, const Vec3& outward) {
    for (int k = 0; k < 3; ++k) {
      const auto from = static_cast<std::size_t>(k);
      axes_.row(k) = outward.cross(corners[(from + 1) % 3] - corners[from]);
      offsets_[k] = axes_.row(k).dot(corners[from]);
    }
    axes_.row(3) = outward;
    offsets_[3] = outward.dot(corners[0]);
  }
  Coordinates operator()(const Vec3& point) const { return axes_ * point - offsets_; }

 private:
  Eigen::Matrix<double, 4, 3> axes_;
  Coordinates offsets_;
};

/// True if no point of an edge projects onto the flat triangle.
bool is_beside(const Coordinates& from, const Coordinates& to) {
  double first = 0.0, last = 1.0;  // of the part that was not cut off, as fractions of the edge
  for (int side = 0; side < 3; ++side) {
    const double start = from[side], end = to[side];
    if (start < 0.0 && end < 0.0) return true;
    if (start < 0.0) first = std::max(first, start / (start - end));
    if (end < 0.0) last = std::min(last, start / (start - end));
  }
  return first > last;
}

/// Returns the largest height or depth of the part of a triangle that projects onto the flat one;
/// negative if there is none.
double clipped_height(const std::array<Coordinates, 3>& triangle) {
  std::array<Coordinates, 6> polygon = {triangle[0], triangle[1], triangle[2]}, clipped;
  std::size_t count = 3;
  for (int side = 0; side < 3; ++side) {
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Coordinates& p = polygon[i];
      const Coordinates& q = polygon[(i + 1) % count];
      if (p[side] >= 0.0) clipped[left++] = p;
      if ((p[side] < 0.0) != (q[side] < 0.0)) {
        clipped[left++] = p + p[side] / (p[side] - q[side]) * (q - p);
      }
    }
    std::swap(polygon, clipped);
    count = left;
  }
  double height = -1.0;
  for (std::size_t i = 0; i < count; ++i) height = std::max(height, std::abs(polygon[i][3]));
  return height;
}

/// True if a triangle whose normal is on the side of `outward` contains a point in the projection
/// along `outward`.
bool projects_onto(const std::array<Vec3, 3>& triangle, const Vec3& point, const Vec3& outward) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& from = triangle[k];
    if (outward.dot((triangle[(k + 1) % 3] - from).cross(point - from)) < 0.0) return false;
  }
  return true;
}

}  // namespace

std::optional<double> CoveringHeight::operator()(const std::array<Vec3, 3>& corners,
                                                 const Vec3& outward, std::uint32_t start,
                                                 double limit) const {
  const TriangleMesh& mesh = surface_.mesh();
  thread_local Reached reached;
  reached.restart(mesh.triangles.size());
  const FlatTriangle flat(corners, outward);
  // A part that covers the triangle also covers its centre.
  const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0;
  bool is_centre_covered = false;
  double largest = 0.0;
  reached.add(start);
  while (!reached.open.empty()) {
    const std::uint32_t triangle = reached.open.back();
    reached.open.pop_back();
    const auto& [a, b, c] = mesh.triangles[triangle];
    const std::array<Vec3, 3> points = {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    const std::array<Coordinates, 3> above = {flat(points[0]), flat(points[1]), flat(points[2])};
    if (above[0].cwiseMax(above[1]).cwiseMax(above[2]).head<3>().minCoeff() < 0.0) continue;
    double height =
        above[0].cwiseAbs().cwiseMax(above[1].cwiseAbs()).cwiseMax(above[2].cwiseAbs())[3];
    const bool covers = surface_.tree().face_normal(triangle).dot(outward) > 0.0;
    if (height > limit || !covers) height = clipped_height(above);
    if (height < 0.0) continue;
    if (height > limit || !covers) return std::nullopt;
    largest = std::max(largest, height);
    is_centre_covered = is_centre_covered || projects_onto(points, centre, outward);
    for (std::size_t side = 0; side < 3; ++side) {
      if (is_beside(above[side], above[(side + 1) % 3])) continue;
      const std::uint32_t next = surface_.neighbours().neighbour[triangle][side];
      if (next == kNoIndex) return std::nullopt;
      reached.add(next);
    }
  }
  if (!is_centre_covered) return std::nullopt;
  return largest;
}

}  // namespace clast::shapes_detail
