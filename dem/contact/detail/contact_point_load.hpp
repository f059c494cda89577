#pragma once
/// State of a contact point at the start of a step, and its unweighted normal force by Eq. 2. The
/// functions are inline, because they form the innermost loop.
/// @cite garcia2022
#include <algorithm>
#include <cmath>

#include "dem/contact/contact_history.hpp"
#include "dem/contact/overlap_path.hpp"
#include "dem/motion/body_motion.hpp"

namespace clast::dem_detail {

/// Cosine above which two normals belong to one plane.
inline constexpr double kSameNormal = 1.0 - 1e-12;
/// Largest fraction of a new contact's overlap that its approach speed may leave unexplained.
inline constexpr double kExplained = 1e-6;

/// Position and mean relative velocity of a contact over the step.
struct ContactKinematics {
  ContactKinematics(const Contact& contact, const RelativeMotion& motion)
      : arm(contact.position - motion.block.world_from_body.translation),
        velocity(motion.velocity_at(contact.position)),
        approach_speed(-velocity.dot(contact.point.normal)),
        sliding_velocity(velocity + approach_speed * contact.point.normal) {}
  Vec3 arm;               ///< from the centre of the block
  Vec3 velocity;          ///< m/s
  double approach_speed;  ///< component of `velocity` opposite to the contact normal, m/s
  Vec3 sliding_velocity;  ///< tangential velocity
};

/// State of a contact at the start of a step.
struct StepStart {
  OverlapPath path;  ///< of the overlap over the step
  NormalState normal = {};
  double weight = 0.0;
  double stored = 0.0;     ///< J
  bool continuous = true;  ///< false if its speed does not explain the initial overlap
};

/// Returns the initial state of a continued contact.
inline StepStart step_start_of_continued(const Contact& contact, const Contact& previous,
                                         const RelativeMotion& motion) {
  const ContactPoint &point = contact.point, &point_before = previous.point;
  StepStart start{.path = {motion.duration, point_before.overlap, point.overlap, 0.0},
                  .normal = {previous.normal, previous.residual_indentation},
                  .weight = previous.weight,
                  .stored = previous.stored};
  // On another feature it goes on as before only if the surface does too.
  const bool same = point_before.kind == point.kind &&
                    point_before.block_feature == point.block_feature &&
                    (point_before.ground_feature == point.ground_feature ||
                     point_before.normal.dot(point.normal) > kSameNormal);
  start.path.rate = same ? -motion.start_velocity_at(previous.position).dot(point_before.normal)
                         : (start.path.after - start.path.before) / motion.duration;
  return start;
}

/// Returns the initial state of a new contact. The overlap is traced back over the step at the
/// present speed. If a part of it remains, the law's `initial_state` gives the initial force.
template <NormalLaw Law>
StepStart step_start_of_new(const Contact& contact, const ContactKinematics& kinematics,
                            const Law& law, const RelativeMotion& motion) {
  const double overlap = contact.point.overlap;
  StepStart start{.path = {motion.duration, overlap - kinematics.approach_speed * motion.duration,
                           overlap, 0.0},
                  .weight = contact.weight};
  start.path.rate =
      -motion.start_velocity_at(contact.position - motion.duration * kinematics.velocity)
           .dot(contact.point.normal);
  start.continuous = start.path.before <= kExplained * overlap;
  if (start.continuous) {
    start.path.before = std::min(0.0, start.path.before);
  } else {
    start.normal = law.initial_state(start.path.before, start.path.rate, contact.effective_mass,
                                     contact.normal);
  }
  return start;
}

/// Computes the normal response by the law (Eq. 2).
template <NormalLaw Law>
NormalResponse normal_response(const Contact& contact, const StepStart& start, const Law& law) {
  const double mass = contact.effective_mass;
  if (start.path.duration > 0.0) return law.integrate(start.path, start.normal, mass);
  const NormalState first =
      law.initial_state(contact.point.overlap, start.path.rate, mass, start.normal.force);
  return {.force = first.force, .residual_indentation = first.residual_indentation};
}

}  // namespace clast::dem_detail
