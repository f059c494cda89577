#include "dem/motion/moving_body.hpp"

#include <cmath>

#include "dem/motion/rotation.hpp"

namespace clast::dem_detail {

MovingBody::MovingBody(const RigidBody& body, const RigidState& start)
    : body_(body), radius_(body.bounding_radius()), smallest_moment_(body.moments.minCoeff()) {
  place(start);
}

void MovingBody::place(const RigidState& state) {
  state_ = state;
  momentum_ = angular_momentum(body_.moments, state.orientation, state.angular_velocity);
}

BodyMotion MovingBody::fly(double duration, const Vec3& gravity) {
  BodyMotion motion = this->motion();
  const RigidState begin = state_;
  state_ = free_flight(body_, begin, duration, -gravity.z());
  motion.velocity = (state_.position - begin.position) / duration;
  motion.angular_velocity = 0.5 * (begin.angular_velocity + state_.angular_velocity);
  motion.world_from_body = state_.world_from_body();
  return motion;
}

BodyMotion MovingBody::begin_step(double duration, const Vec3& force, const Vec3& torque,
                                  const Vec3& gravity) {
  BodyMotion motion = this->motion();
  motion.velocity = state_.velocity + 0.5 * duration * (gravity + force / body_.mass);
  momentum_ += 0.5 * duration * torque;
  const StepTurn turn = turned_one_step(body_.moments, state_.orientation, momentum_, duration);
  motion.angular_velocity = turn.angular_velocity;
  top_speed_ = motion.velocity.norm() + momentum_.norm() / smallest_moment_ * radius_;
  state_.position += duration * motion.velocity;
  state_.orientation = turn.orientation;
  state_.velocity = motion.velocity;
  motion.world_from_body = state_.world_from_body();
  return motion;
}

void MovingBody::end_step(double duration, const Vec3& force, const Vec3& torque,
                          const Vec3& gravity) {
  state_.velocity += 0.5 * duration * (gravity + force / body_.mass);
  momentum_ += 0.5 * duration * torque;
  state_.angular_velocity = angular_velocity(body_.moments, state_.orientation, momentum_);
}

double MovingBody::correct(const Vec3& impulse, const Vec3& angular_impulse, const Vec3& moment,
                           const Vec3& angular_moment, const Vec3& gravity) {
  const double before = kinetic_energy();
  const Vec3 shift = moment / body_.mass;
  const Vec3 turn = motion().inverse_inertia_times(angular_moment);
  state_.velocity += impulse / body_.mass;
  state_.position += shift;
  momentum_ += angular_impulse;
  state_.orientation = (turn_of(turn) * state_.orientation).normalized();
  state_.angular_velocity = angular_velocity(body_.moments, state_.orientation, momentum_);
  corrected_by_ = shift.norm() + turn.norm() * radius_;
  return kinetic_energy() - before - body_.mass * gravity.dot(shift);
}

double MovingBody::first_kick(double duration, const Vec3& force, const Vec3& torque,
                              const Vec3& gravity) const {
  if (force.isZero() && torque.isZero()) return 0.0;
  const Vec3 weight = body_.mass * gravity;
  const double push = (force + weight).squaredNorm() - weight.squaredNorm();
  return 0.125 * duration * duration *
         (push / body_.mass + torque.dot(motion().inverse_inertia_times(torque)));
}

BodyMotion MovingBody::motion() const {
  return {state_.world_from_body(), state_.velocity,
          state_.angular_velocity,  state_.position,
          state_.velocity,          state_.angular_velocity,
          1.0 / body_.mass,         body_.moments.cwiseInverse()};
}

double MovingBody::kinetic_energy() const {
  return translational_energy(body_, state_) + rotational_energy(body_, state_);
}

double MovingBody::top_spin() const {
  return std::sqrt(2.0 * rotational_energy(body_, state_) / smallest_moment_);
}

bool MovingBody::finite() const {
  return state_.position.allFinite() && state_.velocity.allFinite() && momentum_.allFinite() &&
         state_.orientation.coeffs().allFinite();
}

}  // namespace clast::dem_detail
