#include "reconstruct/registration/oriented_surface.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/statistics/statistics.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/cloud_normals.hpp"
#include "reconstruct/cloud/local_surface.hpp"
#include "reconstruct/cloud/outliers.hpp"
#include "reconstruct/registration/detail/even_subset.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kNeighbours = 16;  ///< about 2.3 spacings around
/// Radius of the points of a plane, in cells; ratio of these points where the scan is denser than
/// on average; at least and at most.
constexpr double kPlaneRadius = 2.3, kDenser = 2.0;
constexpr int kFewestPlanePoints = 10, kMostPlanePoints = 400;
/// Smallest cell as a fraction of the diagonal of the points.
constexpr double kSmallestCell = 0.012;
/// Angle between the directions to neighbours beyond which a point is at a border, rad.
constexpr double kBorderGap = 2.0;
constexpr int kNoiseNormalNeighbours = 24;

Bounds bounds_of(std::span<const Vec3> points) {
  Bounds box;
  for (const Vec3& p : points) box.include(p);
  return box;
}

/// Plane through points near a point: centre and unit normal of either sign.
std::pair<Vec3, Vec3> plane_of_neighbours(std::span<const Vec3> points,
                                          const std::vector<PointTree::Neighbour>& near) {
  Vec3 centre = Vec3::Zero();
  for (const auto& n : near) centre += points[n.point];
  centre /= static_cast<double>(near.size());
  Mat3 scatter = Mat3::Zero();
  for (const auto& n : near) {
    const Vec3 offset = points[n.point] - centre;
    scatter += offset * offset.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(scatter);
  const Vec3 normal = solver.eigenvectors().col(0);
  const bool usable = normal.allFinite() && normal.norm() > 0.5;
  return {centre, usable ? Vec3(normal.normalized()) : Vec3(Vec3::UnitZ())};
}

/// Moves the chosen points to the planes of the points around them. The planes lie below convex
/// surfaces, by equal amounts for equal radii.
void fit_planes(OrientedSurface& surface, std::span<const Vec3> points,
                const std::vector<Vec3>& chosen, double radius, double density) {
  const PointTree tree(points);
  const int most = std::clamp(static_cast<int>(kDenser * kCellsPerPlane * density),
                              kFewestPlanePoints, kMostPlanePoints);
  for (const Vec3& p : chosen) {
    std::vector<PointTree::Neighbour> near = tree.nearest_neighbours(p, most);
    while (near.size() > kFewestPlanePoints && near.back().distance > radius) near.pop_back();
    const auto [centre, normal] = plane_of_neighbours(points, near);
    surface.normals.push_back(normal);
    surface.points.push_back(p + normal.dot(centre - p) * normal);
  }
}

/// True if the neighbours of a point leave a wide angle open around it.
bool has_open_side(const OrientedSurface& surface, std::size_t point) {
  const Vec3& normal = surface.normals[point];
  const Vec3 east = normal.unitOrthogonal(), north = normal.cross(east);
  std::vector<double> angles;
  for (const std::uint32_t n : surface.neighbours_of(point)) {
    const Vec3 offset = surface.points[n] - surface.points[point];
    angles.push_back(std::atan2(offset.dot(north), offset.dot(east)));
  }
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + 2.0 * kPi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) {
    widest = std::max(widest, angles[i] - angles[i - 1]);
  }
  return widest > kBorderGap;
}

double noise_of(std::span<const Vec3> points) {
  const std::vector<Vec3> normals = estimate_normals(points, kNoiseNormalNeighbours);
  return MovingLeastSquares(points, normals, false).estimate_noise();
}

}  // namespace

OrientedSurface scaled(OrientedSurface surface, double factor) {
  for (Vec3& p : surface.points) p *= factor;
  surface.spacing *= factor;
  surface.noise *= factor;
  surface.point_noise *= factor;
  if (surface.ground) surface.ground->distance *= factor;
  return surface;
}

double registration_cell(std::span<const Vec3> points) {
  const double spacing = upper_median(compute_local_spacings(points));
  return std::max(spacing, kSmallestCell * bounds_of(points).diagonal());
}

OrientedSurface orient_surface(std::span<const Vec3> points, double cell,
                               const std::optional<Plane>& ground) {
  OrientedSurface surface;
  surface.ground = ground;
  std::vector<Vec3> chosen;
  for (const std::uint32_t i : choose_one_per_cell(points, cell)) chosen.push_back(points[i]);
  const double density = static_cast<double>(points.size()) / static_cast<double>(chosen.size());
  surface.noise = noise_of(points);
  surface.point_noise = surface.noise / std::sqrt(density);
  fit_planes(surface, points, chosen, kPlaneRadius * cell, density);
  orient_outward(surface.normals, chosen);
  surface.neighbour_count = std::min(kNeighbours, surface.size() - 1);
  const PointTree tree(surface.points);
  std::vector<double> spacings;
  for (std::uint32_t i = 0; i < surface.size(); ++i) {
    const int count = static_cast<int>(surface.neighbour_count);
    std::size_t found = 0;
    for (const auto& n : tree.nearest_neighbours(surface.points[i], count + 1)) {
      if (n.point == i || found == surface.neighbour_count) continue;
      surface.neighbours.push_back(n.point);
      if (++found == 6) spacings.push_back(n.distance * std::sqrt(kPi / 6.0));
    }
  }
  surface.spacing = upper_median(spacings);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    surface.is_border.push_back(has_open_side(surface, i));
  }
  return surface;
}

}  // namespace clast::reconstruct_detail
