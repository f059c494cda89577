#include "dem/motion/sleep_detector.hpp"

#include <algorithm>

namespace clast::dem_detail {

namespace {
constexpr double kHysteresis = 4.0;
}  // namespace

void SleepDetector::add_step(const RigidState& state, double step, double window, double tolerance,
                             double radius) {
  const Eigen::Vector4d rotation = state.orientation.coeffs();
  // Quaternions of both signs are the same rotation.
  const double sign = sum_.rotation.dot(rotation) < 0.0 ? -1.0 : 1.0;
  sum_.position += step * state.position;
  sum_.rotation += step * sign * rotation;
  duration_ += step;
  if (duration_ < window) return;
  const PoseSum mean{sum_.position / duration_, sum_.rotation.normalized()};
  if (last_) {
    // A rotation by a small angle a changes a unit quaternion by a/2.
    const double turn = 2.0 * std::min((mean.rotation - last_->rotation).norm(),
                                       (mean.rotation + last_->rotation).norm());
    const double moved = (mean.position - last_->position).norm() + turn * radius;
    is_stationary_ = moved <= (is_stationary_ ? kHysteresis * tolerance : tolerance);
  }
  last_ = mean;
  sum_ = {};
  duration_ = 0.0;
}

}  // namespace clast::dem_detail
