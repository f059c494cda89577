#include "dem/simulation/detail/contact_pair_table.hpp"

#include <algorithm>
#include <utility>

#include "dem/surface/terrain_impl.hpp"

namespace clast::dem_detail {
namespace {

/// Slack of the broad phase, as a fraction of the mean radius of the moving bodies. The list then
/// lasts for tens of steps of a falling block.
constexpr double kSlackFraction = 0.15;
/// Number of pairs that a thread takes at a time.
constexpr std::size_t kPairsAtATime = 8;

/// True if two bodies may touch; a confining wall touches only the bodies that it holds.
bool may_touch(const BroadPhase::Pair& pair, std::span<const WorldBody> bodies) {
  const std::optional<ConfinedBodyRange>&first = bodies[pair[0]].confined,
        &second = bodies[pair[1]].confined;
  return (!first || first->contains(pair[1])) && (!second || second->contains(pair[0]));
}

}  // namespace

void ContactPairTable::update_slack(std::span<const WorldBody> bodies) {
  double radii = 0.0, moving = 0.0;
  for (const WorldBody& body : bodies) {
    if (body.fixed) continue;
    radii += body.shape->radius;
    moving += 1.0;
  }
  slack_ = kSlackFraction * (moving > 0.0 ? radii / moving : 1.0);
}

ContactPair ContactPairTable::make_contact_pair(std::uint32_t first, std::uint32_t second,
                                                std::span<const WorldBody> bodies) const {
  const BodyShape& a = *bodies[first].shape;
  if (second == ContactPair::kTerrain) {
    return {second, first,
            std::make_unique<PairContactState>(terrain_->impl().surface, a.surface, a.body.size(),
                                               on_terrain_)};
  }
  const BodyShape& b = *bodies[second].shape;
  const double size = std::min(a.body.size(), b.body.size());
  const bool with_form = bodies[first].confined || bodies[second].confined;
  const ContactModel& model = with_form ? on_confining_walls_ : between_bodies_;
  if (is_reference_body(a.surface, b.surface)) {
    return {first, second, std::make_unique<PairContactState>(a.surface, b.surface, size, model)};
  }
  return {second, first, std::make_unique<PairContactState>(b.surface, a.surface, size, model)};
}

std::vector<BroadPhase::Pair> ContactPairTable::find_retained_pairs(
    std::span<const WorldBody> bodies) const {
  std::vector<BroadPhase::Pair> wanted;
  for (const BroadPhase::Pair& pair : broad_phase_.pairs()) {
    if (bodies[pair[0]].inactive || bodies[pair[1]].inactive || !may_touch(pair, bodies)) continue;
    wanted.push_back(pair);
  }
  if (terrain_) {
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      if (!bodies[i].is_immobile()) wanted.push_back({i, ContactPair::kTerrain});
    }
    std::sort(wanted.begin(), wanted.end());
  }
  return wanted;
}

void ContactPairTable::update_pairs(std::span<const WorldBody> bodies,
                                    std::optional<std::span<const std::uint32_t>> moved) {
  const auto position = [&](std::size_t i) {
    const WorldBody& body = bodies[i];
    spheres_[i] = {body.motion.world_from_body.translation, body.shape->radius, body.is_immobile()};
  };
  if (moved) {
    for (const std::uint32_t i : *moved) position(i);
  } else {
    spheres_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) position(i);
  }
  if (!broad_phase_.update_pairs(spheres_, slack_, moved)) return;
  ++broad_phase_count_;
  // Both lists are sorted. Pairs in both are kept; the contacts of others end.
  std::vector<ContactPair> known = std::exchange(pairs_, {});
  auto old = known.begin();
  const auto end_until = [&](const BroadPhase::Pair& key) {
    for (; old != known.end() && old->key() < key; ++old) {
      old->contacts->end_contacts(motion_of(old->reference, bodies), motion_of(old->block, bodies));
      ended_.of(*old) += old->contacts->energy_balance();
    }
  };
  for (const BroadPhase::Pair& pair : find_retained_pairs(bodies)) {
    end_until(pair);
    if (old != known.end() && old->key() == pair) {
      pairs_.push_back(std::move(*old++));
    } else {
      pairs_.push_back(make_contact_pair(pair[0], pair[1], bodies));
    }
  }
  end_until({ContactPair::kTerrain, ContactPair::kTerrain});
  index_pairs_by_body(bodies.size());
}

