#include "dem/simulation/detail/contact_pairs.hpp"

#include <algorithm>
#include <utility>

#include "dem/surface/terrain_impl.hpp"

namespace clast::dem_detail {
namespace {

/// Bounding spheres this far apart are listed, as a share of the mean radius of the bodies that
/// move: the list then lasts for tens of steps of a falling block.
constexpr double kSlackShare = 0.15;
/// Pairs that a thread takes at a time.
constexpr std::size_t kPairsAtATime = 8;

/// A form touches what it holds, and nothing else.
bool may_touch(const BroadPhase::Pair& pair, std::span<const WorldBody> bodies) {
  const std::optional<HeldBodies>&first = bodies[pair[0]].holds, &second = bodies[pair[1]].holds;
  return (!first || first->has(pair[1])) && (!second || second->has(pair[0]));
}

}  // namespace

void ContactPairs::set_slack(std::span<const WorldBody> bodies) {
  double radii = 0.0, moving = 0.0;
  for (const WorldBody& body : bodies) {
    if (body.fixed) continue;
    radii += body.shape->radius;
    moving += 1.0;
  }
  slack_ = kSlackShare * (moving > 0.0 ? radii / moving : 1.0);
}

ContactPair ContactPairs::contact_pair(std::uint32_t first, std::uint32_t second,
                                       std::span<const WorldBody> bodies) const {
  const Shape& a = *bodies[first].shape;
  if (second == ContactPair::kTerrain) {
    return {second, first,
            std::make_unique<BodyPair>(terrain_->impl().surface, a.surface, a.body.size(),
                                       on_terrain_)};
  }
  const Shape& b = *bodies[second].shape;
  const double size = std::min(a.body.size(), b.body.size());
  const bool with_form = bodies[first].holds || bodies[second].holds;
  const ContactRules& rules = with_form ? on_forms_ : between_bodies_;
  if (first_is_reference(a.surface, b.surface)) {
    return {first, second, std::make_unique<BodyPair>(a.surface, b.surface, size, rules)};
  }
  return {second, first, std::make_unique<BodyPair>(b.surface, a.surface, size, rules)};
}

std::vector<BroadPhase::Pair> ContactPairs::pairs_to_keep(std::span<const WorldBody> bodies) const {
  std::vector<BroadPhase::Pair> wanted;
  for (const BroadPhase::Pair& pair : broad_phase_.pairs()) {
    if (bodies[pair[0]].gone || bodies[pair[1]].gone || !may_touch(pair, bodies)) continue;
    wanted.push_back(pair);
  }
  if (terrain_) {
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      if (!bodies[i].still()) wanted.push_back({i, ContactPair::kTerrain});
    }
    std::sort(wanted.begin(), wanted.end());
  }
  return wanted;
}

void ContactPairs::refresh(std::span<const WorldBody> bodies,
                           std::optional<std::span<const std::uint32_t>> moved) {
  const auto place = [&](std::size_t i) {
    const WorldBody& body = bodies[i];
    spheres_[i] = {body.motion.world_from_body.translation, body.shape->radius, body.still()};
  };
  if (moved) {
    for (const std::uint32_t i : *moved) place(i);
  } else {
    spheres_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) place(i);
  }
  if (!broad_phase_.refresh(spheres_, slack_, moved)) return;
  ++broad_phases_;
  // Both lists are sorted: pairs in both go on, those no longer near end.
  std::vector<ContactPair> known = std::exchange(pairs_, {});
  auto old = known.begin();
  const auto end_until = [&](const BroadPhase::Pair& key) {
    for (; old != known.end() && old->key() < key; ++old) {
      old->contacts->end_contacts(motion_of(old->reference, bodies), motion_of(old->block, bodies));
      ended_.of(*old) += old->contacts->ledger();
    }
  };
  for (const BroadPhase::Pair& pair : pairs_to_keep(bodies)) {
    end_until(pair);
    if (old != known.end() && old->key() == pair) {
      pairs_.push_back(std::move(*old++));
    } else {
      pairs_.push_back(contact_pair(pair[0], pair[1], bodies));
    }
  }
  end_until({ContactPair::kTerrain, ContactPair::kTerrain});
  list_pairs_of_bodies(bodies.size());
}

