#include "reconstruct/registration/detail/doubled_places.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/statistics/statistics.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/outliers.hpp"
#include "reconstruct/registration/detail/even_subset.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kPlaces = 900;
/// Radius of a place and greatest height of its points, relative to the diagonal of the points.
constexpr double kPlaceRadius = 0.035, kGreatestHeight = 0.04;
constexpr double kPlacePoints = 36.0;  ///< least number of points, by their density
constexpr int kMostPlacePoints = 160;
constexpr double kFacingAlike = 0.5;  ///< cosine of normals of one side of a body
constexpr std::size_t kFewestOfSheet = 7;
constexpr double kLeastOfSheet = 0.15;  ///< of the points of a place on either sheet
/// Distance of two sheets in standard deviations about them. The halves of normally distributed
/// heights are 2.7 apart, those of evenly distributed ones 3.5.
constexpr double kSheetDistance = 3.9;
/// Number of points whose nearest point is on the other sheet, at least, relative to the expected
/// number for sheets that are everywhere.
constexpr double kMixed = 0.5;
constexpr int kRounds = 4;

/// Points around a place in its tangent frame.
struct LocalPoints {
  std::vector<std::uint32_t> points;
  std::vector<Eigen::Vector2d> beside;  ///< relative to the radius
  std::vector<double> heights;          ///< m
};

/// Sheets of a place: heights relative to a common quadric, and a division of the points.
struct Sheets {
  std::vector<bool> is_outer;
  double distance = 0.0, scatter = 0.0;
  std::size_t outer = 0;
};

/// Divides heights at the value that leaves the least squares within both parts.
std::vector<bool> divide_heights(const std::vector<double>& heights) {
  std::vector<std::size_t> order(heights.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
  const double total = std::accumulate(heights.begin(), heights.end(), 0.0);
  const auto count = static_cast<double>(heights.size());
  double low = 0.0, best = -1.0;
  std::size_t split = 1;
  for (std::size_t i = 1; i < order.size(); ++i) {
    low += heights[order[i - 1]];
    const auto n = static_cast<double>(i);
    const double between = low * low / n + (total - low) * (total - low) / (count - n);
    if (between <= best) continue;
    best = between;
    split = i;
  }
  std::vector<bool> is_upper(heights.size(), false);
  for (std::size_t i = split; i < order.size(); ++i) is_upper[order[i]] = true;
  return is_upper;
}

/// Fits a quadric, with a step between both sheets if `is_outer` is not empty.
/// @return  its coefficients, the step last
Eigen::VectorXd fit_quadric(const LocalPoints& local, const std::vector<bool>& is_outer) {
  const auto count = static_cast<Eigen::Index>(local.points.size());
  Eigen::MatrixXd terms(count, 7);
  Eigen::VectorXd heights(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double x = local.beside[k].x(), y = local.beside[k].y();
    terms.row(i) << 1.0, x, y, x * x, x * y, y * y, !is_outer.empty() && is_outer[k] ? 1.0 : 0.0;
    heights[i] = local.heights[k];
  }
  return terms.colPivHouseholderQr().solve(heights);
}

double quadric_at(const Eigen::VectorXd& c, const Eigen::Vector2d& at) {
  const double x = at.x(), y = at.y();
  return c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
}

double scatter_about(const LocalPoints& local, const Eigen::VectorXd& c,
                     const std::vector<bool>& is_outer) {
  double squares = 0.0;
  for (std::size_t i = 0; i < local.points.size(); ++i) {
    const double step = !is_outer.empty() && is_outer[i] ? c[6] : 0.0;
    squares += std::pow(local.heights[i] - quadric_at(c, local.beside[i]) - step, 2);
  }
  const double freedom = static_cast<double>(local.points.size()) - (is_outer.empty() ? 6.0 : 7.0);
  return std::sqrt(squares / std::max(1.0, freedom));
}

Sheets fit_two_sheets(const LocalPoints& local, const Eigen::VectorXd& single) {
  Sheets sheets;
  Eigen::VectorXd fitted = single;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> above;
    for (std::size_t i = 0; i < local.points.size(); ++i) {
      above.push_back(local.heights[i] - quadric_at(fitted, local.beside[i]));
    }
    std::vector<bool> divided = divide_heights(above);
    if (divided == sheets.is_outer) break;
    sheets.is_outer = std::move(divided);
    fitted = fit_quadric(local, sheets.is_outer);
  }
  sheets.distance = fitted[6];
  sheets.scatter = scatter_about(local, fitted, sheets.is_outer);
  sheets.outer =
      static_cast<std::size_t>(std::count(sheets.is_outer.begin(), sheets.is_outer.end(), true));
  return sheets;
}

