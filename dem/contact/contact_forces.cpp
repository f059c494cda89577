#include "dem/contact/contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "dem/contact/detail/rolling_resistance.hpp"

namespace clast::dem_detail {
namespace {

/// Largest distance over which a contact may continue on other features, over the smallest side.
constexpr double kNearFraction = 0.03;
/// Spare capacity of a list of contacts: half its size, or up to this number in total.
constexpr std::size_t kFewContacts = 2;

bool is_event(const NormalForceResponse& response) {
  return response.impulse != 0.0 || response.moment != 0.0;
}

/// Adds the correction impulse of the law for an event inside the step.
void add_law_event(ContactLoad& load, const NormalForceResponse& response, const Contact& contact,
                   const RelativeMotion& motion) {
  if (!load.correction) load.correction = std::make_unique<CorrectionImpulse>();
  CorrectionImpulse& event = *load.correction;
  const Vec3& normal = contact.point.normal;
  const Vec3 arm = contact.position - motion.block.world_from_body.translation;
  const Vec3 arm_of_other = contact.position - motion.other.world_from_body.translation;
  const Vec3 impulse = contact.weight * response.impulse * normal;
  event.impulse += impulse;
  event.angular_impulse += arm.cross(impulse);
  event.angular_impulse_on_other -= arm_of_other.cross(impulse);
  // Shifting two moving bodies would change their angular momentum about each other.
  if (motion.other.inverse_mass > 0.0) return;
  const Vec3 moment = contact.weight * response.moment * normal;
  event.moment += moment;
  event.angular_moment += arm.cross(moment);
}

}  // namespace

ContactForces::PairWrench::PairWrench(const ContactLoad& load, const RelativeMotion& motion)
    : force(load.force),
      torque(load.torque),
      torque_on_other(load.torque + (motion.block.world_from_body.translation -
                                     motion.other.world_from_body.translation)
                                        .cross(load.force)),
      centre(motion.block.world_from_body.translation),
      centre_of_other(motion.other.world_from_body.translation) {}

double ContactForces::PairWrench::power_over_previous_step(const RelativeMotion& motion) const {
  return torque_on_other.dot(motion.other.angular_velocity) -
         torque.dot(motion.block.angular_velocity) -
         force.dot(motion.block.velocity - motion.other.velocity);
}

double ContactForces::PairWrench::power_over_next_step(const RelativeMotion& motion) const {
  // Events may have shifted the bodies since then.
  const Vec3 arm = centre - motion.block.begin_position;
  const Vec3 arm_of_other = centre_of_other - motion.other.begin_position;
  return power_over_previous_step(motion) +
         arm_of_other.cross(force).dot(motion.other.angular_velocity) -
         arm.cross(force).dot(motion.block.angular_velocity);
}

ContactForces::ContactForces(const ContactModel& model, const BlockSurface& block, double size)
    : model_(model),
      block_(block.features),
      max_match_distance_(kNearFraction * size),
      patches_(block, model.weighting) {
  if (model.has_scar_drag) drag_ = std::make_unique<ScarDrag>(model.drag_factors, block);
}

ContactForces::Scratch& ContactForces::scratch() {
  thread_local Scratch scratch;
  return scratch;
}

ContactLoad ContactForces::update_loads(const std::vector<ContactPoint>& points,
                                        const BodyMotion& block, const BodyMotion& other,
                                        double duration, EnergyBalance& energy_balance) {
  if (points.empty() && contacts_.empty()) return {};
  const RelativeMotion motion(block, other, duration);
  return model_.visit_laws([&](const auto& laws) {
    return compute_loads(laws, points, motion, scratch(), energy_balance);
  });
}

template <NormalForceLaw Law>
ContactLoad ContactForces::compute_loads(const std::vector<Law>& laws,
                                         const std::vector<ContactPoint>& points,
                                         const RelativeMotion& motion, Scratch& scratch,
                                         EnergyBalance& energy_balance) {
  std::vector<Contact>& now = scratch.now;
  ContactHistory& history = scratch.history;
  history.match_contacts(points, contacts_, max_match_distance_);
  assign_weights(points, motion, now);
  history.transfer_springs(now, contacts_, patches_);
  if constexpr (Law::kNeedsEffectiveMass) compute_effective_masses(motion, scratch);
  if constexpr (Law::kIsPlastic) initialise_new_forces(scratch);

  if (model_.has_slip_dependent_friction && contacts_.empty() && !now.empty())
    decay_slip(now.front().zone);

  ContactLoad load;
  energy_balance.reassigned += 0.5 * motion.duration * last_wrench_.power_over_next_step(motion);
  for (std::size_t i = 0; i < now.size(); ++i) {
    compute_contact_load(now[i], history.previous_contact(i, contacts_), laws[now[i].zone], motion,
                         load, energy_balance);
  }
  last_wrench_ = PairWrench(load, motion);
  load.torque_on_other = -last_wrench_.torque_on_other;
  energy_balance.reassigned +=
      0.5 * motion.duration * last_wrench_.power_over_previous_step(motion);
  for (std::size_t j = 0; j < contacts_.size(); ++j) {
    if (history.is_continued(j)) continue;
    end_contact(contacts_[j], laws[contacts_[j].zone], motion, load, energy_balance);
  }
  store_contacts(now);
  if (model_.has_slip_dependent_friction) accumulate_slip();
  if (drag_) add_scar_drag(motion, load, energy_balance);
  if (load.correction && motion.other.inverse_mass == 0.0) {
    update_overlaps_after_correction(laws, *load.correction, motion.block, energy_balance);
  }
  find_deepest_contact();
  return load;
}

void ContactForces::store_contacts(std::vector<Contact>& now) {
  const std::size_t room = std::max(kFewContacts, now.size() + now.size() / 2);
  if (now.capacity() <= room) {
    contacts_.swap(now);
  } else if (contacts_.capacity() <= room) {
    contacts_ = now;
  } else {
    std::vector<Contact>(now).swap(contacts_);
  }
}

void ContactForces::assign_weights(const std::vector<ContactPoint>& points,
                                   const RelativeMotion& motion, std::vector<Contact>& now) {
  const std::span<const double> weights =
      patches_.compute_weights(points, motion.block.world_from_body.rotation);
  now.clear();
  now.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    now.emplace_back(points[i], model_.zone_of(points[i].ground_face), weights[i]);
  }
}

