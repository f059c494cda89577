#pragma once
/// Motion without contact in closed form.
#include <optional>

#include "dem/motion/free_rotation.hpp"
#include "dem/motion/rigid_body.hpp"

namespace clast::dem_detail {

/// How long something needs at least for a distance, s, that is no faster than `speed` and gains
/// no more than `acceleration`.
double min_travel_time(double distance, double speed, double acceleration);

/// A flight from one instant on: ballistic centre, torque-free rotation. Any instant of it costs
/// the same. The body must outlive it.
class FreeFlight {
 public:
  FreeFlight(const RigidBody& body, const RigidState& begin, double gravity);

  /// The state at a time since the beginning, s. Cheapest next to the last instant computed.
  RigidState state_after(double duration);
  const RigidState& begin() const { return begin_; }
  /// The spin never exceeds this, rad/s: the energy, all in the smallest moment.
  double max_angular_speed() const { return max_angular_speed_; }

 private:
  const RigidBody& body_;
  RigidState begin_;
  double gravity_;
  Vec3 momentum_;
  double max_angular_speed_;
  double last_time_ = 0.0;
  Quat last_orientation_;
  std::optional<FreeRotation> rotation_;  ///< set up when the first turn needs it
};

}  // namespace clast::dem_detail