bool are_apart(const Sheets& sheets, const LocalPoints& local) {
  const std::size_t count = local.points.size();
  const std::size_t fewer = std::min(sheets.outer, count - sheets.outer);
  const auto least = static_cast<std::size_t>(kLeastOfSheet * static_cast<double>(count));
  if (fewer < std::max(kFewestOfSheet, least) ||
      sheets.distance < kSheetDistance * sheets.scatter) {
    return false;
  }
  // Sides of ledges and edges are beside each other.
  double mixed = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    double nearest = 1e300;
    bool differs = false;
    for (std::size_t k = 0; k < count; ++k) {
      const double square = (local.beside[k] - local.beside[i]).squaredNorm();
      if (k == i || square >= nearest) continue;
      nearest = square;
      differs = sheets.is_outer[i] != sheets.is_outer[k];
    }
    mixed += differs;
  }
  const double share = static_cast<double>(sheets.outer) / static_cast<double>(count);
  return mixed >= kMixed * 2.0 * share * (1.0 - share) * static_cast<double>(count);
}

}  // namespace

std::vector<SurfacePlace> examine_places(std::span<const Vec3> points,
                                         std::span<const Vec3> normals) {
  Bounds box;
  for (const Vec3& p : points) box.include(p);
  const double spacing = upper_median(compute_local_spacings(points));
  const double radius =
      std::max(kPlaceRadius * box.diagonal(), spacing * std::sqrt(kPlacePoints / kPi));
  const double greatest = std::max(kGreatestHeight * box.diagonal(), radius);
  const PointTree tree(points);
  std::vector<SurfacePlace> places;
  for (const std::uint32_t middle : choose_even_subset(points, kPlaces)) {
    const Vec3& normal = normals[middle];
    const Vec3 east = normal.unitOrthogonal(), north = normal.cross(east);
    LocalPoints local;
    for (const auto& near : tree.nearest_neighbours(points[middle], kMostPlacePoints)) {
      if (near.distance > std::hypot(radius, greatest)) break;
      const Vec3 offset = points[near.point] - points[middle];
      const double height = normal.dot(offset);
      const Eigen::Vector2d beside(offset.dot(east) / radius, offset.dot(north) / radius);
      if (beside.norm() > 1.0 || std::abs(height) > greatest ||
          normals[near.point].dot(normal) < kFacingAlike) {
        continue;
      }
      local.points.push_back(near.point);
      local.beside.push_back(beside);
      local.heights.push_back(height);
    }
    if (local.points.size() < 3 * kFewestOfSheet) continue;
    const Eigen::VectorXd single = fit_quadric(local, {});
    SurfacePlace place{points[middle] + single[0] * normal, normal,
                       scatter_about(local, single, {})};
    const Sheets sheets = fit_two_sheets(local, single);
    if (are_apart(sheets, local)) {
      place.distance = sheets.distance;
      place.scatter = sheets.scatter;
      const auto outer = static_cast<double>(sheets.outer);
      const double inner = static_cast<double>(local.points.size()) - outer;
      place.distance_error = sheets.scatter * std::sqrt(1.0 / inner + 1.0 / outer);
      for (std::size_t i = 0; i < local.points.size(); ++i) {
        (sheets.is_outer[i] ? place.outer : place.inner).push_back(local.points[i]);
      }
    }
    places.push_back(std::move(place));
  }
  return places;
}

}  // namespace clast::reconstruct_detail
