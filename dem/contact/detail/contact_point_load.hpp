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

/// Cosine of the angle between two normals above which they count as equal.
inline constexpr double kMinSameNormalCosine = 1.0 - 1e-12;
/// Largest initial overlap of a contact that counts as begun inside the step, as a fraction of its
/// final overlap.
inline constexpr double kMaxUnexplainedFraction = 1e-6;

/// Position and mean relative velocity of a contact over the step.
struct ContactKinematics {
  ContactKinematics(const Contact& contact, const RelativeMotion& motion)
      : arm(contact.position - motion.block.world_from_body.translation),
        velocity(motion.velocity_at(contact.position)),
        approach_speed(-scalar_product(velocity, contact.point.normal)),
        sliding_velocity(velocity.x() + approach_speed * contact.point.normal.x(),
                         velocity.y() + approach_speed * contact.point.normal.y(),
                         velocity.z() + approach_speed * contact.point.normal.z()) {}
  Vec3 arm;               ///< position relative to the centre of the block, m
  Vec3 velocity;          ///< mean relative velocity at the contact, m/s
  double approach_speed;  ///< component of `velocity` opposite to the contact normal, m/s
  Vec3 sliding_velocity;  ///< component of `velocity` tangential to the contact, m/s
};

/// State of a contact at the start of a step, with the path of its overlap.
struct ContactStepStart {
  OverlapPath path;  ///< overlap over the step
  NormalForceState normal = {};
  double weight = 0.0;
  double stored_energy = 0.0;  ///< weighted elastic energy, J
  /// False if the contact overlaps at the start of the step although it is new.
  bool continuous = true;
};

/// Returns the state at the start of the step of a contact that continues one of the previous step.
inline ContactStepStart start_of_continued_contact(const Contact& contact, const Contact& previous,
                                                   const RelativeMotion& motion) {
  const ContactPoint &point = contact.point, &point_before = previous.point;
  ContactStepStart start{.path = {motion.duration, point_before.overlap, point.overlap, 0.0},
                         .normal = {previous.normal_force, previous.residual_indentation},
                         .weight = previous.weight,
                         .stored_energy = previous.stored_energy};
  // On another feature it goes on as before only if the surface does too.
  const bool same = point_before.kind == point.kind &&
                    point_before.block_feature == point.block_feature &&
                    (point_before.ground_feature == point.ground_feature ||
                     point_before.normal.dot(point.normal) > kMinSameNormalCosine);
  start.path.initial_rate =
      same ? -scalar_product(motion.start_velocity_at(previous.position), point_before.normal)
           : (start.path.final_overlap - start.path.initial_overlap) / motion.duration;
  return start;
}

/// Returns the state at the start of the step of a new contact. The overlap is traced back over the
/// step at the present speed. If overlap remains at the start, the normal law gives the initial
/// force.
template <NormalForceLaw Law>
ContactStepStart start_of_new_contact(const Contact& contact, const ContactKinematics& kinematics,
                                      const Law& law, const RelativeMotion& motion) {
  const double overlap = contact.point.overlap;
  ContactStepStart start{
      .path = {motion.duration, overlap - kinematics.approach_speed * motion.duration, overlap,
               0.0},
      .weight = contact.weight};
  start.path.initial_rate =
      -motion.start_velocity_at(contact.position - motion.duration * kinematics.velocity)
           .dot(contact.point.normal);
  start.continuous = start.path.initial_overlap <= kMaxUnexplainedFraction * overlap;
  if (start.continuous) {
    start.path.initial_overlap = std::min(0.0, start.path.initial_overlap);
  } else {
    start.normal = law.initial_state(start.path.initial_overlap, start.path.initial_rate,
                                     contact.effective_mass, contact.normal_force);
  }
  return start;
}

/// Computes force, work and correction impulse of a contact by the normal law (Eq. 2).
template <NormalForceLaw Law>
NormalForceResponse normal_force_response(const Contact& contact, const ContactStepStart& start,
                                          const Law& law) {
  const double mass = contact.effective_mass;
  if (start.path.duration > 0.0) return law.integrate(start.path, start.normal, mass);
  const NormalForceState first =
      law.initial_state(contact.point.overlap, start.path.initial_rate, mass, start.normal.force);
  return {.force = first.force, .residual_indentation = first.residual_indentation};
}

}  // namespace clast::dem_detail
