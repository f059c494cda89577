#include "dem/detail/encounters.hpp"

#include <algorithm>
#include <utility>

#include "dem/detail/terrain_impl.hpp"

namespace clast::dem_detail {
namespace {

/// Bounding spheres this far apart are listed, as a share of the mean radius of the bodies that
/// move: the list then lasts for tens of steps of a falling block.
constexpr double kSlackShare = 0.15;
/// Pairs handed to a thread at a time.
constexpr std::size_t kPairsAtATime = 8;

}  // namespace

void Encounters::set_slack(std::span<const Actor> actors) {
  double radii = 0.0, moving = 0.0;
  for (const Actor& actor : actors) {
    if (actor.fixed) continue;
    radii += actor.shape->radius;
    moving += 1.0;
  }
  slack_ = kSlackShare * (moving > 0.0 ? radii / moving : 1.0);
}

Encounter Encounters::encounter(std::uint32_t first, std::uint32_t second,
                                std::span<const Actor> actors) const {
  const Shape& a = *actors[first].shape;
  if (second == Encounter::kTerrain) {
    return {second, first,
            std::make_unique<BodyPair>(terrain_->impl().surface, a.surface, a.radius, a.body.size(),
                                       on_terrain_)};
  }
  const Shape& b = *actors[second].shape;
  const double size = std::min(a.body.size(), b.body.size());
  if (takes_grounds_place(a.surface, a.radius, b.surface, b.radius)) {
    return {first, second,
            std::make_unique<BodyPair>(a.surface, b.surface, b.radius, size, between_bodies_)};
  }
  return {second, first,
          std::make_unique<BodyPair>(b.surface, a.surface, a.radius, size, between_bodies_)};
}

std::vector<NearPairs::Pair> Encounters::near_ones(std::span<const Actor> actors) const {
  std::vector<NearPairs::Pair> wanted;
  for (const NearPairs::Pair& pair : near_.pairs()) {
    if (!actors[pair[0]].left && !actors[pair[1]].left) wanted.push_back(pair);
  }
  if (terrain_) {
    for (std::uint32_t i = 0; i < actors.size(); ++i) {
      if (!actors[i].still()) wanted.push_back({i, Encounter::kTerrain});
    }
    std::sort(wanted.begin(), wanted.end());
  }
  return wanted;
}

void Encounters::refresh(std::span<const Actor> actors) {
  spheres_.clear();
  for (const Actor& actor : actors) {
    spheres_.push_back(
        {actor.motion.world_from_body.translation, actor.shape->radius, actor.still()});
  }
  if (!near_.refresh(spheres_, slack_)) return;
  ++lists_made_;
  // Both lists are sorted: what is in both goes on, what is no longer near is closed.
  std::vector<Encounter> known = std::exchange(encounters_, {});
  auto old = known.begin();
  const auto close_until = [&](const NearPairs::Pair& key) {
    for (; old != known.end() && old->key() < key; ++old) {
      old->contacts->part(motion_of(old->ground, actors), motion_of(old->block, actors));
      parted_ += old->contacts->ledger();
    }
  };
  for (const NearPairs::Pair& pair : near_ones(actors)) {
    close_until(pair);
    if (old != known.end() && old->key() == pair) {
      encounters_.push_back(std::move(*old++));
    } else {
      encounters_.push_back(encounter(pair[0], pair[1], actors));
    }
  }
  close_until({Encounter::kTerrain, Encounter::kTerrain});
  of_body_.assign(actors.size(), {});
  for (std::uint32_t e = 0; e < encounters_.size(); ++e) {
    if (encounters_[e].ground != Encounter::kTerrain) of_body_[encounters_[e].ground].push_back(e);
    of_body_[encounters_[e].block].push_back(e);
  }
}

void Encounters::update(std::span<const Actor> actors, double duration, ThreadTeam& team) {
  team.run(encounters_.size(), kPairsAtATime, [&](std::size_t e) {
    const Encounter& pair = encounters_[e];
    pair.contacts->update(motion_of(pair.ground, actors), motion_of(pair.block, actors), duration);
  });
}

void Encounters::begin(std::span<const Actor> actors, std::size_t known) {
  for (const Encounter& pair : encounters_) {
    if (pair.between(known)) continue;
    pair.contacts->update(motion_of(pair.ground, actors), motion_of(pair.block, actors), 0.0);
  }
}

void Encounters::part(std::uint32_t body, std::span<const Actor> actors) {
  for (const std::uint32_t e : of_body_[body]) {
    const Encounter& pair = encounters_[e];
    pair.contacts->part(motion_of(pair.ground, actors), motion_of(pair.block, actors));
  }
  near_ = {};  // who is near whom is listed anew without it
}

EnergyLedger Encounters::losses() const {
  EnergyLedger sum = parted_;
  for (const Encounter& pair : encounters_) sum += pair.contacts->ledger();
  return sum;
}

double Encounters::stored_energy() const {
  double sum = 0.0;
  for (const Encounter& pair : encounters_) sum += pair.contacts->stored_energy();
  return sum;
}

}  // namespace clast::dem_detail
