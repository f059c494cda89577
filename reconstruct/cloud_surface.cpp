#include "reconstruct/cloud_surface.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "reconstruct/detail/cloud.hpp"
#include "reconstruct/detail/pieces.hpp"
#include "reconstruct/detail/poisson.hpp"
#include "reconstruct/detail/soup.hpp"
#include "reconstruct/detail/touching_sheets.hpp"
#include "shapes/mesh_topology.hpp"

namespace clast {

namespace {

/// Neighbours a normal is handed on to.
constexpr int kHanding = 12;
/// Unsupported patches with less than this share of the area are gaps between points and stay.
constexpr double kGapShare = 0.005;
constexpr double kSpacings = 2.0;  ///< a cell holds about four points at least
/// Points that lie closer about a plane than this share of their diagonal bound no body.
constexpr double kFlat = 1e-3;

/// Turns the normals from neighbour to neighbour along the tree that bends least, from the point
/// farthest from the middle, whose normal faces away from it.
void turn_outward(std::vector<Vec3>& normals, const std::vector<Vec3>& points) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  const detail::NearestPoints tree(points);
  struct Step {
    double bend;
    std::uint32_t from, to;
    bool operator>(const Step& other) const {
      return bend != other.bend ? bend > other.bend
                                : std::pair(from, to) > std::pair(other.from, other.to);
    }
  };
  std::vector<std::vector<std::uint32_t>> beside(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    for (const auto& near : tree.nearest(points[i], kHanding)) {
      beside[i].push_back(near.point);
      beside[near.point].push_back(i);
    }
  }
  std::vector<bool> done(points.size(), false);
  std::vector<std::uint32_t> outermost(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) outermost[i] = i;
  std::stable_sort(outermost.begin(), outermost.end(), [&](std::uint32_t a, std::uint32_t b) {
    return (points[a] - middle).squaredNorm() > (points[b] - middle).squaredNorm();
  });
  std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
  const auto settle = [&](std::uint32_t point, const Vec3& like) {
    if (normals[point].dot(like) < 0.0) normals[point] = -normals[point];
    done[point] = true;
    for (const std::uint32_t next : beside[point]) {
      if (!done[next]) open.push({1.0 - std::abs(normals[point].dot(normals[next])), point, next});
    }
  };
  for (const std::uint32_t start : outermost) {  // a second piece, if there is one, starts anew
    if (done[start]) continue;
    settle(start, points[start] - middle);
    while (!open.empty()) {
      const Step step = open.top();
      open.pop();
      if (!done[step.to]) settle(step.to, normals[step.from]);
    }
  }
}

/// Standard deviation of the points about the plane, and about the line, that fits them best, m.
std::array<double, 2> thicknesses(std::span<const Vec3> points) {
  const auto count = static_cast<double>(points.size());
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points) centre += p / count;
  Mat3 scatter = Mat3::Zero();
  for (const Vec3& p : points) scatter += (p - centre) * (p - centre).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(scatter, Eigen::EigenvaluesOnly);
  const Vec3 squares = solver.eigenvalues().cwiseMax(0.0);
  return {std::sqrt(squares[0]), std::sqrt(squares[1])};
}

/// The solver for the surface fails on points without volume.
void refuse_flat(std::span<const Vec3> points, double diagonal) {
  const auto [plane, line] = thicknesses(points);
  if (plane > kFlat * diagonal) return;
  const char* const what = !(diagonal > 0.0)         ? "at one place"
                           : line > kFlat * diagonal ? "in a plane"
                                                     : "on a line";
  throw GeometryError("all " + std::to_string(points.size()) + " points lie " + what +
                      " and bound no block; scan the block from all sides, and check which columns "
                      "of the file are x, y and z");
}

double area_of(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  return 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                   .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                   .norm();
}

