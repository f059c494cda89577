#include "reconstruct/registration/detail/joint_refinement.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace clast::reconstruct_detail {

namespace {

constexpr double kUsedNormal = 0.6;    ///< cosine
constexpr double kUsedDistance = 1.5;  ///< spacings
constexpr int kPoseParameters = 7;     ///< rotation, translation, logarithm of the scale
/// Eigenvalue of the normal equations, per point and with lengths relative to the diagonal, above
/// which a movement counts as constrained. Noise of 0.1 to 0.3 % of the size gives the rotations of
/// a ball 0.5e-5 to 2e-5; rocks with an overlap of 10 to 60 % have at least 4.5e-5, but for plates
/// that overlap on one face.
constexpr double kLeastInformation = 4e-5;

/// Normal equations of the heights of all matched points.
class HeightEquations {
 public:
  HeightEquations(std::span<const SampledSurface* const> surfaces,
                  const std::vector<Similarity>& first_from, const RefinementOptions& options)
      : surfaces_(surfaces), first_from_(first_from), options_(options) {
    const auto size = static_cast<Eigen::Index>(kPoseParameters * (surfaces.size() - 1));
    matrix_ = Eigen::MatrixXd::Zero(size, size);
    information_ = Eigen::MatrixXd::Zero(size, size);
    vector_ = Eigen::VectorXd::Zero(size);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      for (std::size_t j = 0; j < surfaces.size(); ++j) {
        if (i != j) add_heights(i, j);
      }
    }
  }

  Eigen::VectorXd solve() const {
    Eigen::MatrixXd damped = matrix_;
    for (Eigen::Index k = 0; k < damped.rows(); ++k) damped(k, k) += damping(k);
    return damped.ldlt().solve(-vector_);
  }

  Eigen::MatrixXd covariance() const {
    Eigen::MatrixXd damped = information_;
    const double per_weight = weight_ > 0.0 ? information_.trace() / matrix_.trace() : 0.0;
    for (Eigen::Index k = 0; k < damped.rows(); ++k) damped(k, k) += damping(k) * per_weight;
    Eigen::MatrixXd inverse =
        damped.ldlt().solve(Eigen::MatrixXd::Identity(damped.rows(), damped.cols()));
    for (Eigen::Index k = 0; k < damped.rows(); ++k) {
      if (!is_fixed(k)) continue;
      inverse.row(k).setZero();
      inverse.col(k).setZero();
    }
    return kCellsPerPlane * inverse;
  }

  double deviation() const { return weight_ > 0.0 ? std::sqrt(squares_ / weight_) : 0.0; }

