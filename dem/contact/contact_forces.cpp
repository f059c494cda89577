#include "dem/contact/contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "dem/contact/detail/rolling_resistance.hpp"

namespace clast::dem_detail {
namespace {

/// A contact may continue another on other features when it is closer than this share of the
/// block's smallest side.
constexpr double kNearShare = 0.03;
/// A list of contacts may have room for half as many more as it holds, or for this many in all.
constexpr std::size_t kFewContacts = 2;

bool is_event(const NormalResponse& response) {
  return response.impulse != 0.0 || response.moment != 0.0;
}

/// Adds what the law does inside the step beyond the scheme's own forces.
void add_law_event(ContactLoad& load, const NormalResponse& response, const Contact& contact,
                   const PairMotion& motion) {
  if (!load.event) load.event = std::make_unique<EventLoad>();
  EventLoad& event = *load.event;
  const Vec3& normal = contact.point.normal;
  const Vec3 arm = contact.place - motion.block.world_from_body.translation;
  const Vec3 arm_of_other = contact.place - motion.other.world_from_body.translation;
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

ContactForces::Action::Action(const ContactLoad& load, const PairMotion& motion)
    : force(load.force),
      torque(load.torque),
      torque_on_other(load.torque + (motion.block.world_from_body.translation -
                                     motion.other.world_from_body.translation)
                                        .cross(load.force)),
      centre(motion.block.world_from_body.translation),
      centre_of_other(motion.other.world_from_body.translation) {}

double ContactForces::Action::power_at(const PairMotion& motion) const {
  return torque_on_other.dot(motion.other.angular_velocity) -
         torque.dot(motion.block.angular_velocity) -
         force.dot(motion.block.velocity - motion.other.velocity);
}

double ContactForces::Action::power_from(const PairMotion& motion) const {
  // Events may have shifted the bodies since.
  const Vec3 arm = centre - motion.block.begin_position;
  const Vec3 arm_of_other = centre_of_other - motion.other.begin_position;
  return power_at(motion) + arm_of_other.cross(force).dot(motion.other.angular_velocity) -
         arm.cross(force).dot(motion.block.angular_velocity);
}

ContactForces::ContactForces(const ContactRules& rules, const BlockSurface& block, double size)
    : rules_(rules),
      block_(block.features),
      near_(kNearShare * size),
      patches_(block, rules.weights) {
  if (rules.drags) drag_ = std::make_unique<ScarDrag>(rules.drag_strength, block);
}

ContactForces::Scratch& ContactForces::scratch() {
  thread_local Scratch scratch;
  return scratch;
}

ContactLoad ContactForces::update(const std::vector<ContactPoint>& points, const BodyMotion& block,
                                  const BodyMotion& other, double duration, EnergyLedger& ledger) {
  if (points.empty() && contacts_.empty()) return {};
  const PairMotion motion(block, other, duration);
  return rules_.with_laws(
      [&](const auto& laws) { return apply(laws, points, motion, scratch(), ledger); });
}

template <NormalLaw Law>
ContactLoad ContactForces::apply(const std::vector<Law>& laws,
                                 const std::vector<ContactPoint>& points, const PairMotion& motion,
                                 Scratch& scratch, EnergyLedger& ledger) {
  std::vector<Contact>& now = scratch.now;
  ContactHistory& history = scratch.history;
  history.match(points, contacts_, near_);
  distribute(points, motion, now);
  history.transfer_springs(now, contacts_, patches_);
  if constexpr (Law::kNeedsEffectiveMass) find_effective_masses(motion, scratch);
  if constexpr (Law::kIsPlastic) spread_forces(scratch);

  if (rules_.slip_grows && contacts_.empty() && !now.empty()) forget_slip(now.front().zone);

  ContactLoad load;
  ledger.reassigned += 0.5 * motion.duration * acted_.power_from(motion);
  for (std::size_t i = 0; i < now.size(); ++i) {
    load_contact(now[i], history.previous(i, contacts_), laws[now[i].zone], motion, load, ledger);
  }
  acted_ = Action(load, motion);
  load.torque_on_other = -acted_.torque_on_other;
  ledger.reassigned += 0.5 * motion.duration * acted_.power_at(motion);
  for (std::size_t j = 0; j < contacts_.size(); ++j) {
    if (history.continues(j)) continue;
    end_contact(contacts_[j], laws[contacts_[j].zone], motion, load, ledger);
  }
  keep(now);
  if (rules_.slip_grows) add_slip();
  if (drag_) add_drag(motion, load, ledger);
  if (load.event && motion.other.inverse_mass == 0.0) {
    shift_overlaps(laws, *load.event, motion.block, ledger);
  }
  find_deepest();
  return load;
}

void ContactForces::keep(std::vector<Contact>& now) {
  const std::size_t room = std::max(kFewContacts, now.size() + now.size() / 2);
  if (now.capacity() <= room) {
    contacts_.swap(now);
  } else if (contacts_.capacity() <= room) {
    contacts_ = now;
  } else {
    std::vector<Contact>(now).swap(contacts_);
  }
}

void ContactForces::distribute(const std::vector<ContactPoint>& points, const PairMotion& motion,
                               std::vector<Contact>& now) {
  const std::span<const double> weights =
      patches_.share(points, motion.block.world_from_body.rotation);
  now.clear();
  now.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    now.emplace_back(points[i], rules_.zone_of(points[i].ground_face), weights[i]);
  }
}

void ContactForces::find_effective_masses(const PairMotion& motion, Scratch& scratch) const {
  auto& [now, history, patch_action] = scratch;
  // The unit force of a patch acts through all its points: how easily that moves both bodies.
  const BodyMotion &block = motion.block, &other = motion.other;
  patch_action.assign(now.size(), {});
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Contact& contact = now[i];
    const Vec3 force = contact.weight * contact.point.normal;
    PatchAction& action = patch_action[patches_.patch_of(i)];
    action.force += force;
    action.torque += (contact.place - block.world_from_body.translation).cross(force);
    action.torque_on_other += (contact.place - other.world_from_body.translation).cross(force);
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    const PatchAction& action = patch_action[patches_.patch_of(i)];
    const double mobility =
        (block.inverse_mass + other.inverse_mass) * action.force.squaredNorm() +
        action.torque.dot(block.inverse_inertia_times(action.torque)) +
        action.torque_on_other.dot(other.inverse_inertia_times(action.torque_on_other));
    now[i].effective_mass = mobility > 0.0 ? 1.0 / mobility : 0.0;
  }
}

void ContactForces::spread_forces(Scratch& scratch) const {
  auto& [now, history, patch_action] = scratch;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (history.previous(i, contacts_)) continue;
    double force = 0.0, weight = 0.0;
    for (std::size_t j = 0; j < now.size(); ++j) {
      const Contact* previous = history.previous(j, contacts_);
      if (!previous || patches_.patch_of(j) != patches_.patch_of(i)) continue;
      force += previous->weight * previous->normal;
      weight += previous->weight;
    }
    if (weight > 0.0) now[i].normal = force / weight;
  }
}

