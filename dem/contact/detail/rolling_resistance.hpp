#pragma once
/// Unweighted rolling resistance of a contact point by Eq. 5.
/// @cite garcia2022
#include <cmath>

#include "dem/contact/detail/friction.hpp"

namespace clast::dem_detail {

/// Computes the moment of the rolling spring. It is limited by rolling friction times lever arm
/// times normal force (Eq. 5).
inline SpringResponse rolling_response(const Contact& contact, const ContactKinematics& kinematics,
                                       double stiffness, const RelativeMotion& motion,
                                       double rolling_friction) {
  const Vec3 trial = contact.rolling_moment - stiffness * motion.duration * motion.spin;
  const double squared_norm = trial.squaredNorm();
  if (!(rolling_friction > 0.0))
    return scaled_to_coulomb_limit(contact.rolling_moment, trial, squared_norm, 0.0);
  // The arm l is perpendicular to the axis about which the block rolls: the length of the moment
  // times the arm is that of the product of both.
  const double largest =
      rolling_friction * contact.normal_force * kinematics.arm.cross(trial).norm();
  if (!(squared_norm > largest)) return {trial, squared_norm};
  return scaled_to_coulomb_limit(contact.rolling_moment, trial, squared_norm,
                                 largest / squared_norm);
}

}  // namespace clast::dem_detail