  /// Movements that hardly change heights, as steps of the last surface.
  std::vector<PoseStep> free_movements() const {
    std::vector<PoseStep> movements;
    const double length = surfaces_[0]->diagonal;
    const auto unit_of = [&](Eigen::Index k) {
      return k % kPoseParameters >= 3 && k % kPoseParameters < 6 ? 1.0 : 1.0 / length;
    };
    if (!(weight_ > 0.0)) return {PoseStep::Unit(3), PoseStep::Unit(4), PoseStep::Unit(5)};
    Eigen::MatrixXd relative = matrix_ / weight_;
    for (Eigen::Index k = 0; k < relative.rows(); ++k) {
      relative.row(k) *= unit_of(k);
      relative.col(k) *= unit_of(k);
      if (is_fixed(k)) relative(k, k) = 1.0;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(relative);
    for (Eigen::Index e = 0; e < relative.rows(); ++e) {
      if (solver.eigenvalues()[e] > kLeastInformation) break;
      PoseStep step = solver.eigenvectors().col(e).tail<kPoseParameters>();
      for (Eigen::Index k = 0; k < kPoseParameters; ++k) step[k] *= unit_of(k);
      movements.push_back(step);
    }
    return movements;
  }

 private:
  bool is_fixed(Eigen::Index parameter) const {
    if (parameter % kPoseParameters != 6) return false;
    const auto surface = static_cast<std::size_t>(parameter / kPoseParameters) + 1;
    return options_.free_scale.empty() || !options_.free_scale[surface];
  }

  double damping(Eigen::Index parameter) const {
    if (is_fixed(parameter)) return 1e12 * std::max(matrix_.trace(), 1e-300);
    return 1e-9 * matrix_(parameter, parameter) + 1e-300;
  }

  /// Heights of the points of surface i above surface j.
  void add_heights(std::size_t i, std::size_t j) {
    const SampledSurface &from = *surfaces_[i], &to = *surfaces_[j];
    const Similarity to_first = first_from_[j].inverse();
    const Similarity to_from = to_first * first_from_[i];
    const double variance = std::pow(from.surface.point_noise * first_from_[i].scale, 2) +
                            std::pow(to.surface.point_noise * first_from_[j].scale, 2);
    for (const std::uint32_t k : from.points_at(options_.density)) {
      if (from.surface.is_border[k]) continue;
      const Vec3 position = to_from * from.surface.points[k];
      const std::uint32_t near = to.grid.nearest_point(position);
      const Vec3& facing = to.surface.normals[near];
      const Vec3 normal = to_from.pose.rotation * from.surface.normals[k];
      if (facing.dot(normal) < kUsedNormal) continue;
      const Vec3 offset = position - to.surface.points[near];
      const double rise = facing.dot(offset);
      const double beside = std::sqrt(std::max(0.0, offset.squaredNorm() - rise * rise));
      if (to.surface.is_border[near] || beside > kUsedDistance * to.surface.spacing) continue;
      const Vec3 along = (facing + normal).normalized();
      const double height = along.dot(offset) * first_from_[j].scale;
      const double relative = height / options_.tolerance;
      if (std::abs(relative) >= 1.0) continue;
      const double weight = std::pow(1.0 - relative * relative, 2);
      const Vec3 p = first_from_[i] * from.surface.points[k];
      const Vec3 q = first_from_[j] * to.surface.points[near];
      const Vec3 n = first_from_[j].pose.rotation * along;
      PoseStep of_from, of_to;
      of_from << p.cross(n), n, n.dot(p - first_from_[i].pose.translation);
      of_to << -q.cross(n), -n, -n.dot(q - first_from_[j].pose.translation);
      add(i, j, of_from, of_to, height, weight, 0.5 * weight / std::max(variance, 1e-300));
    }
  }

  void add(std::size_t i, std::size_t j, const PoseStep& of_i, const PoseStep& of_j, double height,
           double weight, double information) {
    const auto at = [](std::size_t surface) {
      return static_cast<Eigen::Index>(kPoseParameters * (surface - 1));
    };
    const auto block = [&](Eigen::MatrixXd& matrix, std::size_t a, std::size_t b) {
      return matrix.block<kPoseParameters, kPoseParameters>(at(a), at(b));
    };
    const auto add_to = [&](Eigen::MatrixXd& matrix, double factor) {
      if (i > 0) block(matrix, i, i) += factor * of_i * of_i.transpose();
      if (j > 0) block(matrix, j, j) += factor * of_j * of_j.transpose();
      if (i > 0 && j > 0) {
        block(matrix, i, j) += factor * of_i * of_j.transpose();
        block(matrix, j, i) += factor * of_j * of_i.transpose();
      }
    };
    add_to(matrix_, weight);
    add_to(information_, information);
    if (i > 0) vector_.segment<kPoseParameters>(at(i)) += weight * height * of_i;
    if (j > 0) vector_.segment<kPoseParameters>(at(j)) += weight * height * of_j;
    weight_ += weight;
    squares_ += weight * height * height;
  }

  std::span<const SampledSurface* const> surfaces_;
  const std::vector<Similarity>& first_from_;
  const RefinementOptions& options_;
  Eigen::MatrixXd matrix_, information_;
  Eigen::VectorXd vector_;
  double weight_ = 0.0, squares_ = 0.0;
};

}  // namespace

Similarity moved_by_step(const Similarity& before, const PoseStep& step) {
  const Vec3 turn = step.head<3>();
  const double angle = turn.norm();
  const Quat rotation =
      angle > 0.0 ? Quat(Eigen::AngleAxisd(angle, turn / angle)) : Quat(Quat::Identity());
  Similarity after;
  after.scale = before.scale * std::exp(step[6]);
  after.pose.rotation = (rotation * before.pose.rotation).normalized();
  after.pose.translation = rotation * before.pose.translation + step.segment<3>(3);
  return after;
}

Refinement refine_jointly(std::span<const SampledSurface* const> surfaces,
                          std::vector<Similarity> first_from, const RefinementOptions& options) {
  Refinement refined;
  constexpr double kSettled = 1e-7;  // relative to the diagonal
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const HeightEquations equations(surfaces, first_from, options);
    const Eigen::VectorXd step = equations.solve();
    if (!step.allFinite()) break;
    double largest = 0.0;
    for (std::size_t s = 1; s < surfaces.size(); ++s) {
      const PoseStep own = step.segment<kPoseParameters>(static_cast<Eigen::Index>(7 * (s - 1)));
      first_from[s] = moved_by_step(first_from[s], own);
      const double length = surfaces[s]->diagonal;
      largest = std::max({largest, own.head<3>().norm(), own.segment<3>(3).norm() / length});
    }
    if (largest < kSettled) break;
  }
  const HeightEquations equations(surfaces, first_from, options);
  refined.covariance = equations.covariance();
  refined.deviation = equations.deviation();
  refined.free_movements = equations.free_movements();
  refined.first_from = std::move(first_from);
  return refined;
}

}  // namespace clast::reconstruct_detail
