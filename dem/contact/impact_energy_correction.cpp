#include "dem/contact/impact_energy_correction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clast::dem_detail {
namespace {

/// An impulse is at most doubled, so that a weak contact does not correct the errors of others.
constexpr double kMaxAdded = 1.0;

Vec3 angular_momentum_of(const BodyMotion& motion) {
  const Quat& rotation = motion.world_from_body.rotation;
  const Vec3 spin_in_body = rotation.conjugate() * motion.angular_velocity;
  return rotation * Vec3(spin_in_body.cwiseQuotient(motion.inverse_moments));
}

/// Applies a fraction of the impulse to a block so that it gains the energy it lacks.
/// @returns  energy added, J; if negative, limited to the energy of the motion along the impulse
double apply_scaled_impulse(RigidBodyIntegrator& body, const Vec3& impulse,
                            const Vec3& angular_impulse, double owed) {
  // The fraction x of the impulse adds the energy rate x + curve x^2.
  const BodyMotion motion = body.current_motion();
  const double rate = impulse.dot(motion.velocity) + angular_impulse.dot(motion.angular_velocity);
  const double curve = 0.5 * (motion.inverse_mass * impulse.squaredNorm() +
                              angular_impulse.dot(motion.apply_inverse_inertia(angular_impulse)));
  if (rate == 0.0 || !(curve > 0.0) || owed == 0.0) return 0.0;
  const double root = std::sqrt(std::max(0.0, rate * rate + 4.0 * curve * owed));
  const double most = owed < 0.0 ? 0.5 * std::abs(rate) / curve : kMaxAdded;
  const double fraction = std::clamp(2.0 * owed / (rate + std::copysign(root, rate)), -most, most);
  return body.apply_correction_impulse(fraction * impulse, fraction * angular_impulse, Vec3::Zero(),
                                       Vec3::Zero(), Vec3::Zero());
}

}  // namespace

void ImpactEnergyCorrection::add_contact_load(double duration, const ContactLoad& load) {
  impulse_ += duration * load.force;
  angular_impulse_ += duration * load.torque;
}

void ImpactEnergyCorrection::add_correction_impulse(const CorrectionImpulse& event) {
  impulse_ += event.impulse;
  angular_impulse_ += event.angular_impulse;
}

bool ImpactEnergyCorrection::end_impact(RigidBodyIntegrator& body, double energy_plus_losses) {
  const Vec3 impulse = std::exchange(impulse_, Vec3::Zero());
  const Vec3 angular_impulse = std::exchange(angular_impulse_, Vec3::Zero());
  if (!std::exchange(applies_, false)) {
    expected_energy_ = energy_plus_losses;
    return false;
  }
  double owed = expected_energy_ - energy_plus_losses;
  owed -= apply_scaled_impulse(body, impulse, angular_impulse, owed);
  // A block that rocked has received impulses in opposite directions. Its energy is then in the
  // rotation and in the velocity along the impulse.
  const BodyMotion motion = body.current_motion();
  const double squared = impulse.squaredNorm();
  const Vec3 along =
      squared > 0.0 ? Vec3(impulse.dot(motion.velocity) / squared * impulse) : Vec3(Vec3::Zero());
  apply_scaled_impulse(body, along / motion.inverse_mass, angular_momentum_of(motion), owed);
  return true;
}

}  // namespace clast::dem_detail
