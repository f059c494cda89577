#pragma once
/// Unweighted friction of a contact point by Eq. 4: a spring with a Coulomb limit.
/// @cite garcia2022
#include <algorithm>
#include <cmath>

#include "dem/contact/detail/contact_point_load.hpp"

namespace clast::dem_detail {

/// Response of a friction or rolling spring in a step, with the energy dissipated if it slips.
struct SpringResponse {
  Vec3 load;            ///< N, or N m
  double squared_norm;  ///< of the load
  double loss = 0.0;    ///< dissipated energy times k_t or k_r, per unit weight
};

/// Returns the response of a spring whose trial load is scaled by `scale` to the Coulomb limit.
inline SpringResponse coulomb_limited(const Vec3& before, const Vec3& trial, double squared_norm,
                                      double scale) {
  // The slip of the step winds the spring up by trial - before: its work less what is stored more.
  return {scale * trial, scale * scale * squared_norm,
          0.5 * (1.0 - scale) * (before.dot(trial) + scale * squared_norm)};
}

/// Computes the tangential spring load, limited by mu f (Eq. 4).
inline SpringResponse friction(const Contact& contact, const ContactKinematics& kinematics,
                               double stiffness, double duration, double friction_coefficient) {
  const Vec3 trial = contact.tangential - stiffness * duration * kinematics.sliding_velocity;
  const double largest = friction_coefficient * contact.normal;
  const double squared_norm = trial.squaredNorm();
  if (!(squared_norm > largest * largest)) return {trial, squared_norm};
  return coulomb_limited(contact.tangential, trial, squared_norm,
                         largest / std::sqrt(squared_norm));
}

/// Returns the energy that a spring dissipates in the step in which its contact ends, J.
/// @param compliance  1/k_t or 1/k_r
/// @param rate  slip velocity or spin that loads the spring
inline double ended_spring_loss(double weight, double compliance, const Vec3& before,
                                const Vec3& rate, double duration) {
  return 0.5 * weight * (before.squaredNorm() * compliance - duration * before.dot(rate));
}

}  // namespace clast::dem_detail