template <NormalLaw Law>
void ContactForces::load_contact(Contact& contact, const Contact* previous, const Law& law,
                                 const PairMotion& motion, ContactLoad& load,
                                 EnergyLedger& ledger) {
  const GroundParameters& ground = rules_.zones[contact.zone];
  const Slip slip(contact, motion);
  const double w = contact.weight;
  Past past =
      previous ? past_of(contact, *previous, motion) : past_of_new(contact, slip, law, motion);
  if constexpr (Law::kIsPlastic) {
    // On ground that unloads otherwise the force goes on, and with it the dent that it stands for.
    if (previous && previous->zone != contact.zone && previous->normal > 0.0) {
      past.normal = law.initial_state(past.path.before, 0.0, 0.0, previous->normal);
    }
    if (rules_.soil && !previous && past.continuous) {
      past.normal.dent = rules_.soil->dent(contact.place, contact.zone);
    }
  }

  const NormalResponse response = normal_response(contact, past, law);
  contact.normal = response.force;
  contact.dent = response.dent;
  const SpringResponse sliding =
      friction(contact, slip, rules_.stiffness.tangential, motion.duration,
               rules_.slip_grows ? ground.friction_after(slip_) : ground.friction);
  const SpringResponse rolling = rolling_resistance(contact, slip, rules_.rolling[contact.zone],
                                                    motion, ground.rolling_friction);
  if (rules_.slip_grows) {
    const Vec3 trial =
        contact.tangential - rules_.stiffness.tangential * motion.duration * slip.sliding;
    slipped_ +=
        w * rules_.tangential_give * std::max(0.0, trial.norm() - std::sqrt(sliding.squared));
  }
  contact.tangential = sliding.load;
  contact.rolling = rolling.load;

  // Eq. 6: the loads of a point count by its weight.
  const double drop = law.force_drop(contact.point.overlap, contact.normal);
  const double share = slip.closing > 0.0 ? 1.0 : law.unloading_ratio(rules_.stiffness.normal);
  load.impact += 0.5 * w *
                 (share * slip.closing * slip.closing +
                  drop * drop * motion.block.inverse_mass / rules_.stiffness.normal);
  const Vec3 force = w * (contact.normal * contact.point.normal + contact.tangential);
  load.force += force;
  load.torque += slip.arm.cross(force) + w * contact.rolling;
  if (past.continuous && is_event(response)) add_law_event(load, response, contact, motion);

  // With the mean weight of the step. What the forces took beyond these losses and what is stored,
  // because weights, zones, normals or the contacts changed, is booked apart.
  const double mean_weight = 0.5 * (past.weight + w);
  const double stored_by_normal = law.stored_energy(contact.point.overlap, contact.dent);
  const double by_normal =
      mean_weight * (response.work - stored_by_normal +
                     law.stored_energy(std::max(0.0, past.path.before), past.normal.dent));
  const double by_friction = mean_weight * rules_.tangential_give * sliding.loss;
  const double by_rolling = mean_weight * rules_.rolling_give[contact.zone] * rolling.loss;
  contact.stored =
      w * (stored_by_normal + 0.5 * (sliding.squared * rules_.tangential_give +
                                     rolling.squared * rules_.rolling_give[contact.zone]));
  ledger.normal += by_normal;
  ledger.friction += by_friction;
  ledger.rolling += by_rolling;
  ledger.reassigned -= by_normal + by_friction + by_rolling + (contact.stored - past.stored);
}