void ContactForces::compute_effective_masses(const RelativeMotion& motion, Scratch& scratch) const {
  auto& [now, history, patch_wrenches] = scratch;
  // The effective mass of a patch is that against a unit force through all its points.
  const BodyMotion &block = motion.block, &other = motion.other;
  patch_wrenches.assign(now.size(), {});
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Contact& contact = now[i];
    const Vec3 force = contact.weight * contact.point.normal;
    PatchWrench& action = patch_wrenches[patches_.patch_index(i)];
    action.force += force;
    action.torque += (contact.position - block.world_from_body.translation).cross(force);
    action.torque_on_other += (contact.position - other.world_from_body.translation).cross(force);
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    const PatchWrench& action = patch_wrenches[patches_.patch_index(i)];
    const double mobility =
        (block.inverse_mass + other.inverse_mass) * action.force.squaredNorm() +
        action.torque.dot(block.apply_inverse_inertia(action.torque)) +
        action.torque_on_other.dot(other.apply_inverse_inertia(action.torque_on_other));
    now[i].effective_mass = mobility > 0.0 ? 1.0 / mobility : 0.0;
  }
}

void ContactForces::initialise_new_forces(Scratch& scratch) const {
  auto& [now, history, patch_wrenches] = scratch;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (history.previous_contact(i, contacts_)) continue;
    double force = 0.0, weight = 0.0;
    for (std::size_t j = 0; j < now.size(); ++j) {
      const Contact* previous = history.previous_contact(j, contacts_);
      if (!previous || patches_.patch_index(j) != patches_.patch_index(i)) continue;
      force += previous->weight * previous->normal_force;
      weight += previous->weight;
    }
    if (weight > 0.0) now[i].normal_force = force / weight;
  }
}

