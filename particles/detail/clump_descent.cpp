#include "particles/detail/clump_descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "particles/detail/moment_correction.hpp"
#include "particles/detail/sphere_patches.hpp"

namespace clast::particles_detail {

namespace {

constexpr double kMeanDecay = 0.9, kSquareDecay = 0.99, kTiny = 1e-12;  // of Adam
constexpr int kNearPeriod = 10, kCorrectionPeriod = 20, kDensePeriod = 60;
/// Dense samples with at least this part of the largest distance take part in the descent.
constexpr double kDensePart = 0.7;
/// Balls this much farther from a sample than the nearest one, relative to L, are remembered.
constexpr double kNearMargin = 0.06;
constexpr double kSpherePoints = 5000.0;  ///< random points on all spheres, hidden ones included
constexpr double kMinSpherePoints = 16.0;
constexpr double kCircleSpacing = 0.03;  ///< relative to L
constexpr double kFlat = 0.02;  ///< squared sine or determinant of normals that are nearly parallel
constexpr double kHiddenArea = 1e-6;  ///< relative to L^2
constexpr double kPlaceSeparation =
    0.05;  ///< least distance of balls that are added, relative to L

double with_sign(double value, double sign) { return sign < 0.0 ? -value : value; }

}  // namespace

double DescentLoss::slope(double distance) const {
  double power = distance / scale;
  if (hinge) return 2.0 * std::max(0.0, power - 1.0);
  for (int i = 0; i < doublings; ++i) power *= power;
  return power;
}

ClumpDescent::ClumpDescent(ClumpProblem& problem, std::vector<Ball> balls, double smallest_radius,
                           std::uint64_t seed)
    : problem_(&problem),
      balls_(std::move(balls)),
      smallest_radius_(smallest_radius),
      random_(seed),
      parameters_(balls_.size()) {
  for (Ball& ball : balls_) ball.radius = std::max(ball.radius, smallest_radius_);
}

double ClumpDescent::worst_distance() const {
  double worst = 0.0;
  for (const Distance& distance : distances_) worst = std::max(worst, distance.value);
  return worst;
}

void ClumpDescent::update_dense_samples() {
  std::vector<double> gaps;
  double largest = 0.0;
  for (const Vec3& point : problem_->dense) {
    double least = std::numeric_limits<double>::infinity();
    for (const Ball& ball : balls_) {
      least = std::min(least, (point - ball.centre).norm() - ball.radius);
    }
    gaps.push_back(std::abs(least));
    largest = std::max(largest, gaps.back());
  }
  dense_.clear();
  for (std::size_t s = 0; s < gaps.size(); ++s) {
    if (gaps[s] > kDensePart * largest) dense_.push_back(problem_->dense[s]);
  }
}

void ClumpDescent::update_near_balls() {
  near_.clear();
  std::vector<double> gaps(balls_.size());
  for (const std::vector<Vec3>* points : {&problem_->surface, &dense_, &problem_->interior}) {
    for (const Vec3& point : *points) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t b = 0; b < balls_.size(); ++b) {
        gaps[b] = (point - balls_[b].centre).norm() - balls_[b].radius;
        least = std::min(least, gaps[b]);
      }
      near_.emplace_back();
      for (std::uint32_t b = 0; b < balls_.size(); ++b) {
        if (gaps[b] <= least + kNearMargin) near_.back().push_back(b);
      }
    }
  }
}

void ClumpDescent::add(std::uint32_t ball, double weight, const Vec3& normal) {
  parameters_[ball].slope.centre += weight * normal;
  parameters_[ball].slope.radius += weight;
}

