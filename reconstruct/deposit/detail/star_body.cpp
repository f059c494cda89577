#include "reconstruct/deposit/detail/star_body.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "mesh/geodesic_sphere.hpp"
#include "mesh/plane.hpp"
#include "mesh/triangle_geometry.hpp"
#include "reconstruct/cloud/cloud.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr double kObservedGap = 2.2;  ///< spacings between a seen point and the unobserved surface
constexpr double kDecay = 0.5;        ///< rad, in the frame of the unit sphere
/// Radius of the unobserved side over the mean radius of the observed side, in the frame of the
/// unit sphere. Without bias of volume and axes for virtual deposits on floors, slopes and fines.
constexpr double kHiddenFraction = 0.85;
constexpr int kRadiusNeighbours = 12;  ///< points from which the radius follows
constexpr double kRidge = 0.05;        ///< damping of the slope of the regression
constexpr double kEdgeSpacings = 2.0;  ///< wanted length of an edge, in spacings
/// Tangent planes that bound the unobserved side: number tried, fraction of points that may lie
/// above one, and tolerance over the mean radius.
constexpr std::size_t kTriedPlanes = 300;
constexpr double kMaxAbove = 0.02, kAboveTolerance = 0.03;
/// Factor by which the radius of a vertex in free space is reduced repeatedly, and its least value.
constexpr double kCarvingStep = 0.95, kLeastRadius = 0.3;
constexpr int kCoarsest = 6, kFinest = 12;  ///< divisions of an icosahedron's edge

/// Radius in the direction `u` by local linear regression over the nearest points.
double interpolate_radius(const Vec3& u, std::span<const PointTree::Neighbour> near,
                          std::span<const Vec3> directions, std::span<const double> radii) {
  const Vec3 e1 = u.unitOrthogonal(), e2 = u.cross(e1);
  const double scale = std::max(near[near.size() / 2].distance, 1e-4);
  Mat3 normal = Mat3::Zero();
  Vec3 right = Vec3::Zero();
  double low = radii[near.front().point], high = low;
  for (const PointTree::Neighbour& n : near) {
    const Vec3 row(1.0, e1.dot(directions[n.point]) / scale, e2.dot(directions[n.point]) / scale);
    const double weight = std::exp(-0.5 * std::pow(n.distance / scale, 2));
    normal += weight * row * row.transpose();
    right += weight * radii[n.point] * row;
    low = std::min(low, radii[n.point]);
    high = std::max(high, radii[n.point]);
  }
  normal.diagonal().tail<2>().array() += kRidge * normal(0, 0);
  return std::clamp(normal.ldlt().solve(right)[0], low, high);
}

/// Tangent planes with nearly all points below them, in the frame of the unit sphere.
std::vector<Plane> supporting_planes(std::span<const Vec3> positions,
                                     std::span<const Vec3> normals) {
  const std::size_t step = std::max<std::size_t>(1, positions.size() / kTriedPlanes);
  std::vector<Plane> planes;
  for (std::size_t i = step / 2; i < positions.size(); i += step) {
    const Plane plane{normals[i], normals[i].dot(positions[i])};
    std::size_t above = 0, all = 0;
    for (std::size_t j = step / 2; j < positions.size(); j += step, ++all) {
      above += plane.signed_distance(positions[j]) > kAboveTolerance;
    }
    if (static_cast<double>(above) <= kMaxAbove * static_cast<double>(all) &&
        plane.distance > 0.0) {
      planes.push_back(plane);
    }
  }
  return planes;
}

}  // namespace

StarBody fit_star_body(std::span<const SurfaceSample> points, const Ellipsoid& ellipsoid,
                       double spacing, const std::function<bool(const Vec3&)>& is_free) {
  std::vector<Vec3> positions, directions, normals;
  std::vector<double> radii;
  for (const SurfaceSample& p : points) {
    const Vec3 y = ellipsoid.to_unit_sphere(p.position);
    const double radius = std::max(y.norm(), 1e-9);
    positions.push_back(y);
    directions.push_back(y / radius);
    radii.push_back(radius);
    normals.push_back(
        (ellipsoid.axes.transpose() * p.normal).cwiseProduct(ellipsoid.semi_axes).normalized());
  }
  const PointTree tree(directions);
  const std::vector<Plane> planes = supporting_planes(positions, normals);
  const double mean_radius = std::cbrt(ellipsoid.semi_axes.prod());
  const int frequency =
      std::clamp(static_cast<int>(std::lround(1.1 * mean_radius / (kEdgeSpacings * spacing))),
                 kCoarsest, kFinest);
  StarBody body;
  body.mesh = geodesic_sphere(frequency);
  std::vector<double> vertex_radii;
  double cubes = 0.0, observed_count = 0.0;
  for (const Vec3& u : body.mesh.vertices) {
    const auto near = tree.nearest_neighbours(u, kRadiusNeighbours);
    vertex_radii.push_back(interpolate_radius(u, near, directions, radii));
    const Vec3 here = ellipsoid.from_unit_sphere(radii[near.front().point] * u);
    const bool observed =
        (here - points[near.front().point].position).norm() < kObservedGap * spacing;
    body.is_vertex_observed.push_back(observed);
    if (!observed) continue;
    cubes += std::pow(vertex_radii.back(), 3);
    observed_count += 1.0;
  }
  const double mean =
      kHiddenFraction * (observed_count > 0.0 ? std::cbrt(cubes / observed_count) : 1.0);
  for (std::size_t v = 0; v < vertex_radii.size(); ++v) {
    const Vec3 u = body.mesh.vertices[v];
    double& radius = vertex_radii[v];
    if (!body.is_vertex_observed[v]) {
      const auto near = tree.nearest_neighbours(u, kRadiusNeighbours);
      double rim = 0.0;
      for (const PointTree::Neighbour& n : near) {
        rim += radii[n.point] / static_cast<double>(near.size());
      }
      const double angle = near.front().distance;
      radius = mean + (rim - mean) * std::exp(-(angle / kDecay) * (angle / kDecay));
      for (const Plane& plane : planes) {
        const double cosine = plane.normal.dot(u);
        if (cosine > 0.0) radius = std::min(radius, plane.distance / cosine);
      }
      const double least = kLeastRadius * radius;
      while (is_free && radius > least && is_free(ellipsoid.from_unit_sphere(radius * u))) {
        radius *= kCarvingStep;
      }
    }
    body.mesh.vertices[v] = ellipsoid.from_unit_sphere(radius * u);
  }
  double area = 0.0, observed_area = 0.0;
  for (const TriangleMesh::Triangle& t : body.mesh.triangles) {
    const double a = 0.5 * doubled_area_vector(body.mesh, t).norm();
    int observed = 0;
    for (const std::uint32_t v : t) observed += body.is_vertex_observed[v];
    area += a;
    observed_area += a * observed / 3.0;
  }
  body.visible_fraction = observed_area / area;
  return body;
}

}  // namespace clast::reconstruct_detail
