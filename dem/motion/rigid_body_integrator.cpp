#include "dem/motion/rigid_body_integrator.hpp"

#include <cmath>

#include "dem/motion/rotation.hpp"

namespace clast::dem_detail {

RigidBodyIntegrator::RigidBodyIntegrator(const RigidBody& body, const RigidState& start)
    : body_(body), radius_(body.bounding_radius()), smallest_moment_(body.moments.minCoeff()) {
  set_state(start);
}

void RigidBodyIntegrator::set_state(const RigidState& state) {
  state_ = state;
  momentum_ = angular_momentum(body_.moments, state.orientation, state.angular_velocity);
}

BodyMotion RigidBodyIntegrator::advance_flight(double duration, const Vec3& gravity) {
  BodyMotion motion = this->current_motion();
  const RigidState begin = state_;
  state_ = free_flight(body_, begin, duration, -gravity.z());
  motion.velocity = (state_.position - begin.position) / duration;
  motion.angular_velocity = 0.5 * (begin.angular_velocity + state_.angular_velocity);
  motion.world_from_body = state_.world_from_body();
  return motion;
}

BodyMotion RigidBodyIntegrator::begin_step(double duration, const Vec3& force, const Vec3& torque,
                                           const Vec3& gravity) {
  BodyMotion motion = this->current_motion();
  motion.velocity = state_.velocity + 0.5 * duration * (gravity + force / body_.mass);
  momentum_ += 0.5 * duration * torque;
  const RotationStep turn =
      integrate_rotation_step(body_.moments, state_.orientation, momentum_, duration);
  motion.angular_velocity = turn.angular_velocity;
  max_point_speed_ = motion.velocity.norm() + momentum_.norm() / smallest_moment_ * radius_;
  state_.position += duration * motion.velocity;
  state_.orientation = turn.orientation;
  state_.velocity = motion.velocity;
  motion.world_from_body = state_.world_from_body();
  return motion;
}

void RigidBodyIntegrator::end_step(double duration, const Vec3& force, const Vec3& torque,
                                   const Vec3& gravity) {
  state_.velocity += 0.5 * duration * (gravity + force / body_.mass);
  momentum_ += 0.5 * duration * torque;
  state_.angular_velocity = angular_velocity(body_.moments, state_.orientation, momentum_);
}

double RigidBodyIntegrator::apply_correction_impulse(const Vec3& impulse,
                                                     const Vec3& angular_impulse,
                                                     const Vec3& moment, const Vec3& angular_moment,
                                                     const Vec3& gravity) {
  const double before = kinetic_energy();
  const Vec3 shift = moment / body_.mass;
  const Vec3 turn = current_motion().apply_inverse_inertia(angular_moment);
  state_.velocity += impulse / body_.mass;
  state_.position += shift;
  momentum_ += angular_impulse;
  state_.orientation = (rotation_from_vector(turn) * state_.orientation).normalized();
  state_.angular_velocity = angular_velocity(body_.moments, state_.orientation, momentum_);
  correction_displacement_ = shift.norm() + turn.norm() * radius_;
  return kinetic_energy() - before - body_.mass * gravity.dot(shift);
}

double RigidBodyIntegrator::verlet_start_loss(double duration, const Vec3& force,
                                              const Vec3& torque, const Vec3& gravity) const {
  if (force.isZero() && torque.isZero()) return 0.0;
  const Vec3 weight = body_.mass * gravity;
  const double push = (force + weight).squaredNorm() - weight.squaredNorm();
  return 0.125 * duration * duration *
         (push / body_.mass + torque.dot(current_motion().apply_inverse_inertia(torque)));
}

BodyMotion RigidBodyIntegrator::current_motion() const {
  return {state_.world_from_body(), state_.velocity,
          state_.angular_velocity,  state_.position,
          state_.velocity,          state_.angular_velocity,
          1.0 / body_.mass,         body_.moments.cwiseInverse()};
}

double RigidBodyIntegrator::kinetic_energy() const {
  return translational_energy(body_, state_) + rotational_energy(body_, state_);
}

double RigidBodyIntegrator::max_angular_speed() const {
  return std::sqrt(2.0 * rotational_energy(body_, state_) / smallest_moment_);
}

bool RigidBodyIntegrator::is_finite() const {
  return state_.position.allFinite() && state_.velocity.allFinite() && momentum_.allFinite() &&
         state_.orientation.coeffs().allFinite();
}

}  // namespace clast::dem_detail
