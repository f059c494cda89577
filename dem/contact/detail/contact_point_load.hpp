#pragma once
/// The state of one contact point at the start of a step, and its normal force by Eq. 2, before it
/// is weighted.
/// All inline: these are the innermost lines of a simulation.
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
template <NormalLaw Law>
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
        law.initial_state(past.path.before, past.path.rate, contact.effective_mass, contact.normal);
  }
  return past;
}

/// Eq. 2, or what another law has in its place.
template <NormalLaw Law>
NormalResponse normal_response(const Contact& contact, const Past& past, const Law& law) {
  const double mass = contact.effective_mass;
  if (past.path.duration > 0.0) return law.integrate(past.path, past.normal, mass);
  const NormalState first =
      law.initial_state(contact.point.overlap, past.path.rate, mass, past.normal.force);
  return {.force = first.force, .dent = first.dent};
}

}  // namespace clast::dem_detail
