#include "shapes/surface_detail.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/self_intersection.hpp"
#include "shapes/star_shape.hpp"

namespace clast {
namespace {

constexpr int kMostDegree = 20;
constexpr double kMaxGain = 10.0;
/// Vertices for each coefficient: fewer would fit the detail, too.
constexpr double kVerticesEach = 2.0;
/// Fraction of the mean distance below which the surface is not that of a rock.
constexpr double kMinDistance = 0.1;

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Real spherical harmonics of a direction up to a degree, by the stable recurrence of the
/// normalised associated Legendre functions.
Vector harmonics(const Vec3& u, int degree) {
  const int count = (degree + 1) * (degree + 1);
  Vector result(count);
  const double z = u.z(), across = std::hypot(u.x(), u.y());
  const double angle = std::atan2(u.y(), u.x());
  double sectoral = std::sqrt(0.25 / kPi);  // of degree m and order m
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) sectoral *= across * std::sqrt(1.0 + 0.5 / m);
    double below = 0.0, here = sectoral;
    for (int l = m; l <= degree; ++l) {
      if (l > m) {
        const double ll = l, mm = m;
        const double a = std::sqrt((4.0 * ll * ll - 1.0) / (ll * ll - mm * mm));
        const double b =
            std::sqrt(((ll - 1.0) * (ll - 1.0) - mm * mm) / (4.0 * (ll - 1.0) * (ll - 1.0) - 1.0));
        const double next = a * (z * here - b * below);
        below = here;
        here = next;
      }
      const double scale = m == 0 ? 1.0 : std::sqrt(2.0);
      result[l * l + l + m] = scale * here * std::cos(m * angle);
      if (m > 0) result[l * l + l - m] = scale * here * std::sin(m * angle);
    }
  }
  return result;
}

/// A third of the solid angle of each triangle at each of its corners.
std::vector<double> solid_angles(const TriangleMesh& mesh, const Vec3& centre) {
  std::vector<double> angles(mesh.vertices.size(), 0.0);
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3 a = (mesh.vertices[t[0]] - centre).normalized();
    const Vec3 b = (mesh.vertices[t[1]] - centre).normalized();
    const Vec3 c = (mesh.vertices[t[2]] - centre).normalized();
    const double angle = 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
    for (const std::uint32_t v : t) angles[v] += std::max(0.0, angle) / 3.0;
  }
  return angles;
}

TriangleMesh harmonic_detail(TriangleMesh mesh, const Vec3& centre,
                             const SurfaceDetailOptions& options) {
  const int count = (options.degree + 1) * (options.degree + 1);
  const auto vertices = static_cast<Eigen::Index>(mesh.vertices.size());
  const std::vector<double> weights = solid_angles(mesh, centre);
  Matrix rows(vertices, count);
  Vector distances(vertices), weight(vertices);
  for (Eigen::Index v = 0; v < vertices; ++v) {
    const Vec3 arm = mesh.vertices[static_cast<std::size_t>(v)] - centre;
    distances[v] = arm.norm();
    weight[v] = weights[static_cast<std::size_t>(v)];
    rows.row(v) = harmonics(arm / distances[v], options.degree).transpose();
  }
  const Matrix weighted = weight.asDiagonal() * rows;
  const Matrix normal = rows.transpose() * weighted;
  const Vector right = weighted.transpose() * distances;
  const Vector coarse = rows * normal.ldlt().solve(right);
  const double mean = distances.mean();
  for (Eigen::Index v = 0; v < vertices; ++v) {
    const double distance = coarse[v] + options.gain * (distances[v] - coarse[v]);
    if (!(distance > kMinDistance * mean)) {
      throw GeometryError("detail times " + format_significant(options.gain, 4) +
                          " would move the surface to less than a tenth of its mean radius from "
                          "the centre; give a smaller `detail` or a larger `degree`");
    }
    Vec3& vertex = mesh.vertices[static_cast<std::size_t>(v)];
    vertex = centre + distance / distances[v] * (vertex - centre);
  }
  return mesh;
}

