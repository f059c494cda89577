#include "mesh/polygon.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace clast {

namespace {

using Indices = std::vector<std::uint32_t>;

/// Ears thinner than this share of their longest side are cut off last.
constexpr double kThinEar = 1e-6;

Vec3 normal_of(const TriangleMesh& mesh, const Indices& polygon) {
  const Vec3& origin = mesh.vertices[polygon[0]];
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    sum += (mesh.vertices[polygon[k - 1]] - origin).cross(mesh.vertices[polygon[k]] - origin);
  }
  return sum;
}

/// Area of a, b, c seen against `normal`, times two.
double turn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  return normal.dot((b - a).cross(c - a));
}

/// Smallest of the two triangles' areas when the diagonal starts at corner `k`.
double quad_quality(const TriangleMesh& mesh, const Indices& p, std::size_t k, const Vec3& normal) {
  const auto at = [&](std::size_t i) -> const Vec3& { return mesh.vertices[p[(k + i) % 4]]; };
  return std::min(turn(at(0), at(1), at(2), normal), turn(at(0), at(2), at(3), normal));
}

void take_better_diagonal(const TriangleMesh& mesh, Indices& quad, const Vec3& normal) {
  if (quad_quality(mesh, quad, 1, normal) > quad_quality(mesh, quad, 0, normal)) {
    quad = {quad[1], quad[2], quad[3], quad[0]};
  }
}

/// Convex, empty by a margin, and high enough: all by more than `thinnest` of its longest side.
bool is_ear(const TriangleMesh& mesh, const Indices& p, std::size_t k, const Vec3& normal,
            double thinnest) {
  const std::size_t n = p.size();
  const Vec3 &a = mesh.vertices[p[(k + n - 1) % n]], &b = mesh.vertices[p[k]],
             &c = mesh.vertices[p[(k + 1) % n]];
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if (!(turn(a, b, c, normal) > thinnest * longest)) return false;
  // Nor may a corner lie on the cut, or what is left would touch itself there.
  const double slack = -thinnest * longest;
  for (std::size_t i = 2; i + 1 < n; ++i) {
    const Vec3& other = mesh.vertices[p[(k + i) % n]];
    if (turn(a, b, other, normal) >= slack && turn(b, c, other, normal) >= slack &&
        turn(c, a, other, normal) >= slack) {
      return false;
    }
  }
  return true;
}

}  // namespace

void append_polygon(TriangleMesh& mesh, std::span<const std::int64_t> corners) {
  if (corners.size() < 3) {
    throw InputError("a face has " + std::to_string(corners.size()) +
                     " corners, at least 3 are needed");
  }
  Indices polygon;
  polygon.reserve(corners.size());
  for (const std::int64_t corner : corners) {
    if (corner < 0 || corner >= static_cast<std::int64_t>(mesh.vertices.size())) {
      throw InputError("a face refers to vertex " + std::to_string(corner + 1) +
                       " (counted from 1), but there are " + std::to_string(mesh.vertices.size()));
    }
    polygon.push_back(static_cast<std::uint32_t>(corner));
  }
  Vec3 normal = polygon.size() > 3 ? normal_of(mesh, polygon) : Vec3(Vec3::Zero());
  if (normal.norm() > 0.0) normal.normalize();
  const auto ear_of = [&](double thinnest) {
    std::size_t ear = 0;
    while (ear < polygon.size() && !is_ear(mesh, polygon, ear, normal, thinnest)) ++ear;
    return ear;
  };
  while (polygon.size() > 4 && polygon.size() <= kMaxEarClippingVertices) {
    std::size_t ear = ear_of(kThinEar);  // corners in a row make slivers when they are cut off
    if (ear == polygon.size()) ear = ear_of(0.0);
    if (ear == polygon.size()) break;
    const std::size_t n = polygon.size();
    mesh.triangles.push_back({polygon[(ear + n - 1) % n], polygon[ear], polygon[(ear + 1) % n]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  if (polygon.size() == 4) take_better_diagonal(mesh, polygon, normal);
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    mesh.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
  }
}

}  // namespace clast
