#include "massprops/principal_frame.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/axis_sign.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

// Moments closer than this share of the largest leave the axes between them undetermined.
constexpr double kNearlyEqual = 1e-6;
// Cosine from which on a direction counts as along an axis of the source.
constexpr double kAlong = 0.9;
// Rounding of an exact tensor; sampled tensors add their own stated error.
constexpr double kRounding = 1e-9;

void check_moments(const Vec3& moments, double relative_error) {
  const std::string values = format_significant(moments[0], 6) + ", " +
                             format_significant(moments[1], 6) + ", " +
                             format_significant(moments[2], 6) + " kg m2";
  if (!moments.allFinite() || !(moments[0] > 0.0)) {
    throw GeometryError(
        "principal moments " + values +
        ": not all positive, which is impossible for a solid; check that the mesh is closed, "
        "faces outward and doesn't pass through itself");
  }
  const double slack = (kRounding + 2.0 * relative_error) * moments[2];
  if (moments[0] + moments[1] + slack < moments[2]) {
    throw GeometryError(
        "principal moments " + values +
        ": the largest exceeds the sum of the others, which is impossible for a solid; check "
        "that the mesh is closed, faces outward and doesn't pass through itself");
  }
}

/// Across `axis`: the source's x axis as far as it is perpendicular to it, or y where x is not.
Vec3 convention_across(const Vec3& axis) {
  const Vec3 source = std::abs(axis.x()) < kAlong ? Vec3::UnitX() : Vec3::UnitY();
  return (source - source.dot(axis) * axis).normalized();
}

/// Replaces the axes that nearly equal moments leave open, so that rounding does not choose them.
Mat3 settled(Mat3 axes, bool first_two, bool last_two) {
  if (first_two && last_two) return Mat3::Identity();
  if (first_two) {
    axes.col(0) = convention_across(axes.col(2));
    axes.col(1) = axes.col(2).cross(axes.col(0));
  } else if (last_two) {
    axes.col(1) = convention_across(axes.col(0));
  }
  return axes;
}

}  // namespace

PrincipalFrame principal_frame(const MassProperties& properties) {
  if (!properties.inertia.allFinite()) {
    throw GeometryError("inertia tensor holds values that are not finite; check the mesh");
  }
  const Mat3 symmetric = 0.5 * (properties.inertia + properties.inertia.transpose());
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(symmetric);
  PrincipalFrame frame;
  frame.moments = solver.eigenvalues();
  check_moments(frame.moments, properties.relative_error);

  const double limit =
      std::max(kNearlyEqual * frame.moments[2], 2.0 * properties.relative_error * frame.moments[0]);
  const bool first_two = frame.moments[1] - frame.moments[0] <= limit;
  const bool last_two = frame.moments[2] - frame.moments[1] <= limit;
  frame.has_near_equal_moments = first_two || last_two;

  Mat3 axes = settled(solver.eigenvectors(), first_two, last_two);
  axes.col(0) = with_largest_component_positive(axes.col(0));
  axes.col(1) = with_largest_component_positive(axes.col(1));
  axes.col(2) = axes.col(0).cross(axes.col(1)).normalized();
  frame.rotation = Quat(axes).normalized();
  return frame;
}

}  // namespace clast
