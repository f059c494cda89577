#pragma once
/// Unweighted friction of a contact point by Eq. 4: a spring with a Coulomb limit.
/// @cite garcia2022
#include <algorithm>
#include <cmath>

#include "dem/contact/detail/contact_point_load.hpp"

namespace clast::dem_detail {

/// Load of a friction or rolling spring after a step, and the energy dissipated by slip.
struct SpringResponse {
  Vec3 load;            ///< spring load: force, N, or moment, N m
  double squared_norm;  ///< squared magnitude of the load
  double loss = 0.0;    ///< dissipated energy times spring stiffness, per unit of contact weight
};

/// Returns the response of a slipping spring. Its trial load is scaled down to the Coulomb limit.
inline SpringResponse scaled_to_coulomb_limit(const Vec3& before, const Vec3& trial,
                                              double squared_norm, double scale) {
  // The slip of the step winds the spring up by trial - before: its work less what is stored more.
  return {scale * trial, scale * scale * squared_norm,
          0.5 * (1.0 - scale) * (before.dot(trial) + scale * squared_norm)};
}

/// Computes the load of the tangential spring. It is limited by friction coefficient times normal
/// force (Eq. 4).
inline SpringResponse friction_response(const Contact& contact, const ContactKinematics& kinematics,
                                        double stiffness, double duration,
                                        double friction_coefficient) {
  const Vec3 trial = contact.tangential_force - stiffness * duration * kinematics.sliding_velocity;
  const double largest = friction_coefficient * contact.normal_force;
  const double squared_norm = trial.squaredNorm();
  if (!(squared_norm > largest * largest)) return {trial, squared_norm};
  return scaled_to_coulomb_limit(contact.tangential_force, trial, squared_norm,
                                 largest / std::sqrt(squared_norm));
}

/// Returns the energy that a spring dissipates in the step in which its contact ends, J.
/// @param compliance  inverse stiffness of the spring
/// @param rate  slip velocity or relative angular velocity that loads the spring
inline double spring_loss_at_contact_end(double weight, double compliance, const Vec3& before,
                                         const Vec3& rate, double duration) {
  return 0.5 * weight * (before.squaredNorm() * compliance - duration * before.dot(rate));
}

}  // namespace clast::dem_detail