/// Which triangles are near points. Small patches that are not count as seen too.
std::vector<bool> supported(const TriangleMesh& mesh, const std::vector<Vec3>& points,
                            double reach) {
  const detail::NearestPoints tree(points);
  std::vector<bool> seen(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
    seen[t] = tree.nearest(middle, 1).front().distance < reach;
  }
  std::vector<std::size_t> unseen;
  std::vector<bool> other(seen.size());
  for (std::size_t t = 0; t < seen.size(); ++t) {
    other[t] = !seen[t];
    if (!seen[t]) unseen.push_back(t);
  }
  const TriangleMesh gaps = detail::with_triangles(mesh, other);
  const std::vector<std::uint32_t> patch_of = triangle_components(gaps);
  std::vector<double> areas;
  for (std::size_t i = 0; i < unseen.size(); ++i) {
    if (patch_of[i] >= areas.size()) areas.resize(patch_of[i] + 1, 0.0);
    areas[patch_of[i]] += area_of(gaps, gaps.triangles[i]);
  }
  const double most = kGapShare * surface_area(mesh);
  for (std::size_t i = 0; i < unseen.size(); ++i) {
    if (areas[patch_of[i]] < most) seen[unseen[i]] = true;
  }
  return seen;
}

/// The same mesh, its vertices and triangles in an order that follows from the coordinates alone:
/// CGAL hands facets out in the order of their places in memory.
TriangleMesh in_order(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.vertices.size()), number(mesh.vertices.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b];
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  });
  TriangleMesh result;
  for (std::uint32_t v = 0; v < order.size(); ++v) {
    number[order[v]] = v;
    result.vertices.push_back(mesh.vertices[order[v]]);
  }
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    TriangleMesh::Triangle triangle = {number[t[0]], number[t[1]], number[t[2]]};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    result.triangles.push_back(triangle);
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  return result;
}

TriangleMesh largest_piece(const TriangleMesh& mesh) {
  std::vector<detail::Piece> pieces = detail::pieces_of(mesh);
  return pieces.empty() ? TriangleMesh() : std::move(pieces.front().mesh);
}

}  // namespace

void CloudSurfaceOptions::check() const {
  const auto require = [](bool fine, const char* name, double value) {
    if (fine) return;
    throw InputError(std::string(name) + " = " + with_digits(value, 4) + " is out of range");
  };
  require(cell > 0.0 && cell <= 0.1, "cell", cell);
  require(neighbours >= 3 && neighbours <= 200, "neighbours", neighbours);
  require(edge > 0.0 && edge <= 20.0, "edge", edge);
  require(trim > 0.0, "trim", trim);
}

TriangleMesh cloud_surface(std::span<const Vec3> points, const CloudSurfaceOptions& options) {
  options.check();
  if (points.size() < options.fewest) {
    throw InputError(std::to_string(points.size()) + " points are too few for a block; at least " +
                     std::to_string(options.fewest) + " are needed");
  }
  Bounds box;
  for (const Vec3& p : points) box.include(p);
  refuse_flat(points, box.diagonal());
  const double cell = std::max(options.cell * box.diagonal(), kSpacings * detail::spacing(points));
  const std::vector<Vec3> thin = detail::thinned(points, cell);
  const double apart = detail::spacing(thin);
  std::vector<Vec3> normals = detail::plane_normals(thin, options.neighbours);
  turn_outward(normals, thin);
  const TriangleMesh closed = detail::poisson_surface(thin, normals, options.edge * apart);
  if (closed.triangles.empty()) {
    throw GeometryError("no surface was found through the " + std::to_string(points.size()) +
                        " points; are they of one block, and on its surface?");
  }
  TriangleMesh whole = in_order(largest_piece(closed));
  if (detail::signed_volume(whole) < 0.0) {
    detail::turn_over(whole);
    whole = in_order(whole);
  }
  TriangleMesh open = largest_piece(
      detail::with_triangles(whole, supported(whole, thin, options.trim * std::max(cell, apart))));
  if (open.triangles.empty()) {
    throw GeometryError("the surface found does not follow the points; are they on one surface?");
  }
  detail::split_pinched_vertices(open);
  return open;
}

}  // namespace clast
