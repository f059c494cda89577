#include "dem/contact/body_pair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clast::dem_detail {
namespace {

/// What the search needs is dropped when the bounds are this share of the block's smallest side
/// apart: farther than where it was made, so that a pair at the limit does not make it every step.
constexpr double kDropShare = 0.2;

}  // namespace

bool first_is_reference(const BlockSurface& first, const BlockSurface& second) {
  const bool first_has = !first.features.faces.empty(), second_has = !second.features.faces.empty();
  if (first_has != second_has) return first_has;
  return first.bounding_radius >= second.bounding_radius;
}

BodyPair::Near::Near(Search of_pair, const BlockSurface& block, double size,
                     const ContactRules& rules)
    : search(std::move(of_pair)), forces(rules, block, size) {}

BodyPair::BodyPair(const IndexedSurface& terrain, const BlockSurface& block, double size,
                   const ContactRules& rules)
    : reference_(terrain), block_(block), size_(size), rules_(rules) {
  if (rules.soil) dents_ = std::make_unique<SoilMemory>(rules.zones);
}

BodyPair::BodyPair(const BlockSurface& reference, const BlockSurface& block, double size,
                   const ContactRules& rules)
    : BodyPair(static_cast<const IndexedSurface&>(reference), block, size, rules) {
  reference_block_ = &reference;
}

BodyPair::Search BodyPair::new_search() const {
  if (!reference_block_) return std::make_unique<ContactSearch>(reference_, block_, size_);
  if (reference_.features.faces.empty()) return RodContacts(reference_, block_);
  return BlockContacts(*reference_block_, block_, size_);
}

double BodyPair::gap_of_spheres(const BodyMotion& reference, const BodyMotion& block) const {
  if (!reference_block_) return 0.0;
  const double near = reference_block_->bounding_radius + block_.bounding_radius;
  const double apart =
      (block.world_from_body.translation - reference.world_from_body.translation).norm();
  return std::max(0.0, apart - near);
}

double BodyPair::gap_of_bounds(const Vec3& block_centre) const {
  const Vec3 nearest =
      block_centre.cwiseMax(reference_.extent.low).cwiseMin(reference_.extent.high);
  return (block_centre - nearest).norm() - block_.bounding_radius - reference_.radius;
}

double BodyPair::travel_to(const Pose& pose) const {
  // A turn by an angle a moves no point farther than 2 sin(a/2) times its distance.
  const double turn = 2.0 * (near_->pose.rotation.conjugate() * pose.rotation).vec().norm();
  return near_->travel + (pose.translation - near_->pose.translation).norm() +
         turn * block_.bounding_radius;
}

const ContactLoad& BodyPair::update(const BodyMotion& reference, const BodyMotion& block,
                                    double duration) {
  if (!near_ && gap_of_spheres(reference, block) > 0.0) return load_;  // which is none
  const Pose pose = reference.world_from_body.inverse() * block.world_from_body;
  load_ = {};
  if (!near_) {
    if (gap_of_bounds(pose.translation) > 0.0) return load_;
    near_ = std::make_unique<Near>(new_search(), block_, size_, rules_);
  } else {
    near_->travel = travel_to(pose);
    if (near_->forces.empty()) near_->forces.wait(duration);
  }
  near_->pose = pose;
  if (near_->forces.empty() && near_->travel < near_->asleep_until) return load_;
  if (near_->forces.empty() && gap_of_bounds(pose.translation) > kDropShare * size_) {
    near_.reset();
    return load_;
  }
  load_ = near_->forces.update(find_points(reference.world_from_body, pose), block, reference,
                               duration, ledger_);
  if (dents_) near_->forces.leave_dents_in(*dents_);
  if (near_->forces.empty()) {
    near_->asleep_until = near_->with_search([&]<class Kind>(Kind& search) {
      if constexpr (std::is_same_v<Kind, RodContacts>) {
        return near_->travel + search.clearance();
      } else {
        return search.safe_travel();
      }
    });
  }
  return load_;
}

double BodyPair::clearance(const BodyMotion& reference, const BodyMotion& block) const {
  if (touching()) return 0.0;
  const Pose pose = reference.world_from_body.inverse() * block.world_from_body;
  return std::max(
      0.0, near_ ? near_->asleep_until - travel_to(pose)
                 : std::max(gap_of_spheres(reference, block), gap_of_bounds(pose.translation)));
}

void BodyPair::end_contacts(const BodyMotion& reference, const BodyMotion& block) {
  if (near_) near_->forces.update({}, block, reference, 0.0, ledger_);
  near_.reset();
  load_ = {};
}

std::vector<ContactPoint>& BodyPair::find_points(const Pose& world_from_reference,
                                                 const Pose& reference_from_block) {
  std::vector<ContactPoint>& points =
      near_->with_search([&]<class Kind>(Kind& search) -> std::vector<ContactPoint>& {
        if constexpr (std::is_same_v<Kind, RodContacts>) {
          return search.contacts(reference_from_block);
        } else {
          return search.contacts(reference_from_block, near_->travel);
        }
      });
  if (!reference_block_) return points;  // the terrain is in world axes
  const Mat3 rotation = world_from_reference.rotation.toRotationMatrix();
  for (ContactPoint& point : points) {
    point.normal = rotation * point.normal;
    point.foot = rotation * point.foot + world_from_reference.translation;
  }
  return points;
}

}  // namespace clast::dem_detail
