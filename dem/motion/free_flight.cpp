#include "dem/motion/free_flight.hpp"

#include <cmath>

#include "dem/motion/rotation.hpp"

namespace clast::dem_detail {
namespace {

/// Rotations below this angle, rad, are integrated by one Runge-Kutta step. Its error is 2e-15 rad,
/// and it is cheaper than elliptic functions.
constexpr double kSmallTurn = 0.003;

}  // namespace

double min_travel_time(double distance, double speed, double acceleration) {
  if (!(distance > 0.0)) return 0.0;
  // Solution of distance = speed t + acceleration t^2/2, in the form without cancellation.
  return 2.0 * distance / (speed + std::sqrt(speed * speed + 2.0 * acceleration * distance));
}

FreeFlight::FreeFlight(const RigidBody& body, const RigidState& begin, double gravity)
    : body_(body),
      begin_(begin),
      gravity_(gravity),
      momentum_(angular_momentum(body.moments, begin.orientation, begin.angular_velocity)),
      max_angular_speed_(std::sqrt(2.0 * rotational_energy(body, begin) / body.moments.minCoeff())),
      last_orientation_(begin.orientation) {}

RigidState FreeFlight::state_after(double duration) {
  RigidState state = begin_;
  state.position += duration * begin_.velocity;
  state.position.z() -= 0.5 * gravity_ * duration * duration;
  state.velocity.z() -= gravity_ * duration;
  if (max_angular_speed_ * std::abs(duration - last_time_) < kSmallTurn) {
    state.orientation =
        integrate_free_rotation(body_.moments, last_orientation_, momentum_, duration - last_time_);
  } else {
    if (!rotation_) rotation_.emplace(body_.moments, begin_.orientation, momentum_);
    state.orientation = rotation_->orientation_after(duration);
  }
  last_time_ = duration;
  last_orientation_ = state.orientation;
  state.angular_velocity = angular_velocity(body_.moments, state.orientation, momentum_);
  return state;
}

}  // namespace clast::dem_detail