template <NormalLaw Law>
void ContactForces::end_contact(const Contact& contact, const Law& law, const PairMotion& motion,
                                ContactLoad& load, EnergyLedger& ledger) const {
  const double duration = motion.duration, w = contact.weight;
  const Vec3& n = contact.point.normal;
  const Vec3 velocity = motion.velocity_from(contact.place);
  const double overlap = contact.point.overlap;
  const OverlapPath path{duration, overlap, overlap - velocity.dot(n) * duration,
                         -motion.begin_velocity_at(contact.place).dot(n)};
  double own = 0.0;
  if (path.after <= 0.0) {  // parted; else it slid off and its law never came to an end
    const NormalResponse response =
        law.integrate(path, {contact.normal, contact.dent}, contact.effective_mass);
    if (is_event(response)) add_law_event(load, response, contact, motion);
    const double by_normal = w * (response.work + law.stored_energy(overlap, contact.dent));
    const double by_friction =
        end_of_spring(w, rules_.tangential_give, contact.tangential, velocity, duration);
    const double by_rolling =
        end_of_spring(w, rules_.rolling_give[contact.zone], contact.rolling, motion.spin, duration);
    ledger.normal += by_normal;
    ledger.friction += by_friction;
    ledger.rolling += by_rolling;
    own = by_normal + by_friction + by_rolling;
  }
  ledger.reassigned += contact.stored - own;
}

