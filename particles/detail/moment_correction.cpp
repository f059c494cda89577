#include "particles/detail/moment_correction.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "particles/detail/sphere_patches.hpp"

namespace clast::particles_detail {

namespace {

constexpr int kDilationSteps = 6;
constexpr double kVolumeTolerance = 1e-5;

Mat3 symmetric_power(const Mat3& matrix, double exponent) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(matrix);
  const Vec3 powers = solver.eigenvalues().array().max(1e-300).pow(exponent);
  return solver.eigenvectors() * powers.asDiagonal() * solver.eigenvectors().transpose();
}

/// Second moments about the centre over the volume to the power 5/3, which does not depend on size.
Mat3 central_second_moments(const massprops_detail::SolidMoments& moments) {
  const Vec3 centre = moments.first / moments.volume;
  const Mat3 second = moments.second / moments.volume - centre * centre.transpose();
  return second / std::pow(moments.volume, 2.0 / 3.0);
}

/// Difference of the second moments of shapes of any size, relative.
double second_moment_error(const massprops_detail::SolidMoments& moments, const Mat3& wanted) {
  return (central_second_moments(moments) - wanted).norm() / wanted.norm();
}

/// Moves the centre of mass to that of the body and changes all radii to its volume.
void correct_centre_and_volume(std::vector<Ball>& balls, BallUnionIntegrals now,
                               const massprops_detail::SolidMoments& body, double smallest_radius) {
  const Vec3 shift = body.first / body.volume - now.moments.first / now.moments.volume;
  for (Ball& ball : balls) ball.centre += shift;
  for (int step = 0; step < kDilationSteps; ++step) {
    const double missing = body.volume - now.moments.volume;
    if (std::abs(missing) <= kVolumeTolerance * body.volume) break;
    double area = 0.0;
    for (const double part : now.areas) area += part;
    for (Ball& ball : balls) {
      ball.radius = std::max(ball.radius + missing / area, smallest_radius);
    }
    now = integrate_ball_union(balls, Vec3::Zero());
  }
}

}  // namespace

void correct_moments(std::vector<Ball>& balls, const massprops_detail::SolidMoments& body,
                     double smallest_radius) {
  const BallUnionIntegrals now = integrate_ball_union(balls, Vec3::Zero());
  const Vec3 centre = now.moments.first / now.moments.volume;
  // The symmetric map M with M A M = B.
  const Mat3 a = central_second_moments(now.moments), b = central_second_moments(body);
  const Mat3 root = symmetric_power(a, 0.5), inverse_root = symmetric_power(a, -0.5);
  const Mat3 map = inverse_root * symmetric_power(root * b * root, 0.5) * inverse_root;
  std::vector<Ball> mapped = balls;
  for (Ball& ball : mapped) ball.centre = centre + map * (ball.centre - centre);
  BallUnionIntegrals after = integrate_ball_union(mapped, Vec3::Zero());
  // Few balls can't take all second moments, and repeated maps would drive them apart.
  if (second_moment_error(after.moments, b) < second_moment_error(now.moments, b)) {
    balls = std::move(mapped);
    correct_centre_and_volume(balls, std::move(after), body, smallest_radius);
  } else {
    correct_centre_and_volume(balls, now, body, smallest_radius);
  }
}

}  // namespace clast::particles_detail