void ContactPairTable::index_pairs_by_body(std::size_t bodies) {
  of_body_.assign(bodies, {});
  for (std::uint32_t e = 0; e < pairs_.size(); ++e) {
    if (pairs_[e].reference != ContactPair::kTerrain) of_body_[pairs_[e].reference].push_back(e);
    of_body_[pairs_[e].block].push_back(e);
  }
}

void ContactPairTable::update_active_list(std::span<const WorldBody> bodies) {
  active_.clear();
  for (std::uint32_t e = 0; e < pairs_.size(); ++e) {
    if (is_active(pairs_[e], bodies)) active_.push_back(e);
  }
}

void ContactPairTable::update_contacts(std::span<const WorldBody> bodies, double duration,
                                       ThreadPool& team) {
  team.run(active_.size(), kPairsAtATime, [&](std::size_t i) {
    ContactPair& pair = pairs_[active_[i]];
    if (!pair.has_load && displacement_bound(pair, bodies) < pair.separated_until) {
      pair.time_since_update += duration;
    } else {
      update_contacts(pair, bodies, duration);
    }
  });
}

void ContactPairTable::begin_contacts(std::span<const WorldBody> bodies,
                                      const std::function<bool(const ContactPair&)>& is_new) {
  for (ContactPair& pair : pairs_) {
    if (is_new(pair)) update_contacts(pair, bodies, 0.0);
  }
}

void ContactPairTable::update_contacts(ContactPair& pair, std::span<const WorldBody> bodies,
                                       double duration) {
  const BodyMotion& reference = motion_of(pair.reference, bodies);
  const BodyMotion& block = motion_of(pair.block, bodies);
  pair.contacts->advance_time(std::exchange(pair.time_since_update, 0.0));
  const ContactLoad& load = pair.contacts->update_loads(reference, block, duration);
  pair.has_load = pair.contacts->is_touching() || load.correction;
  if (pair.has_load) return;
  if (pair.reference != ContactPair::kTerrain) {
    pair.arm = (block.world_from_body.translation - reference.world_from_body.translation).norm() +
               bodies[pair.block].shape->radius;
  }
  pair.separated_until =
      displacement_bound(pair, bodies) + pair.contacts->clearance(reference, block);
}

double ContactPairTable::displacement_bound(const ContactPair& pair,
                                            std::span<const WorldBody> bodies) {
  const WorldBody& block = bodies[pair.block];
  const double of_block = block.path_length + block.rotation_path * block.shape->radius;
  if (pair.reference == ContactPair::kTerrain) return of_block;
  const WorldBody& reference = bodies[pair.reference];
  return of_block + reference.path_length + reference.rotation_path * pair.arm;
}

void ContactPairTable::end_contacts_of(std::uint32_t body, std::span<const WorldBody> bodies) {
  for (const std::uint32_t e : of_body_[body]) {
    const ContactPair& pair = pairs_[e];
    pair.contacts->end_contacts(motion_of(pair.reference, bodies), motion_of(pair.block, bodies));
  }
  request_broad_phase();  // without the removed body
}

void ContactPairTable::store_indentations(std::span<const WorldBody> bodies, SoilMemory& soil) {
  for (ContactPair& pair : pairs_) {
    if (pair.reference != ContactPair::kTerrain) continue;
    pair.contacts->store_indentations(bodies[pair.block].is_idle(), soil);
  }
}

ContactPairTable::ContactLosses ContactPairTable::losses() const {
  ContactLosses losses = ended_;
  for (const ContactPair& pair : pairs_) losses.of(pair) += pair.contacts->energy_balance();
  return losses;
}

double ContactPairTable::stored_energy() const {
  double sum = 0.0;
  for (const ContactPair& pair : pairs_) sum += pair.contacts->stored_energy();
  return sum;
}

}  // namespace clast::dem_detail
