#include "reconstruct/registration/passes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/angle.hpp"
#include "core/number_text.hpp"
#include "core/random.hpp"
#include "core/statistics/statistics.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/cloud/cloud_normals.hpp"
#include "reconstruct/registration/detail/doubled_places.hpp"

namespace clast {

namespace {

using namespace reconstruct_detail;

constexpr std::size_t kUsedPoints = 24000;  ///< of a dense scan
constexpr std::size_t kLeastPoints = 400;
constexpr int kNormalPoints = 20;
constexpr std::uint64_t kPassSeed = 57;
constexpr int kTriples = 3000;                 ///< of places from which movements are computed
constexpr std::size_t kRefinedMovements = 30;  ///< movements that are refined
constexpr int kRefinements = 8;
constexpr double kLargestShift = 0.06;  ///< relative to the diagonal
/// Tolerance of the difference between a distance and that of a movement: in standard errors and
/// relative to the distance. The first fraction is for translations alone.
constexpr double kErrors = 3.0, kFirstFraction = 0.4, kFinalFraction = 0.2;
/// Least number and fraction of places with two surfaces, and least fraction of them that one
/// movement explains.
constexpr std::size_t kLeastDoubled = 10;
constexpr double kLeastDoubledFraction = 0.02, kLeastExplained = 0.3;
/// Least fraction of the votes for either part that agree with those on the same surface nearby.
/// It was at most 0.85 for scans of one pass, and 0.93 or more for others.
constexpr double kLeastAgreement = 0.9;
constexpr int kSpreadNeighbours = 10;
/// Height between neighbours, in standard deviations, beyond which they are hardly of one surface,
/// and weight of such neighbours.
constexpr double kConnectedHeight = 2.4, kLeastConnection = 1e-3;
constexpr double kSolverTolerance = 1e-6;
constexpr int kSolverSteps = 5000;

/// Rotation about the middle of the points and translation, both small.
struct Movement {
  Vec3 rotation = Vec3::Zero(), shift = Vec3::Zero();
  double score = 0.0;

