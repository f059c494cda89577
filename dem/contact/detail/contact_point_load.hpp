#pragma once
/// What one contact point brings into a step, and its normal force, friction and rolling resistance
/// by Eqs. 2, 4 and 5, before they are weighted. All inline: these are the innermost lines of a
/// simulation.
/// @cite garcia2022
#include <algorithm>
#include <cmath>

#include "dem/contact/contact_history.hpp"
#include "dem/contact/overlap_path.hpp"
#include "dem/motion/body_motion.hpp"

namespace clast::dem_detail {

/// Normals whose cosine is above this are those of one plane.
inline constexpr double kSameNormal = 1.0 - 1e-12;
/// A new contact's closing speed explains its overlap when it leaves no more than this share of it.
inline constexpr double kExplained = 1e-6;

/// Where a contact is and how the block moves there against the other body, mean over the step.
struct Slip {
  Slip(const Contact& contact, const PairMotion& motion)
      : arm(contact.place - motion.block.world_from_body.translation),
        velocity(motion.velocity_at(contact.place)),
        closing(-velocity.dot(contact.point.normal)),
        sliding(velocity + closing * contact.point.normal) {}
  Vec3 arm;        ///< from the centre of the block
  Vec3 velocity;   ///< m/s
  double closing;  ///< against the normal
  Vec3 sliding;    ///< along the surface
};

/// What a contact brings into the step.
struct Past {
  OverlapPath path;  ///< of the overlap over the step
  NormalState normal = {};
  double weight = 0.0;
  double stored = 0.0;     ///< J
  bool continuous = true;  ///< false: appeared with an overlap that its speed does not explain
};

/// Of a contact that continues another.
inline Past past_of(const Contact& contact, const Contact& previous, const PairMotion& motion) {
  const ContactPoint &point = contact.point, &point_before = previous.point;
  Past past{.path = {motion.duration, point_before.overlap, point.overlap, 0.0},
            .normal = {previous.normal, previous.dent},
            .weight = previous.weight,
            .stored = previous.stored};
  // On another feature it goes on as before only if the surface does too.
  const bool same = point_before.kind == point.kind &&
                    point_before.block_feature == point.block_feature &&
                    (point_before.ground_feature == point.ground_feature ||
                     point_before.normal.dot(point.normal) > kSameNormal);
  past.path.rate = same ? -motion.begin_velocity_at(previous.place).dot(point_before.normal)
                        : (past.path.after - past.path.before) / motion.duration;
  return past;
}

/// Of a contact that continues none: it has come from as far as its speed allows; an overlap that
/// this does not explain begins as the law lets a contact without a past begin.
template <class Law>
Past past_of_new(const Contact& contact, const Slip& slip, const Law& law,
                 const PairMotion& motion) {
  const double overlap = contact.point.overlap;
  Past past{.path = {motion.duration, overlap - slip.closing * motion.duration, overlap, 0.0},
            .weight = contact.weight};
  past.path.rate = -motion.begin_velocity_at(contact.place - motion.duration * slip.velocity)
                        .dot(contact.point.normal);
  past.continuous = past.path.before <= kExplained * overlap;
  if (past.continuous) {
    past.path.before = std::min(0.0, past.path.before);
  } else {
    past.normal =
        law.first(past.path.before, past.path.rate, contact.effective_mass, contact.normal);
  }
  return past;
}

/// Eq. 2, or what another law has in its place.
template <class Law>
NormalResponse normal_response(const Contact& contact, const Past& past, const Law& law) {
  const double mass = contact.effective_mass;
  if (past.path.duration > 0.0) return law.along(past.path, past.normal, mass);
  const NormalState first =
      law.first(contact.point.overlap, past.path.rate, mass, past.normal.force);
  return {.force = first.force, .dent = first.dent};
}

/// A spring of friction or rolling resistance after a step, and what it gave up to its limit.
struct SpringResponse {
  Vec3 load;          ///< N, or N m
  double squared;     ///< of its length
  double loss = 0.0;  ///< dissipated, times k_t or k_r and per unit of weight
};

/// Of the spring that would have become `trial` without a limit, and becomes `share` of it.
inline SpringResponse limited(const Vec3& before, const Vec3& trial, double squared, double share) {
  // The slip of the step winds the spring up by trial - before: its work less what is stored more.
  return {share * trial, share * share * squared,
          0.5 * (1.0 - share) * (before.dot(trial) + share * squared)};
}

/// Eq. 4: the tangential spring follows the slip up to mu f.
inline SpringResponse friction(const Contact& contact, const Slip& slip, double stiffness,
                               double duration, double friction_coefficient) {
  const Vec3 trial = contact.tangential - stiffness * duration * slip.sliding;
  const double largest = friction_coefficient * contact.normal;
  const double squared = trial.squaredNorm();
  if (!(squared > largest * largest)) return {trial, squared};
  return limited(contact.tangential, trial, squared, largest / std::sqrt(squared));
}

/// Eq. 5: the rolling spring follows the spin up to mu_R l f.
inline SpringResponse rolling_resistance(const Contact& contact, const Slip& slip, double stiffness,
                                         const PairMotion& motion, double rolling_friction) {
  const Vec3 trial = contact.rolling - stiffness * motion.duration * motion.spin;
  const double squared = trial.squaredNorm();
  if (!(rolling_friction > 0.0)) return limited(contact.rolling, trial, squared, 0.0);
  // The arm l is perpendicular to the axis about which the block rolls: the length of the moment
  // times the arm is that of the product of both.
  const double largest = rolling_friction * contact.normal * slip.arm.cross(trial).norm();
  if (!(squared > largest)) return {trial, squared};
  return limited(contact.rolling, trial, squared, largest / squared);
}

/// What the end of a contact dissipates of one of its springs over a step, J.
/// @param give  1/k_t or 1/k_r
/// @param rate  of the slip or spin that winds it up
inline double end_of_spring(double weight, double give, const Vec3& before, const Vec3& rate,
                            double duration) {
  return 0.5 * weight * (before.squaredNorm() * give - duration * before.dot(rate));
}

}  // namespace clast::dem_detail