template <NormalForceLaw Law>
void ContactForces::compute_contact_load(Contact& contact, const Contact* previous, const Law& law,
                                         const RelativeMotion& motion, ContactLoad& load,
                                         EnergyBalance& energy_balance) {
  const GroundParameters& ground = model_.zone_parameters[contact.zone];
  const ContactKinematics kinematics(contact, motion);
  const double w = contact.weight;
  ContactStepStart start = previous ? start_of_continued_contact(contact, *previous, motion)
                                    : start_of_new_contact(contact, kinematics, law, motion);
  if constexpr (Law::kIsPlastic) {
    // If the zone has changed, the new law continues with the old force.
    if (previous && previous->zone != contact.zone && previous->normal_force > 0.0) {
      start.normal =
          law.initial_state(start.path.initial_overlap, 0.0, 0.0, previous->normal_force);
    }
    if (model_.soil_memory && !previous && start.continuous) {
      start.normal.residual_indentation =
          model_.soil_memory->residual_indentation(contact.position, contact.zone);
    }
  }

  const NormalForceResponse response = normal_force_response(contact, start, law);
  contact.normal_force = response.force;
  contact.residual_indentation = response.residual_indentation;
  const SpringResponse sliding = friction_response(
      contact, kinematics, model_.stiffness.tangential, motion.duration,
      model_.has_slip_dependent_friction ? ground.slip_dependent_friction(slip_) : ground.friction);
  const SpringResponse rolling =
      rolling_response(contact, kinematics, model_.rolling_stiffnesses[contact.zone], motion,
                       ground.rolling_friction);
  if (model_.has_slip_dependent_friction) {
    const Vec3 trial = contact.tangential_force -
                       model_.stiffness.tangential * motion.duration * kinematics.sliding_velocity;
    slipped_ += w * model_.tangential_compliance *
                std::max(0.0, trial.norm() - std::sqrt(sliding.squared_norm));
  }
  contact.tangential_force = sliding.load;
  contact.rolling_moment = rolling.load;

  // The loads of a point are multiplied by its weight (Eq. 6).
  const double drop = law.force_drop(contact.point.overlap, contact.normal_force);
  const double restored_ratio =
      kinematics.approach_speed > 0.0 ? 1.0 : law.unloading_ratio(model_.stiffness.normal);
  load.impact_energy += 0.5 * w *
                        (restored_ratio * kinematics.approach_speed * kinematics.approach_speed +
                         drop * drop * motion.block.inverse_mass / model_.stiffness.normal);
  const Vec3 force = w * (contact.normal_force * contact.point.normal + contact.tangential_force);
  load.force += force;
  load.torque += kinematics.arm.cross(force) + w * contact.rolling_moment;
  if (start.continuous && is_event(response)) add_law_event(load, response, contact, motion);

  // Losses are weighted with the mean weight of the step. The rest of the change of energy comes
  // from changes of weights, zones, normals or contacts and is booked as reassigned.
  const double mean_weight = 0.5 * (start.weight + w);
  const double stored_by_normal =
      law.stored_energy(contact.point.overlap, contact.residual_indentation);
  const double by_normal =
      mean_weight * (response.work - stored_by_normal +
                     law.stored_energy(std::max(0.0, start.path.initial_overlap),
                                       start.normal.residual_indentation));
  const double by_friction = mean_weight * model_.tangential_compliance * sliding.loss;
  const double by_rolling = mean_weight * model_.rolling_compliances[contact.zone] * rolling.loss;
  contact.stored_energy =
      w *
      (stored_by_normal + 0.5 * (sliding.squared_norm * model_.tangential_compliance +
                                 rolling.squared_norm * model_.rolling_compliances[contact.zone]));
  energy_balance.normal += by_normal;
  energy_balance.friction += by_friction;
  energy_balance.rolling += by_rolling;
  energy_balance.reassigned -=
      by_normal + by_friction + by_rolling + (contact.stored_energy - start.stored_energy);
}

template <NormalForceLaw Law>
void ContactForces::end_contact(const Contact& contact, const Law& law,
                                const RelativeMotion& motion, ContactLoad& load,
                                EnergyBalance& energy_balance) const {
  const double duration = motion.duration, w = contact.weight;
  const Vec3& n = contact.point.normal;
  const Vec3 velocity = motion.velocity_of_start_point(contact.position);
  const double overlap = contact.point.overlap;
  const OverlapPath path{duration, overlap, overlap - velocity.dot(n) * duration,
                         -motion.start_velocity_at(contact.position).dot(n)};
  double own = 0.0;
  if (path.final_overlap <= 0.0) {  // separated; otherwise it slid off while still loaded
    const NormalForceResponse response = law.integrate(
        path, {contact.normal_force, contact.residual_indentation}, contact.effective_mass);
    if (is_event(response)) add_law_event(load, response, contact, motion);
    const double by_normal =
        w * (response.work + law.stored_energy(overlap, contact.residual_indentation));
    const double by_friction = spring_loss_at_contact_end(
        w, model_.tangential_compliance, contact.tangential_force, velocity, duration);
    const double by_rolling = spring_loss_at_contact_end(
        w, model_.rolling_compliances[contact.zone], contact.rolling_moment, motion.spin, duration);
    energy_balance.normal += by_normal;
    energy_balance.friction += by_friction;
    energy_balance.rolling += by_rolling;
    own = by_normal + by_friction + by_rolling;
  }
  energy_balance.reassigned += contact.stored_energy - own;
}

template <NormalForceLaw Law>
void ContactForces::update_overlaps_after_correction(const std::vector<Law>& laws,
                                                     const CorrectionImpulse& event,
                                                     const BodyMotion& block,
                                                     EnergyBalance& energy_balance) {
  const Vec3 shift = block.inverse_mass * event.moment;
  const Vec3 turn = block.apply_inverse_inertia(event.angular_moment);
  for (Contact& contact : contacts_) {
    const Vec3 moved = shift + turn.cross(contact.position - block.world_from_body.translation);
    const double before = contact.stored_energy;
    const double overlap = contact.point.overlap;
    contact.point.overlap = std::max(0.0, overlap - moved.dot(contact.point.normal));
    // The force does not change, and so neither does the overlap beyond the indentation.
    if constexpr (Law::kIsPlastic) contact.residual_indentation += contact.point.overlap - overlap;
    contact.stored_energy = contact_stored_energy(contact, laws[contact.zone]);
    energy_balance.reassigned -= contact.stored_energy - before;
  }
}

