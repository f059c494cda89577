#include "reconstruct/cloud/local_surface.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/parallel.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Cosine to the normal of the place below which a point is of another side: of a plate's other
/// face, or round a sharp edge.
constexpr double kSameSide = 0.4;
constexpr std::size_t kMinQuadricPoints = 9;  ///< points for the six coefficients of a quadric
constexpr double kFarthestMove = 3.0;         ///< noises that a point is moved at most
constexpr std::size_t kNoiseSamples = 2000;
constexpr std::size_t kPointChunk = 64;  ///< points that one thread takes at a time
/// Numbers of neighbours a point is smoothed over: the most that one quadric, or plane, fits as
/// well as the noise lets it.
constexpr std::array<int, 4> kScales = {24, 48, 96, 192};
/// A point is off the surface by so many spacings and standard deviations of its neighbours, and
/// its own spacing so many times theirs.
constexpr double kOffSpacings = 0.4, kOffDeviations = 3.0;
constexpr double kApart = 1.15;
/// Over neighbours that all face one way (the mean of their normals is no shorter), a point is off
/// by less already, however near it is to the next: on a face, noise or roughness would show.
constexpr double kTangentOneWay = 0.95, kOffFaceSpacings = 0.1, kOffFaceDeviations = 6.0;
/// Two of them beside one another are off by so many deviations of the others.
constexpr double kPairDeviations = 10.0;
constexpr double kFitsQuadric = 1.15;  ///< residuals over the noise
/// A plane does where its residuals are no larger than the quadric's by more than this.
constexpr double kFlatEnough = 1.03;

using Row = Eigen::Matrix<double, 6, 1>;

/// Points about a place as heights over its tangent plane.
struct QuadricPatch {
  std::vector<Row> rows;        ///< 1, a, b, a^2, a b, b^2 in reaches
  std::vector<double> heights;  ///< m
  std::vector<double> weights;
};

struct Fit {
  double height = 0.0;     ///< at the place, m
  double deviation = 0.0;  ///< of the points about it, m
  double kurtosis = 0.0;   ///< of these deviations
};

template <int Terms>
using Coefficients = Eigen::Matrix<double, Terms, 1>;

/// Least squares with the first `Terms` of a row: 3, a plane; 6, a quadric.
template <int Terms>
Coefficients<Terms> coefficients_of(const QuadricPatch& patch) {
  Eigen::Matrix<double, Terms, Terms> matrix = Eigen::Matrix<double, Terms, Terms>::Zero();
  Coefficients<Terms> right = Coefficients<Terms>::Zero();
  for (std::size_t i = 0; i < patch.rows.size(); ++i) {
    const Coefficients<Terms> row = patch.rows[i].template head<Terms>();
    matrix += patch.weights[i] * row * row.transpose();
    right += patch.weights[i] * patch.heights[i] * row;
  }
  matrix.diagonal().array() += 1e-9 * matrix(0, 0);
  return matrix.ldlt().solve(right);
}

template <int Terms>
Fit fit_of(const QuadricPatch& patch) {
  const Coefficients<Terms> found = coefficients_of<Terms>(patch);
  double squares = 0.0, fourths = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < patch.rows.size(); ++i) {
    const double off = patch.heights[i] - found.dot(patch.rows[i].template head<Terms>());
    squares += patch.weights[i] * off * off;
    fourths += patch.weights[i] * off * off * off * off;
    weight += patch.weights[i];
  }
  const auto used = static_cast<double>(patch.rows.size());
  return {found[0], std::sqrt(squares / (weight * std::max(1.0, used - Terms) / used)),
          squares > 0.0 ? fourths * weight / (squares * squares) : 0.0};
}

/// True if the patch's position is this far off the plane of its points, and one of these is as
/// well. Two adjacent outliers make each other's neighbours look rough.
bool is_one_of_two_outliers(QuadricPatch patch, double least) {
  const auto off = [](const Coefficients<3>& plane, double height, const Row& row) {
    return height - plane.dot(row.head<3>());
  };
  const Coefficients<3> plane = coefficients_of<3>(patch);
  const double side = plane[0] < 0.0 ? 1.0 : -1.0;
  std::ptrdiff_t other = 0;
  double most = 0.0;
  for (std::size_t i = 0; i < patch.rows.size(); ++i) {
    const double beside = side * off(plane, patch.heights[i], patch.rows[i]);
    if (beside <= most) continue;
    most = beside;
    other = static_cast<std::ptrdiff_t>(i);
  }
  const Row row = patch.rows[static_cast<std::size_t>(other)];
  const double height = patch.heights[static_cast<std::size_t>(other)];
  patch.rows.erase(patch.rows.begin() + other);
  patch.heights.erase(patch.heights.begin() + other);
  patch.weights.erase(patch.weights.begin() + other);
  const Coefficients<3> rest = coefficients_of<3>(patch);
  least += kPairDeviations * fit_of<3>(patch).deviation;
  return -side * rest[0] > least && side * off(rest, height, row) > least;
}

