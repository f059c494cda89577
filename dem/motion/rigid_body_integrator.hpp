#pragma once
/// One step of a rigid body under contact loads: velocity Verlet with the angular momentum as the
/// rotational state.
#include "dem/motion/body_motion.hpp"
#include "dem/motion/rigid_body.hpp"

namespace clast::dem_detail {

/// A moving body. `begin_step` and `end_step` alternate; contacts are evaluated between them.
class RigidBodyIntegrator {
 public:
  RigidBodyIntegrator(const RigidBody& body, const RigidState& start);

  const RigidState& state() const { return state_; }
  /// Sets its state, as after a flight.
  void set_state(const RigidState& state);

  /// Flies without contact for a time.
  BodyMotion advance_flight(double duration, const Vec3& gravity);
  /// Half a kick, then the move to the new place. Returns that place and the mean velocities.
  BodyMotion begin_step(double duration, const Vec3& force, const Vec3& torque,
                        const Vec3& gravity);
  /// Half a kick by the loads at the new place.
  void end_step(double duration, const Vec3& force, const Vec3& torque, const Vec3& gravity);

  /// Applies what the events inside the last step add to it.
  /// @returns  the energy that this adds, kinetic and potential, J
  double apply_event_impulse(const Vec3& impulse, const Vec3& angular_impulse, const Vec3& moment,
                             const Vec3& angular_moment, const Vec3& gravity);

  /// What Verlet steps lose when they begin with contact loads that no step has ended with (a
  /// dashpot acts from the first touch on), J (docs/theory.md).
  double verlet_start_loss(double duration, const Vec3& force, const Vec3& torque,
                           const Vec3& gravity) const;

  /// Where it is and how it moves, without a step.
  BodyMotion current_motion() const;
  double kinetic_energy() const;  ///< J
  /// It spins no faster than this without a torque, rad/s.
  double max_angular_speed() const;
  /// No point of the rounded body was faster than this in the last step, m/s.
  double max_point_speed() const { return max_point_speed_; }
  /// No point of it was shifted farther by the last `apply_event_impulse`, m.
  double correction_displacement() const { return correction_displacement_; }
  bool is_finite() const;
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(state_, momentum_, max_point_speed_, correction_displacement_);
  }

 private:
  const RigidBody& body_;
  RigidState state_;
  Vec3 momentum_;  ///< angular, world axes, kg m^2/s
  double radius_;  ///< of the rounded body about its centre, m
  double smallest_moment_;
  double max_point_speed_ = 0.0;
  double correction_displacement_ = 0.0;
};

}  // namespace clast::dem_detail