template <NormalForceLaw Law>
double ContactForces::contact_stored_energy(const Contact& contact, const Law& law) const {
  return contact.weight *
         (law.stored_energy(contact.point.overlap, contact.residual_indentation) +
          0.5 * (contact.tangential_force.squaredNorm() * model_.tangential_compliance +
                 contact.rolling_moment.squaredNorm() * model_.rolling_compliances[contact.zone]));
}

void ContactForces::decay_slip(std::uint16_t zone) {
  const double memory = model_.zone_parameters[zone].slip_memory;
  slip_ = memory > 0.0 ? slip_ * std::exp(-contactless_time_ / memory) : 0.0;
  contactless_time_ = 0.0;
}

void ContactForces::accumulate_slip() {
  const double total = weight();
  if (total > 0.0) slip_ += slipped_ / total;
  slipped_ = 0.0;
}

void ContactForces::add_scar_drag(const RelativeMotion& motion, ContactLoad& load,
                                  EnergyBalance& energy_balance) {
  double lost = 0.0;
  const Vec3 force = drag_->update(contacts_, motion, lost);
  energy_balance.friction += lost;
  if (contacts_.empty()) return;
  load.force += force;
  load.torque +=
      (drag_->application_point() - motion.block.world_from_body.translation).cross(force);
  load.torque_on_other -=
      (drag_->application_point() - motion.other.world_from_body.translation).cross(force);
}

double ContactForces::contact_mobility(std::span<const double> vertex_mobilities) const {
  double sum = 0.0;
  for (const Contact& contact : contacts_) {
    const std::uint32_t feature = contact.point.block_feature;
    const auto largest = [&](const auto& vertices) {
      double most = 0.0;
      for (const std::uint32_t vertex : vertices) most = std::max(most, vertex_mobilities[vertex]);
      return most;
    };
    sum += contact.weight * (contact.point.kind == ContactKind::kVertexGround
                                 ? vertex_mobilities[feature]
                             : contact.point.kind == ContactKind::kFaceVertex
                                 ? largest(block_.faces[feature].vertices)
                                 : largest(block_.edges[feature].vertices));
  }
  return sum;
}

double ContactForces::weight() const {
  double sum = 0.0;
  for (const Contact& contact : contacts_) sum += contact.weight;
  return sum;
}

void ContactForces::store_indentations(SoilMemory& soil) const {
  for (const Contact& contact : contacts_)
    soil.add_indentation(contact.position, contact.zone, contact.residual_indentation);
}

double ContactForces::stored_energy() const {
  double sum = 0.0;
  for (const Contact& contact : contacts_) sum += contact.stored_energy;
  return sum;
}

void ContactForces::find_deepest_contact() {
  deepest_ = 0;
  for (std::size_t i = 1; i < contacts_.size(); ++i) {
    if (contacts_[i].point.overlap > contacts_[deepest_].point.overlap) deepest_ = i;
  }
}

std::optional<ContactForces::DeepestContact> ContactForces::deepest_contact() const {
  if (contacts_.empty()) return std::nullopt;
  const Contact& contact = contacts_[deepest_];
  return DeepestContact{static_cast<std::uint32_t>(contacts_.size()), contact.point.overlap,
                        contact.position, contact.zone};
}

double ContactForces::compute_settled_depth() {
  // The depth of a patch in Eq. 2 is its weighted mean overlap.
  std::vector<double> depth(contacts_.size(), 0.0);
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const ContactPoint& point = contacts_[i].point;
    depth[patches_.patch_index(i)] +=
        contacts_[i].weight * point.overlap * std::max(0.0, point.normal.z());
  }
  return depth.empty() ? 0.0 : *std::max_element(depth.begin(), depth.end());
}

bool ContactForces::is_plastic() const {
  return model_.visit_laws(
      []<NormalForceLaw Law>(const std::vector<Law>&) { return Law::kIsPlastic; });
}

double ContactForces::static_stiffness() const {
  return model_.visit_laws([&](const auto& laws) {
    double smallest = model_.stiffness.normal;
    for (const Contact& contact : contacts_) {
      smallest = std::min(smallest, laws[contact.zone].static_stiffness());
    }
    return smallest;
  });
}

}  // namespace clast::dem_detail