  double along(const Vec3& from_middle, const Vec3& normal) const {
    return normal.dot(shift + rotation.cross(from_middle));
  }
};

/// Returns the indices of the points in use: all, or a random subset, in ascending order.
std::vector<std::uint32_t> choose_random_subset(std::size_t count) {
  std::vector<std::uint32_t> chosen(count);
  std::iota(chosen.begin(), chosen.end(), 0u);
  if (count <= kUsedPoints) return chosen;
  Random random(kPassSeed);
  for (std::size_t i = 0; i < kUsedPoints; ++i) {
    std::swap(chosen[i], chosen[i + random.uniform_index(count - i)]);
  }
  chosen.resize(kUsedPoints);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

/// Search for the movement between two parts from the distances of doubled surfaces.
class MovementSearch {
 public:
  MovementSearch(std::vector<const SurfacePlace*> doubled, const Vec3& middle, double diagonal)
      : doubled_(std::move(doubled)), middle_(middle), diagonal_(diagonal) {}

  Movement run() const {
    Random random(kPassSeed);
    std::vector<Movement> movements;
    for (int i = 0; i < kTriples; ++i) add_translations(random, movements);
    std::stable_sort(movements.begin(), movements.end(),
                     [](const Movement& a, const Movement& b) { return a.score > b.score; });
    if (movements.size() > kRefinedMovements) movements.resize(kRefinedMovements);
    Movement best;
    for (Movement& one : movements) {
      refine(one);
      if (one.score > best.score) best = one;
    }
    return best;
  }

  /// True if the movement explains the distance at a place.
  bool explains(const Movement& movement, const SurfacePlace& place, double fraction) const {
    return std::abs(misfit(movement, place)) < tolerance(place, fraction);
  }

 private:
  double signed_distance(const Movement& movement, const SurfacePlace& place) const {
    const double along = movement.along(place.position - middle_, place.normal);
    return std::copysign(place.distance, along);
  }
  double misfit(const Movement& movement, const SurfacePlace& place) const {
    return movement.along(place.position - middle_, place.normal) -
           signed_distance(movement, place);
  }
  static double tolerance(const SurfacePlace& place, double fraction) {
    return kErrors * place.distance_error + fraction * place.distance;
  }

  double score(const Movement& movement, double fraction) const {
    double sum = 0.0;
    for (const SurfacePlace* place : doubled_) {
      const double relative = misfit(movement, *place) / tolerance(*place, fraction);
      sum += std::max(0.0, 1.0 - relative * relative);
    }
    return sum / static_cast<double>(doubled_.size());
  }

  /// Translations that explain the distances at three places, with all signs.
  void add_translations(Random& random, std::vector<Movement>& movements) const {
    Mat3 normals;
    Vec3 distances;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const SurfacePlace& place = *doubled_[random.uniform_index(doubled_.size())];
      normals.row(k) = place.normal.transpose();
      distances[k] = place.distance;
    }
    constexpr double kLeastVolume = 0.1;
    if (std::abs(normals.determinant()) < kLeastVolume) return;
    const Mat3 inverse = normals.inverse();
    for (int signs = 0; signs < 4; ++signs) {
      Movement one;
      one.shift = inverse *
                  distances.cwiseProduct(Vec3(1.0, signs & 1 ? -1.0 : 1.0, signs & 2 ? -1.0 : 1.0));
      if (one.shift.norm() > kLargestShift * diagonal_) continue;
      one.score = score(one, kFirstFraction);
      movements.push_back(one);
    }
  }

  void refine(Movement& movement) const {
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    for (int round = 0; round < kRefinements; ++round) {
      const double fraction = 2 * round < kRefinements ? kFirstFraction : kFinalFraction;
      Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
      Vector6 vector = Vector6::Zero();
      for (const SurfacePlace* place : doubled_) {
        const double width = tolerance(*place, fraction);
        const double relative = misfit(movement, *place) / width;
        if (std::abs(relative) >= 1.0) continue;
        const double weight = std::pow(1.0 - relative * relative, 2) / (width * width);
        Vector6 row;
        row << (place->position - middle_).cross(place->normal), place->normal;
        matrix += weight * row * row.transpose();
        vector += weight * signed_distance(movement, *place) * row;
      }
      // Rotations that the places do not determine stay small.
      constexpr double kDamping = 3e-3;
      const double trace = matrix.bottomRightCorner<3, 3>().trace();
      matrix.topLeftCorner<3, 3>() += kDamping * trace * diagonal_ * diagonal_ * Mat3::Identity();
      matrix.bottomRightCorner<3, 3>() += 1e-9 * trace * Mat3::Identity();
      const Vector6 solved = matrix.ldlt().solve(vector);
      if (!solved.allFinite()) break;
      movement.rotation = solved.head<3>();
      movement.shift = solved.tail<3>();
    }
    movement.score = score(movement, kFinalFraction);
  }

  std::vector<const SurfacePlace*> doubled_;
  Vec3 middle_;
  double diagonal_;
};

/// Weight of neighbours as points of one part, by the height of one above the other.
double connection(double height, double noise) {
  return kLeastConnection + std::exp(-std::pow(height / (kConnectedHeight * noise), 2));
}

/// Points in use, with outward normals.
struct UsedPoints {
  std::vector<Vec3> points, normals;
  double noise = 0.0;  ///< standard deviation of the points, m
};

/// Spreads votes for either part over neighbours: minimises weighted squared differences. Points
/// with positive values belong to the moved part.
std::vector<double> spread_votes(const UsedPoints& used, const std::vector<double>& votes) {
  const auto count = static_cast<Eigen::Index>(used.points.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  const PointTree tree(used.points);
  for (std::uint32_t i = 0; i < used.points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (const auto& near : tree.nearest_neighbours(used.points[i], kSpreadNeighbours + 1)) {
      const std::uint32_t k = near.point;
      if (k == i) continue;
      const double height =
          0.5 * (used.normals[i] + used.normals[k]).dot(used.points[k] - used.points[i]);
      const double weight = connection(height, used.noise) *
                            std::max(kLeastConnection, used.normals[i].dot(used.normals[k]));
      const auto column = static_cast<Eigen::Index>(k);
      entries.emplace_back(row, row, weight);
      entries.emplace_back(column, column, weight);
      entries.emplace_back(row, column, -weight);
      entries.emplace_back(column, row, -weight);
    }
    constexpr double kUnvoted = 1e-9;
    entries.emplace_back(row, row, std::abs(votes[i]) + kUnvoted);
    right[row] += votes[i];
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(kSolverTolerance);
  solver.setMaxIterations(kSolverSteps);
  const Eigen::VectorXd solved = solver.compute(matrix).solve(right);
  return {solved.data(), solved.data() + count};
}

/// Assigns each point to a part by the values of the nearest points in use.
std::vector<bool> assign_parts(std::span<const Vec3> points, const UsedPoints& used,
                               const std::vector<double>& values) {
  const PointTree tree(used.points);
  std::vector<bool> is_moved;
  for (const Vec3& p : points) {
    double sum = 0.0;
    for (const auto& near : tree.nearest_neighbours(p, kSpreadNeighbours)) {
      const std::uint32_t k = near.point;
      const double height = used.normals[k].dot(p - used.points[k]);
      sum += connection(height, used.noise) * values[k];
    }
    is_moved.push_back(sum > 0.0);
  }
  return is_moved;
}

}  // namespace

std::optional<PassMisfit> find_pass_misfit(std::span<const Vec3> points) {
  if (points.size() < kLeastPoints) return {};
  UsedPoints used;
  Bounds box;
  for (const std::uint32_t i : choose_random_subset(points.size())) {
    used.points.push_back(points[i]);
    box.include(points[i]);
  }
  used.normals = estimate_normals(used.points, kNormalPoints);
  orient_outward(used.normals, used.points);
  const std::vector<SurfacePlace> places = examine_places(used.points, used.normals);
  std::vector<const SurfacePlace*> doubled;
  std::vector<double> scatters;
  for (const SurfacePlace& place : places) {
    scatters.push_back(place.scatter);
    if (place.distance > 0.0) doubled.push_back(&place);
  }
  const auto least =
      static_cast<std::size_t>(kLeastDoubledFraction * static_cast<double>(places.size()));
  if (doubled.size() < std::max(kLeastDoubled, least)) return {};
  const Vec3 middle = 0.5 * (box.low + box.high);
  const MovementSearch search(doubled, middle, box.diagonal());
  const Movement movement = search.run();
  used.noise = upper_median(scatters);
  PassMisfit misfit;
  misfit.fraction = static_cast<double>(doubled.size()) / static_cast<double>(places.size());
  std::vector<double> votes(used.points.size(), 0.0);
  double squares = 0.0;
  std::size_t explained = 0;
  for (const SurfacePlace* place : doubled) {
    if (!search.explains(movement, *place, kFinalFraction)) continue;
    ++explained;
    squares += place->distance * place->distance;
    const double sign = movement.along(place->position - middle, place->normal) > 0.0 ? 1.0 : -1.0;
    for (const std::uint32_t i : place->outer) votes[i] += sign;
    for (const std::uint32_t i : place->inner) votes[i] -= sign;
  }
  misfit.explained = static_cast<double>(explained) / static_cast<double>(doubled.size());
  if (misfit.explained < kLeastExplained || explained < kLeastDoubled) return {};
  misfit.distance = std::sqrt(squares / static_cast<double>(explained));
  const std::vector<double> spread = spread_votes(used, votes);
  double agreeing = 0.0, all = 0.0;
  for (std::size_t i = 0; i < votes.size(); ++i) {
    all += std::abs(votes[i]);
    if (votes[i] * spread[i] > 0.0) agreeing += std::abs(votes[i]);
  }
  if (agreeing < kLeastAgreement * all) return {};
  misfit.is_moved = assign_parts(points, used, spread);
  const auto moved =
      static_cast<std::size_t>(std::count(misfit.is_moved.begin(), misfit.is_moved.end(), true));
  const bool smaller = 2 * moved <= points.size();
  if (!smaller) misfit.is_moved.flip();
  Bounds part;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (misfit.is_moved[i]) part.include(points[i]);
  }
  // The outer of two surfaces belongs to the part that the movement takes outward.
  const double back = smaller ? -1.0 : 1.0;
  misfit.rotation = back * movement.rotation;
  misfit.shift =
      back * (movement.shift + movement.rotation.cross(0.5 * (part.low + part.high) - middle));
  return misfit;
}

std::string describe_misfit(const PassMisfit& misfit, double unit) {
  const Vec3 s = unit * misfit.shift;
  return "on " + format_significant(100.0 * misfit.fraction, 2) +
         " % of the block the surface appears twice, " +
         format_significant(unit * misfit.distance, 2) +
         " m apart; a part of the scan fits the rest if it is moved by (" +
         format_significant(s.x(), 2) + ", " + format_significant(s.y(), 2) + ", " +
         format_significant(s.z(), 2) + ") m and rotated by " +
         format_significant(misfit.rotation.norm() * kDegreesPerRadian, 2) + " degrees";
}

std::vector<std::uint32_t> number_passes(std::span<const PointRecording> recordings) {
  constexpr double kPause = 20.0;  // s
  std::map<std::uint16_t, std::uint32_t> sources;
  for (const PointRecording& one : recordings) sources.emplace(one.source, 0);
  std::vector<std::uint32_t> passes;
  if (sources.size() > 1) {
    std::uint32_t next = 0;
    for (auto& [source, pass] : sources) pass = next++;
    for (const PointRecording& one : recordings) passes.push_back(sources.at(one.source));
    return passes;
  }
  std::vector<double> times;
  for (const PointRecording& one : recordings) {
    if (!std::isfinite(one.time)) return {};
    times.push_back(one.time);
  }
  std::sort(times.begin(), times.end());
  std::vector<double> starts;  // of the passes after the first
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] - times[i - 1] >= kPause) starts.push_back(times[i]);
  }
  if (starts.empty()) return {};
  for (const PointRecording& one : recordings) {
    const auto after = std::upper_bound(starts.begin(), starts.end(), one.time);
    passes.push_back(static_cast<std::uint32_t>(after - starts.begin()));
  }
  return passes;
}

std::vector<std::uint32_t> divide_into_passes(std::span<const Vec3> points, std::size_t most) {
  std::vector<std::uint32_t> pass(points.size(), 0);
  std::uint32_t passes = 1;
  for (std::uint32_t current = 0; current < passes && passes < most;) {
    std::vector<std::uint32_t> own;
    std::vector<Vec3> part;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (pass[i] != current) continue;
      own.push_back(i);
      part.push_back(points[i]);
    }
    const std::optional<PassMisfit> misfit = find_pass_misfit(part);
    if (!misfit) {
      ++current;
      continue;
    }
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (misfit->is_moved[k]) pass[own[k]] = passes;
    }
    ++passes;
  }
  return pass;
}

}  // namespace clast