void ClumpDescent::add_cover_terms(const DescentLoss& loss) {
  std::size_t sample = 0;
  for (const std::vector<Vec3>* points : {&problem_->surface, &dense_, &problem_->interior}) {
    for (const Vec3& point : *points) {
      double least = std::numeric_limits<double>::infinity();
      std::uint32_t nearest = 0;
      for (const std::uint32_t b : near_[sample]) {
        const double gap = (point - balls_[b].centre).norm() - balls_[b].radius;
        if (gap < least) least = gap, nearest = b;
      }
      ++sample;
      if (least < 0.0 && points == &problem_->interior) continue;
      const double distance = std::abs(least);
      if (distance > distances_[nearest].value) distances_[nearest] = {distance, point};
      add(nearest, -with_sign(loss.slope(distance), least),
          (point - balls_[nearest].centre).normalized());
    }
  }
}

Vec3 ClumpDescent::point_slope(const DescentLoss& loss, const Vec3& point) {
  const DistanceField::Value found = problem_->field.at(point);
  const double distance = std::abs(found.distance);
  if (distance > distances_.back().value) distances_.back() = {distance, point};
  return with_sign(loss.slope(distance), found.distance) * found.gradient;
}

void ClumpDescent::add_sphere_terms(const DescentLoss& loss, const BallNeighbours& neighbours) {
  double squares = 0.0;
  for (const Ball& ball : balls_) squares += ball.radius * ball.radius;
  const Mat3 turn = random_.rotation().toRotationMatrix();
  for (std::uint32_t b = 0; b < balls_.size(); ++b) {
    const Ball& ball = balls_[b];
    const auto count = static_cast<std::size_t>(
        std::max(kMinSpherePoints, kSpherePoints * ball.radius * ball.radius / squares));
    distances_.emplace_back();
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 normal = turn * spiral_direction(k, count);
      const Vec3 point = ball.centre + ball.radius * normal;
      if (!neighbours.is_exposed(balls_, b, point)) continue;
      const Vec3 slope = point_slope(loss, point);
      parameters_[b].slope.centre += slope;
      parameters_[b].slope.radius += slope.dot(normal);
    }
  }
}

void ClumpDescent::add_circle_terms(const DescentLoss& loss, const BallNeighbours& neighbours) {
  const double start = random_.uniform(0.0, 2.0 * kPi);
  for (const SphereCircle& circle : find_sphere_circles(balls_, neighbours)) {
    const auto [i, j] = circle.balls;
    const int count = std::max(4, static_cast<int>(2.0 * kPi * circle.radius / kCircleSpacing));
    distances_.emplace_back();
    circle.visit_points(start, count, [&, i = i, j = j](const Vec3& point) {
      if (!neighbours.is_exposed(balls_, i, point, j)) return;
      const Vec3 slope = point_slope(loss, point);
      const Vec3 ni = (point - balls_[i].centre) / balls_[i].radius;
      const Vec3 nj = (point - balls_[j].centre) / balls_[j].radius;
      const double cosine = ni.dot(nj), squared_sine = 1.0 - cosine * cosine;
      if (squared_sine < kFlat) return;
      const double si = ni.dot(slope), sj = nj.dot(slope);
      add(i, (si - cosine * sj) / squared_sine, ni);
      add(j, (sj - cosine * si) / squared_sine, nj);
    });
  }
}

void ClumpDescent::add_corner_terms(const DescentLoss& loss, const BallNeighbours& neighbours) {
  for (const SphereCorner& corner : find_sphere_corners(balls_, neighbours)) {
    distances_.emplace_back();
    const Vec3 slope = point_slope(loss, corner.point);
    Mat3 normals;
    for (int k = 0; k < 3; ++k) {
      const Ball& ball = balls_[corner.balls[static_cast<std::size_t>(k)]];
      normals.row(k) = (corner.point - ball.centre).transpose() / ball.radius;
    }
    if (std::abs(normals.determinant()) < kFlat) continue;
    const Vec3 weights = normals.transpose().inverse() * slope;
    for (int k = 0; k < 3; ++k) {
      add(corner.balls[static_cast<std::size_t>(k)], weights[k], normals.row(k).transpose());
    }
  }
}

