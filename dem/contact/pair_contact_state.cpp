#include "dem/contact/pair_contact_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clast::dem_detail {
namespace {

/// The data of the narrow phase are dropped at this distance of the bounding volumes, as a fraction
/// of the block's smallest side. They are made at a smaller distance, so that a pair near the limit
/// does not make them in every step.
constexpr double kDiscardFraction = 0.2;

}  // namespace

bool is_reference_body(const BlockSurface& first, const BlockSurface& second) {
  const bool first_has = !first.features.faces.empty(), second_has = !second.features.faces.empty();
  if (first_has != second_has) return first_has;
  return first.bounding_radius >= second.bounding_radius;
}

PairContactState::NarrowPhaseState::NarrowPhaseState(NarrowPhase of_pair, const BlockSurface& block,
                                                     double size, const ContactModel& model)
    : search(std::move(of_pair)), forces(model, block, size) {}

PairContactState::PairContactState(const IndexedSurface& terrain, const BlockSurface& block,
                                   double size, const ContactModel& model)
    : reference_(terrain), block_(block), size_(size), model_(model) {
  if (model.soil_memory) indentations_ = std::make_unique<SoilMemory>(model.zone_parameters);
}

PairContactState::PairContactState(const BlockSurface& reference, const BlockSurface& block,
                                   double size, const ContactModel& model)
    : PairContactState(static_cast<const IndexedSurface&>(reference), block, size, model) {
  reference_block_ = &reference;
}

PairContactState::NarrowPhase PairContactState::make_narrow_phase() const {
  if (!reference_block_) return std::make_unique<TerrainNarrowPhase>(reference_, block_, size_);
  if (reference_.features.faces.empty()) return RodNarrowPhase(reference_, block_);
  return BlockNarrowPhase(*reference_block_, block_, size_);
}

double PairContactState::bounding_sphere_distance(const BodyMotion& reference,
                                                  const BodyMotion& block) const {
  if (!reference_block_) return 0.0;
  const double near = reference_block_->bounding_radius + block_.bounding_radius;
  const double apart =
      (block.world_from_body.translation - reference.world_from_body.translation).norm();
  return std::max(0.0, apart - near);
}

double PairContactState::bounding_box_distance(const Vec3& block_centre) const {
  const Vec3 nearest =
      block_centre.cwiseMax(reference_.extent.low).cwiseMin(reference_.extent.high);
  return (block_centre - nearest).norm() - block_.bounding_radius - reference_.radius;
}

double PairContactState::displacement_to(const Pose& pose) const {
  // A rotation by an angle a moves no point farther than 2 sin(a/2) times its distance.
  const double turn = 2.0 * (near_->pose.rotation.conjugate() * pose.rotation).vec().norm();
  return near_->displacement + (pose.translation - near_->pose.translation).norm() +
         turn * block_.bounding_radius;
}

const ContactLoad& PairContactState::update_loads(const BodyMotion& reference,
                                                  const BodyMotion& block, double duration) {
  if (!near_ && bounding_sphere_distance(reference, block) > 0.0) return load_;  // which is zero
  const Pose pose = reference.world_from_body.inverse() * block.world_from_body;
  load_ = {};
  if (!near_) {
    if (bounding_box_distance(pose.translation) > 0.0) return load_;
    near_ = std::make_unique<NarrowPhaseState>(make_narrow_phase(), block_, size_, model_);
  } else {
    near_->displacement = displacement_to(pose);
    if (near_->forces.empty()) near_->forces.advance_time(duration);
  }
  near_->pose = pose;
  if (near_->forces.empty() && near_->displacement < near_->separated_until) return load_;
  if (near_->forces.empty() && bounding_box_distance(pose.translation) > kDiscardFraction * size_) {
    near_.reset();
    return load_;
  }
  load_ = near_->forces.update_loads(find_contact_points(reference.world_from_body, pose), block,
                                     reference, duration, energy_balance_);
  if (indentations_) near_->forces.store_indentations(*indentations_);
  if (near_->forces.empty()) {
    near_->separated_until = near_->visit_narrow_phase([&]<class Kind>(Kind& search) {
      if constexpr (std::is_same_v<Kind, RodNarrowPhase>) {
        return near_->displacement + search.clearance();
      } else {
        return search.contact_free_displacement();
      }
    });
  }
  return load_;
}

double PairContactState::clearance(const BodyMotion& reference, const BodyMotion& block) const {
  if (is_touching()) return 0.0;
  const Pose pose = reference.world_from_body.inverse() * block.world_from_body;
  return std::max(0.0, near_ ? near_->separated_until - displacement_to(pose)
                             : std::max(bounding_sphere_distance(reference, block),
                                        bounding_box_distance(pose.translation)));
}

void PairContactState::end_contacts(const BodyMotion& reference, const BodyMotion& block) {
  if (near_) near_->forces.update_loads({}, block, reference, 0.0, energy_balance_);
  near_.reset();
  load_ = {};
}

std::vector<ContactPoint>& PairContactState::find_contact_points(const Pose& world_from_reference,
                                                                 const Pose& reference_from_block) {
  std::vector<ContactPoint>& points =
      near_->visit_narrow_phase([&]<class Kind>(Kind& search) -> std::vector<ContactPoint>& {
        if constexpr (std::is_same_v<Kind, RodNarrowPhase>) {
          return search.find_contacts(reference_from_block);
        } else {
          return search.find_contacts(reference_from_block, near_->displacement);
        }
      });
  if (!reference_block_) return points;  // the terrain is in world axes
  const Mat3 rotation = world_from_reference.rotation.toRotationMatrix();
  for (ContactPoint& point : points) {
    point.normal = rotation * point.normal;
    point.surface_point = rotation * point.surface_point + world_from_reference.translation;
  }
  return points;
}

}  // namespace clast::dem_detail
