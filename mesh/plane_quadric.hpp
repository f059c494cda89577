#pragma once
/// Least-squares intersection point of planes.
#include <Eigen/Eigenvalues>

#include "core/types.hpp"

namespace clast {

/// Solver for the shortest step from a start point to the least-squares intersection of weighted
/// planes. A plane is given by its unit normal and its distance from the start point. Singular
/// values below `kCut` of the largest are ignored. Coplanar faces then give a step along their
/// normal, and faces along a ridge a step perpendicular to the ridge.
class PlaneQuadric {
 public:
  void add_plane(const Vec3& normal, double distance, double weight) {
    matrix_ += weight * normal * normal.transpose();
    side_ += weight * distance * normal;
  }

  Vec3 step_to_intersection() const {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(matrix_);
    const Vec3 values = solver.eigenvalues();
    Vec3 result = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
      if (values[i] <= 0.0 || values[i] < kCut * kCut * values[2]) continue;
      const Vec3 direction = solver.eigenvectors().col(i);
      result += direction.dot(side_) / values[i] * direction;
    }
    return result;
  }

 private:
  static constexpr double kCut = 0.15;
  Mat3 matrix_ = Mat3::Zero();
  Vec3 side_ = Vec3::Zero();
};

}  // namespace clast