void ClumpDescent::step(const DescentLoss& loss, double rate) {
  for (Parameters& one : parameters_) one.slope = {};
  distances_.assign(balls_.size(), Distance());
  const BallNeighbours neighbours(balls_);
  add_cover_terms(loss);
  add_sphere_terms(loss, neighbours);
  add_circle_terms(loss, neighbours);
  add_corner_terms(loss, neighbours);
  ++steps_;
  const double mean_scale = 1.0 / (1.0 - std::pow(kMeanDecay, steps_));
  const double square_scale = 1.0 / (1.0 - std::pow(kSquareDecay, steps_));
  const auto move = [&](double slope, double& mean, double& square) {
    mean = kMeanDecay * mean + (1.0 - kMeanDecay) * slope;
    square = kSquareDecay * square + (1.0 - kSquareDecay) * slope * slope;
    return -rate * mean * mean_scale / (std::sqrt(square * square_scale) + kTiny);
  };
  for (std::size_t b = 0; b < balls_.size(); ++b) {
    auto& [slope, mean, square] = parameters_[b];
    for (int axis = 0; axis < 3; ++axis) {
      balls_[b].centre[axis] += move(slope.centre[axis], mean.centre[axis], square.centre[axis]);
    }
    balls_[b].radius += move(slope.radius, mean.radius, square.radius);
    balls_[b].radius = std::max(balls_[b].radius, smallest_radius_);
  }
}

void ClumpDescent::run(int steps, const DescentLoss& loss, double first_rate, double last_rate) {
  for (int i = 0; i < steps; ++i) {
    if (i % kDensePeriod == 0) update_dense_samples();
    if (i % kNearPeriod == 0 || i % kDensePeriod == 0) update_near_balls();
    step(loss, first_rate * std::pow(last_rate / first_rate, static_cast<double>(i) / steps));
    if (i % kCorrectionPeriod == kCorrectionPeriod - 1) {
      correct_moments(balls_, problem_->moments, smallest_radius_);
    }
  }
}

void ClumpDescent::erase(std::size_t ball) {
  balls_.erase(balls_.begin() + static_cast<std::ptrdiff_t>(ball));
  parameters_.erase(parameters_.begin() + static_cast<std::ptrdiff_t>(ball));
}

void ClumpDescent::move_hidden_balls() {
  const std::vector<double> areas = integrate_ball_union(balls_, Vec3::Zero()).areas;
  std::size_t hidden = 0;
  for (std::size_t b = areas.size(); b-- > 0;) {
    if (areas[b] >= kHiddenArea) continue;
    erase(b);
    ++hidden;
  }
  add_balls(hidden);
}

void ClumpDescent::remove_least_balls(std::size_t count) {
  for (std::size_t i = 0; i < count && balls_.size() > 1; ++i) {
    const std::vector<double> areas = integrate_ball_union(balls_, Vec3::Zero()).areas;
    erase(static_cast<std::size_t>(std::min_element(areas.begin(), areas.end()) - areas.begin()));
  }
}

void ClumpDescent::add_balls(std::size_t count) {
  std::stable_sort(distances_.begin(), distances_.end(),
                   [](const Distance& a, const Distance& b) { return a.value > b.value; });
  std::vector<Vec3> taken;
  for (double separation = kPlaceSeparation; taken.size() < count; separation *= 0.5) {
    for (const Distance& distance : distances_) {
      if (taken.size() == count) break;
      const bool near = std::any_of(taken.begin(), taken.end(), [&](const Vec3& place) {
        return (place - distance.place).norm() <= separation;
      });
      if (!near) taken.push_back(distance.place);
    }
    if (separation < kTiny) break;
  }
  for (const Vec3& place : taken) {
    const auto nearest = std::min_element(problem_->balls.begin(), problem_->balls.end(),
                                          [&](const TangentBall& a, const TangentBall& b) {
                                            return (a.contact - place).squaredNorm() <
                                                   (b.contact - place).squaredNorm();
                                          });
    balls_.push_back({nearest->ball.centre, std::max(nearest->ball.radius, smallest_radius_)});
    parameters_.emplace_back();
  }
}

}  // namespace clast::particles_detail