TriangleMesh bilaplacian_detail(TriangleMesh mesh, const SurfaceDetailOptions& options) {
  const auto vertices = static_cast<Eigen::Index>(mesh.vertices.size());
  std::vector<double> around(mesh.vertices.size(), 0.0);
  const std::vector<HalfEdge> sides = sorted_half_edges(mesh);
  double length = 0.0;
  for (const HalfEdge& side : sides) {  // each edge twice
    around[side.low] += 0.5;
    around[side.high] += 0.5;
    length += (mesh.vertices[side.high] - mesh.vertices[side.low]).norm();
  }
  length /= static_cast<double>(sides.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index v = 0; v < vertices; ++v) entries.emplace_back(v, v, 1.0);
  for (const HalfEdge& side : sides) {
    const double share = -0.5 / std::sqrt(around[side.low] * around[side.high]);
    entries.emplace_back(side.low, side.high, share);
    entries.emplace_back(side.high, side.low, share);
  }
  using Sparse = Eigen::SparseMatrix<double>;
  Sparse laplacian(vertices, vertices), identity(vertices, vertices);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  identity.setIdentity();
  // On a uniform triangulation, waves k have the eigenvalue (k h)^2/4 of this Laplacian.
  const double l = options.degree;
  const double cut = l * (l + 1.0) * 4.0 * kPi / surface_area(mesh) * length * length / 4.0;
  const Sparse filter = identity + 1.0 / (cut * cut) * Sparse(laplacian * laplacian);
  const Eigen::SimplicialLDLT<Sparse> solver(filter);
  Matrix places(vertices, 3);
  for (Eigen::Index v = 0; v < vertices; ++v) {
    const auto i = static_cast<std::size_t>(v);
    places.row(v) = std::sqrt(around[i]) * mesh.vertices[i].transpose();
  }
  const Matrix coarse = solver.solve(places);
  for (Eigen::Index v = 0; v < vertices; ++v) {
    const auto i = static_cast<std::size_t>(v);
    const Vec3 smooth = coarse.row(v).transpose() / std::sqrt(around[i]);
    mesh.vertices[i] = smooth + options.gain * (mesh.vertices[i] - smooth);
  }
  if (!find_self_intersections(mesh).empty()) {
    throw GeometryError(
        "the surface is not star-shaped, and with detail times " +
        format_significant(options.gain, 4) +
        " it would cross itself; give a `detail` nearer to 1, or a larger `degree`");
  }
  return mesh;
}

}  // namespace

void SurfaceDetailOptions::check() const {
  if (!(gain >= 0.0 && gain <= kMaxGain)) {
    throw InputError("`detail` = " + format_significant(gain, 4) + ": must be from 0 to 10");
  }
  if (degree < 2 || degree > kMostDegree) {
    throw InputError("`degree` = " + std::to_string(degree) + ": must be from 2 to 20");
  }
}

ScaledDetailSurface scale_surface_detail(const TriangleMesh& mesh,
                                         const SurfaceDetailOptions& options) {
  options.check();
  const std::optional<Vec3> centre = find_kernel_centroid(mesh);
  const CoarseShapeMethod form =
      centre ? CoarseShapeMethod::kHarmonics : CoarseShapeMethod::kBilaplacian;
  if (options.gain == 1.0) return {mesh, form};
  if (!centre) return {bilaplacian_detail(mesh, options), form};
  const double needed = kVerticesEach * (options.degree + 1.0) * (options.degree + 1.0);
  if (static_cast<double>(mesh.vertices.size()) < needed) {
    throw InputError("`degree` = " + std::to_string(options.degree) + " needs " +
                     format_significant(needed, 6) + " vertices, and there are " +
                     std::to_string(mesh.vertices.size()) + "; give a smaller one");
  }
  return {harmonic_detail(mesh, *centre, options), form};
}

}  // namespace clast