void ContactPairs::list_pairs_of_bodies(std::size_t bodies) {
  of_body_.assign(bodies, {});
  for (std::uint32_t e = 0; e < pairs_.size(); ++e) {
    if (pairs_[e].reference != ContactPair::kTerrain) of_body_[pairs_[e].reference].push_back(e);
    of_body_[pairs_[e].block].push_back(e);
  }
}

void ContactPairs::list_active(std::span<const WorldBody> bodies) {
  active_.clear();
  for (std::uint32_t e = 0; e < pairs_.size(); ++e) {
    if (is_active(pairs_[e], bodies)) active_.push_back(e);
  }
}

void ContactPairs::update(std::span<const WorldBody> bodies, double duration, ThreadPool& team) {
  team.run(active_.size(), kPairsAtATime, [&](std::size_t i) {
    ContactPair& pair = pairs_[active_[i]];
    if (!pair.loads && way(pair, bodies) < pair.asleep_until) {
      pair.waited += duration;
    } else {
      update(pair, bodies, duration);
    }
  });
}

void ContactPairs::begin(std::span<const WorldBody> bodies,
                         const std::function<bool(const ContactPair&)>& is_new) {
  for (ContactPair& pair : pairs_) {
    if (is_new(pair)) update(pair, bodies, 0.0);
  }
}

void ContactPairs::update(ContactPair& pair, std::span<const WorldBody> bodies, double duration) {
  const BodyMotion& reference = motion_of(pair.reference, bodies);
  const BodyMotion& block = motion_of(pair.block, bodies);
  pair.contacts->wait(std::exchange(pair.waited, 0.0));
  const ContactLoad& load = pair.contacts->update(reference, block, duration);
  pair.loads = pair.contacts->touching() || load.event;
  if (pair.loads) return;
  if (pair.reference != ContactPair::kTerrain) {
    pair.arm = (block.world_from_body.translation - reference.world_from_body.translation).norm() +
               bodies[pair.block].shape->radius;
  }
  pair.asleep_until = way(pair, bodies) + pair.contacts->clearance(reference, block);
}

double ContactPairs::way(const ContactPair& pair, std::span<const WorldBody> bodies) {
  const WorldBody& block = bodies[pair.block];
  const double of_block = block.way + block.turn * block.shape->radius;
  if (pair.reference == ContactPair::kTerrain) return of_block;
  const WorldBody& reference = bodies[pair.reference];
  return of_block + reference.way + reference.turn * pair.arm;
}

void ContactPairs::end_contacts_of(std::uint32_t body, std::span<const WorldBody> bodies) {
  for (const std::uint32_t e : of_body_[body]) {
    const ContactPair& pair = pairs_[e];
    pair.contacts->end_contacts(motion_of(pair.reference, bodies), motion_of(pair.block, bodies));
  }
  list_anew();  // without it
}

void ContactPairs::remember_dents(std::span<const WorldBody> bodies, SoilMemory& soil) {
  for (ContactPair& pair : pairs_) {
    if (pair.reference != ContactPair::kTerrain) continue;
    pair.contacts->remember_dents(bodies[pair.block].idle(), soil);
  }
}

ContactPairs::Losses ContactPairs::losses() const {
  Losses losses = ended_;
  for (const ContactPair& pair : pairs_) losses.of(pair) += pair.contacts->ledger();
  return losses;
}

double ContactPairs::stored_energy() const {
  double sum = 0.0;
  for (const ContactPair& pair : pairs_) sum += pair.contacts->stored_energy();
  return sum;
}

}  // namespace clast::dem_detail