/// The nearest points that face the way of `normal`.
QuadricPatch patch_at(const Vec3& position, const Vec3& normal,
                      std::span<const PointTree::Neighbour> near, std::span<const Vec3> points,
                      std::span<const Vec3> normals, bool is_oriented) {
  const double reach = near.back().distance;
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  QuadricPatch patch;
  for (const PointTree::Neighbour& n : near) {
    const double cosine = normals[n.point].dot(normal);
    if ((is_oriented ? cosine : std::abs(cosine)) < kSameSide) continue;
    const Vec3 from = points[n.point] - position;
    const double a = from.dot(u) / reach, b = from.dot(v) / reach;
    const double fraction = 0.95 * n.distance / reach;
    Row row;
    row << 1.0, a, b, a * a, a * b, b * b;
    patch.rows.push_back(row);
    patch.heights.push_back(from.dot(normal));
    patch.weights.push_back((1.0 - fraction * fraction) * (1.0 - fraction * fraction));
  }
  return patch;
}

}  // namespace

MovingLeastSquares::MovingLeastSquares(std::span<const Vec3> points, std::span<const Vec3> normals,
                                       bool is_oriented)
    : points_(points), normals_(normals), is_oriented_(is_oriented), tree_(points) {}

MovingLeastSquares::Scatter MovingLeastSquares::estimate_scatter(int neighbours) const {
  std::vector<double> deviations, kurtoses;
  const std::size_t step = std::max<std::size_t>(1, points_.size() / kNoiseSamples);
  for (std::size_t i = 0; i < points_.size(); i += step) {
    const auto near = tree_.nearest_neighbours(points_[i], neighbours);
    const QuadricPatch patch =
        patch_at(points_[i], normals_[i], near, points_, normals_, is_oriented_);
    if (patch.rows.size() < kMinQuadricPoints) continue;
    const Fit fit = fit_of<6>(patch);
    deviations.push_back(fit.deviation);
    kurtoses.push_back(fit.kurtosis);
  }
  const auto median = [](std::vector<double>& values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  return {median(deviations), median(kurtoses)};
}

std::vector<bool> MovingLeastSquares::find_off_surface_points(
    std::span<const double> spacings) const {
  std::vector<bool> off(points_.size(), false);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    std::vector<PointTree::Neighbour> near = tree_.nearest_neighbours(points_[i], kNoiseNeighbours);
    std::erase_if(near, [&](const PointTree::Neighbour& n) { return n.point == i; });
    double spacing = 0.0;
    Vec3 facing = Vec3::Zero();  // its own normal means nothing where it is an outlier
    for (const PointTree::Neighbour& n : near) {
      spacing += spacings[n.point] / static_cast<double>(near.size());
      facing += normals_[n.point] / static_cast<double>(near.size());
    }
    const bool apart = spacings[i] >= kApart * spacing, on_face = facing.norm() > kTangentOneWay;
    if (!(apart || on_face) || facing.norm() < kSameSide) continue;
    const QuadricPatch patch =
        patch_at(points_[i], facing.normalized(), near, points_, normals_, is_oriented_);
    if (patch.rows.size() < kMinQuadricPoints) continue;
    const Fit fit = fit_of<3>(patch);
    const auto is_beyond = [&](double gaps, double deviations) {
      return std::abs(fit.height) > gaps * spacing + deviations * fit.deviation;
    };
    off[i] = (apart && is_beyond(kOffSpacings, kOffDeviations)) ||
             (on_face && (is_beyond(kOffFaceSpacings, kOffFaceDeviations) ||
                          is_one_of_two_outliers(patch, kOffFaceSpacings * spacing)));
  }
  return off;
}

std::vector<MovingLeastSquares::PlaneDeviation> MovingLeastSquares::plane_deviations() const {
  std::vector<PlaneDeviation> result(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    std::vector<PointTree::Neighbour> near = tree_.nearest_neighbours(points_[i], kNoiseNeighbours);
    std::erase_if(near, [&](const PointTree::Neighbour& n) { return n.point == i; });
    const QuadricPatch patch =
        patch_at(points_[i], normals_[i], near, points_, normals_, is_oriented_);
    if (patch.rows.size() < kMinQuadricPoints) {  // nothing is known of a plane
      result[i].deviation = near.back().distance;
      continue;
    }
    const Fit fit = fit_of<3>(patch);
    result[i] = {-fit.height, fit.deviation};
  }
  return result;
}

Vec3 MovingLeastSquares::smoothed_point(std::size_t i, double noise) const {
  const auto near = tree_.nearest_neighbours(points_[i], kScales.back());
  std::optional<double> off;
  for (const int count : kScales) {
    if (static_cast<std::size_t>(count) > near.size()) break;
    const QuadricPatch patch =
        patch_at(points_[i], normals_[i], std::span(near).first(static_cast<std::size_t>(count)),
                 points_, normals_, is_oriented_);
    if (patch.rows.size() < kMinQuadricPoints) continue;
    const Fit plane = fit_of<3>(patch), quadric = fit_of<6>(patch);
    const Fit& fit = plane.deviation < kFlatEnough * quadric.deviation ? plane : quadric;
    if (off && fit.deviation > kFitsQuadric * noise) break;
    off = fit.height;
  }
  if (!off) return points_[i];
  return points_[i] + std::clamp(*off, -kFarthestMove * noise, kFarthestMove * noise) * normals_[i];
}

std::vector<Vec3> MovingLeastSquares::smoothed_points(double noise, unsigned threads) const {
  std::vector<Vec3> result(points_.size());
  ThreadPool(threads).run(points_.size(), kPointChunk,
                          [&](std::size_t i) { result[i] = smoothed_point(i, noise); });
  return result;
}

}  // namespace clast::reconstruct_detail
