#pragma once
/// Free flight in closed form.
#include <optional>

#include "dem/motion/free_rotation.hpp"
#include "dem/motion/rigid_body.hpp"

namespace clast::dem_detail {

/// Returns the minimum time to travel a distance, s, for given maxima of initial speed and
/// acceleration.
double min_travel_time(double distance, double speed, double acceleration);

/// Free flight from an initial state: ballistic centre of mass, torque-free rotation. The cost does
/// not depend on the length of the flight. The body must outlive this object.
class FreeFlight {
 public:
  FreeFlight(const RigidBody& body, const RigidState& begin, double gravity);

  /// Returns the state of the body after a time of flight, s. It is fastest for a time near that of
  /// the last call.
  RigidState state_after(double duration);
  const RigidState& begin() const { return begin_; }
  /// Returns an upper bound of the angular speed during the flight, rad/s.
  double max_angular_speed() const { return max_angular_speed_; }

 private:
  const RigidBody& body_;
  RigidState begin_;
  double gravity_;
  Vec3 momentum_;
  double max_angular_speed_;
  double last_time_ = 0.0;
  Quat last_orientation_;
  std::optional<FreeRotation> rotation_;  ///< computed on demand
};

}  // namespace clast::dem_detail