template <NormalLaw Law>
void ContactForces::shift_overlaps(const std::vector<Law>& laws, const EventLoad& event,
                                   const BodyMotion& block, EnergyLedger& ledger) {
  const Vec3 shift = block.inverse_mass * event.moment;
  const Vec3 turn = block.inverse_inertia_times(event.angular_moment);
  for (Contact& contact : contacts_) {
    const Vec3 moved = shift + turn.cross(contact.place - block.world_from_body.translation);
    const double before = contact.stored;
    const double overlap = contact.point.overlap;
    contact.point.overlap = std::max(0.0, overlap - moved.dot(contact.point.normal));
    // The force stays, and with it what is pressed beyond the dent.
    if constexpr (Law::kIsPlastic) contact.dent += contact.point.overlap - overlap;
    contact.stored = stored_in(contact, laws[contact.zone]);
    ledger.reassigned -= contact.stored - before;
  }
}

template <NormalLaw Law>
double ContactForces::stored_in(const Contact& contact, const Law& law) const {
  return contact.weight *
         (law.stored_energy(contact.point.overlap, contact.dent) +
          0.5 * (contact.tangential.squaredNorm() * rules_.tangential_give +
                 contact.rolling.squaredNorm() * rules_.rolling_give[contact.zone]));
}

void ContactForces::forget_slip(std::uint16_t zone) {
  const double memory = rules_.zones[zone].slip_memory;
  slip_ = memory > 0.0 ? slip_ * std::exp(-apart_ / memory) : 0.0;
  apart_ = 0.0;
}

void ContactForces::add_slip() {
  const double total = weight();
  if (total > 0.0) slip_ += slipped_ / total;
  slipped_ = 0.0;
}

void ContactForces::add_drag(const PairMotion& motion, ContactLoad& load, EnergyLedger& ledger) {
  double lost = 0.0;
  const Vec3 force = drag_->update(contacts_, motion, lost);
  ledger.friction += lost;
  if (contacts_.empty()) return;
  load.force += force;
  load.torque += (drag_->place() - motion.block.world_from_body.translation).cross(force);
  load.torque_on_other -= (drag_->place() - motion.other.world_from_body.translation).cross(force);
}

double ContactForces::mobility(std::span<const double> of_vertices) const {
  double sum = 0.0;
  for (const Contact& contact : contacts_) {
    const std::uint32_t feature = contact.point.block_feature;
    const auto largest = [&](const auto& vertices) {
      double most = 0.0;
      for (const std::uint32_t vertex : vertices) most = std::max(most, of_vertices[vertex]);
      return most;
    };
    sum += contact.weight * (contact.point.kind == ContactKind::kVertexGround ? of_vertices[feature]
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

void ContactForces::leave_dents_in(SoilMemory& soil) const {
  for (const Contact& contact : contacts_) soil.press(contact.place, contact.zone, contact.dent);
}

double ContactForces::stored_energy() const {
  double sum = 0.0;
  for (const Contact& contact : contacts_) sum += contact.stored;
  return sum;
}

void ContactForces::find_deepest() {
  deepest_ = 0;
  for (std::size_t i = 1; i < contacts_.size(); ++i) {
    if (contacts_[i].point.overlap > contacts_[deepest_].point.overlap) deepest_ = i;
  }
}

std::optional<ContactForces::Deepest> ContactForces::deepest() const {
  if (contacts_.empty()) return std::nullopt;
  const Contact& contact = contacts_[deepest_];
  return Deepest{static_cast<std::uint32_t>(contacts_.size()), contact.point.overlap, contact.place,
                 contact.zone};
}

double ContactForces::settled_depth() {
  // A patch carries with its weighted mean overlap: that is the depth of Eq. 2.
  std::vector<double> depth(contacts_.size(), 0.0);
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const ContactPoint& point = contacts_[i].point;
    depth[patches_.patch_of(i)] +=
        contacts_[i].weight * point.overlap * std::max(0.0, point.normal.z());
  }
  return depth.empty() ? 0.0 : *std::max_element(depth.begin(), depth.end());
}

bool ContactForces::keeps_dents() const {
  return rules_.with_laws([]<NormalLaw Law>(const std::vector<Law>&) { return Law::kIsPlastic; });
}

double ContactForces::rest_stiffness() const {
  return rules_.with_laws([&](const auto& laws) {
    double smallest = rules_.stiffness.normal;
    for (const Contact& contact : contacts_) {
      smallest = std::min(smallest, laws[contact.zone].rest_stiffness());
    }
    return smallest;
  });
}

}  // namespace clast::dem_detail
