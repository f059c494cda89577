#pragma once
/// Friction of one contact point by Eq. 4, before it is weighted: a spring with a Coulomb limit.
/// @cite garcia2022
#include <algorithm>
#include <cmath>

#include "dem/contact/detail/contact_point_load.hpp"

namespace clast::dem_detail {

/// A spring of friction or rolling resistance after a step, and what it gave up to its limit.
struct SpringResponse {
  Vec3 load;            ///< N, or N m
  double squared_norm;  ///< of its length
  double loss = 0.0;    ///< dissipated, times k_t or k_r and per unit of weight
};

/// The response of a spring whose trial load exceeds its limit; the load is scaled by `scale` to
/// it.
inline SpringResponse coulomb_limited(const Vec3& before, const Vec3& trial, double squared_norm,
                                      double scale) {
  // The slip of the step winds the spring up by trial - before: its work less what is stored more.
  return {scale * trial, scale * scale * squared_norm,
          0.5 * (1.0 - scale) * (before.dot(trial) + scale * squared_norm)};
}

/// Eq. 4: the tangential spring follows the slip up to mu f.
inline SpringResponse friction(const Contact& contact, const ContactKinematics& kinematics,
                               double stiffness, double duration, double friction_coefficient) {
  const Vec3 trial = contact.tangential - stiffness * duration * kinematics.sliding_velocity;
  const double largest = friction_coefficient * contact.normal;
  const double squared_norm = trial.squaredNorm();
  if (!(squared_norm > largest * largest)) return {trial, squared_norm};
  return coulomb_limited(contact.tangential, trial, squared_norm,
                         largest / std::sqrt(squared_norm));
}

/// Energy that one spring of a contact dissipates in the step in which the contact ends, J.
/// @param give  1/k_t or 1/k_r
/// @param rate  of the slip or spin that winds it up
inline double ended_spring_loss(double weight, double compliance, const Vec3& before,
                                const Vec3& rate, double duration) {
  return 0.5 * weight * (before.squaredNorm() * compliance - duration * before.dot(rate));
}

}  // namespace clast::dem_detail
