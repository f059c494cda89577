#include "reconstruct/deposit/detail/prior_ellipsoid.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace clast::reconstruct_detail {

namespace {

/// Means and standard deviations of ln L/I and ln I/S of rocks.
constexpr std::array<double, 2> kRatioMean = {0.30, 0.37}, kRatioDeviation = {0.25, 0.30};
constexpr double kEllipsoidRelief =
    0.08;                              ///< deviation of rocks from ellipsoids, of the mean radius
constexpr double kNormalTilt = 0.5;    ///< deviation of normals, rad
constexpr double kIndependent = 30.0;  ///< number of independent observations of a surface
constexpr double kOuterWeight = 4.0;   ///< of a sample of the surroundings inside the ellipsoid
constexpr int kFitIterations = 40;
constexpr int kParameters = 9;

using EllipsoidParameters = Eigen::Matrix<double, kParameters, 1>;

Ellipsoid moved_ellipsoid(const Ellipsoid& e, const EllipsoidParameters& step, double size) {
  Ellipsoid next = e;
  next.centre += size * step.head<3>();
  const Vec3 turn = step.segment<3>(3);
  const double angle = turn.norm();
  if (angle > 0.0) next.axes = e.axes * Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  next.semi_axes = e.semi_axes.cwiseProduct(step.tail<3>().array().exp().matrix());
  return next;
}

/// First-order distance from the ellipsoid, and its unit normal there.
std::pair<double, Vec3> distance_and_normal(const Ellipsoid& e, const Vec3& point) {
  const Vec3 y = e.to_unit_sphere(point);
  const double f = std::max(y.norm(), 1e-9);
  const Vec3 gradient = e.axes * (y.cwiseQuotient(e.semi_axes) / f);
  const double slope = gradient.norm();
  return {(f - 1.0) / slope, gradient / slope};
}

Eigen::VectorXd ellipsoid_residuals(const Ellipsoid& e, std::span<const SurfaceSample> seen,
                                    std::span<const SurfaceSample> around, double size) {
  Eigen::VectorXd r(static_cast<Eigen::Index>(4 * seen.size() + around.size() + 2));
  const double weight = std::sqrt(kIndependent / static_cast<double>(seen.size()));
  Eigen::Index k = 0;
  for (const SurfaceSample& s : seen) {
    const auto [distance, normal] = distance_and_normal(e, s.position);
    r[k++] = weight * distance / (kEllipsoidRelief * size);
    r.segment<3>(k) = weight * (s.normal - normal) / kNormalTilt;
    k += 3;
  }
  const double outer = kOuterWeight * weight;
  for (const SurfaceSample& s : around) {
    r[k++] =
        outer * std::min(0.0, distance_and_normal(e, s.position).first) / (kEllipsoidRelief * size);
  }
  Vec3 sorted = e.semi_axes;
  std::sort(sorted.begin(), sorted.end());
  r[k++] = (std::log(sorted[2] / sorted[1]) - kRatioMean[0]) / kRatioDeviation[0];
  r[k++] = (std::log(sorted[1] / sorted[0]) - kRatioMean[1]) / kRatioDeviation[1];
  return r;
}

/// Sphere with the positions and normals of the samples, by linear least squares.
Ellipsoid starting_ellipsoid(std::span<const SurfaceSample> seen) {
  const auto count = static_cast<double>(seen.size());
  Vec3 centre = Vec3::Zero(), facing = Vec3::Zero();
  for (const SurfaceSample& s : seen) {
    centre += s.position / count;
    facing += s.normal / count;
  }
  double along = 0.0, normals = 0.0;
  Mat3 scatter = Mat3::Zero();
  for (const SurfaceSample& s : seen) {
    const Vec3 p = s.position - centre, n = s.normal - facing;
    along += p.dot(n);
    normals += n.squaredNorm();
    scatter += p * p.transpose() / count;
  }
  const double rms = std::sqrt(scatter.trace());
  const double radius = std::clamp(normals > 0.0 ? along / normals : rms, 0.6 * rms, 1.5 * rms);
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(scatter);
  Ellipsoid e;
  e.centre = centre - radius * facing;
  e.axes = solver.eigenvectors();
  if (e.axes.determinant() < 0.0) e.axes.col(0) = -e.axes.col(0);
  e.semi_axes = radius * Vec3(0.8, 1.0, 1.25);
  return e;
}

}  // namespace

Ellipsoid fit_prior_ellipsoid(std::span<const SurfaceSample> seen,
                              std::span<const SurfaceSample> around) {
  Ellipsoid best = starting_ellipsoid(seen);
  const double size = std::cbrt(best.semi_axes.prod());
  Eigen::VectorXd r = ellipsoid_residuals(best, seen, around, size);
  double damping = 1e-2;
  for (int i = 0; i < kFitIterations; ++i) {
    Eigen::Matrix<double, Eigen::Dynamic, kParameters> jacobian(r.size(), kParameters);
    constexpr double kStep = 1e-5;
    for (int p = 0; p < kParameters; ++p) {
      EllipsoidParameters step = EllipsoidParameters::Zero();
      step[p] = kStep;
      jacobian.col(p) =
          (ellipsoid_residuals(moved_ellipsoid(best, step, size), seen, around, size) - r) / kStep;
    }
    const Eigen::Matrix<double, kParameters, kParameters> normal = jacobian.transpose() * jacobian;
    const EllipsoidParameters gradient = jacobian.transpose() * r;
    bool improved = false;
    double gain = 0.0;
    for (int attempt = 0; attempt < 8 && !improved; ++attempt) {
      Eigen::Matrix<double, kParameters, kParameters> damped = normal;
      damped.diagonal() += damping * (normal.diagonal().array() + 1e-3).matrix();
      EllipsoidParameters step = -damped.ldlt().solve(gradient);
      const double length = step.norm();
      if (length > 0.5) step *= 0.5 / length;
      const Ellipsoid next = moved_ellipsoid(best, step, size);
      const Eigen::VectorXd trial = ellipsoid_residuals(next, seen, around, size);
      if (trial.squaredNorm() < r.squaredNorm()) {
        gain = r.squaredNorm() - trial.squaredNorm();
        best = next;
        r = trial;
        improved = true;
        damping = std::max(1e-6, 0.3 * damping);
      } else {
        damping *= 4.0;
      }
    }
    if (!improved || gain < 1e-6 * r.squaredNorm()) break;
  }
  return best;
}

}  // namespace clast::reconstruct_detail
