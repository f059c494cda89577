#pragma once
/// The contact pairs of a world: bodies that the broad phase finds near each other or the terrain,
/// with their contacts from step to step.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/parallel.hpp"
#include "dem/contact/pair_contact_state.hpp"
#include "dem/search/broad_phase.hpp"
#include "dem/simulation/detail/world_body.hpp"
#include "dem/surface/terrain_surface.hpp"

namespace clast::dem_detail {

/// Two bodies, or a body and the terrain.
struct ContactPair {
  /// The terrain's number in a pair of bodies.
  static constexpr std::uint32_t kTerrain = 0xffffffffu;

  std::uint32_t reference;  ///< kTerrain, or the body in whose frame contacts are searched
  std::uint32_t block;
  std::unique_ptr<PairContactState> contacts;
  // Kept here, where they are read for many pairs that do nothing:
  bool has_load = false;            ///< do the contacts do anything to the two?
  double separated_until = -1e300;  ///< `displacement_bound` before which they cannot touch, m
  double arm = 0.0;  ///< farthest that the block reached from the reference's centre, m
  double time_since_update = 0.0;  ///< time since the last update, s

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(*contacts, has_load, separated_until, arm, time_since_update);
  }

  BroadPhase::Pair key() const { return {std::min(reference, block), std::max(reference, block)}; }
  /// True when no body of it has a number from `end` on.
  bool has_bodies_below(std::size_t end) const {
    return block < end && (reference == kTerrain || reference < end);
  }
};

/// All pairs, each kept as long as the two stay near. Loops write only what belongs to one pair, so
/// that the number of threads changes no bit.
class ContactPairTable {
 public:
  /// @param terrain         none, or it must outlive the pairs
  /// @param between_bodies  rules of two bodies; what they refer to must outlive the pairs
  /// @param on_confining_walls        rules of a form and a body that it holds, likewise
  /// @param on_terrain      rules of a body on the terrain, likewise
  ContactPairTable(const TerrainSurface* terrain, const ContactModel& between_bodies,
                   const ContactModel& on_confining_walls, const ContactModel& on_terrain)
      : terrain_(terrain),
        between_bodies_(between_bodies),
        on_confining_walls_(on_confining_walls),
        on_terrain_(on_terrain) {}

  /// How far bounding spheres may be apart to be listed follows from the bodies that move.
  void update_slack(std::span<const WorldBody> bodies);
  /// Runs the broad phase where that is due, and ends pairs that are no longer near.
  /// @param moved  bodies that may have moved since the last call; none given: all
  void update_pairs(std::span<const WorldBody> bodies,
                    std::optional<std::span<const std::uint32_t>> moved = {});
  /// Lists the pairs that take part in the motion; to be called whenever the set of moving bodies
  /// or the list of pairs has changed.
  void update_active_list(std::span<const WorldBody> bodies);
  /// Runs the narrow phase and the contact law of the active pairs at the places that the bodies
  /// have moved to in a step of `duration`; the loads of all others stay.
  void update(std::span<const WorldBody> bodies, double duration, ThreadPool& team);
  /// The same, without a step, for pairs that are new.
  void begin_contacts(std::span<const WorldBody> bodies,
                      const std::function<bool(const ContactPair&)>& is_new);
  /// Has the broad phase run at the next `update_pairs`: the bodies that may move are other ones.
  void request_broad_phase() { broad_phase_ = {}; }
  /// Lets the soil remember the dents of bodies that have parted from the ground, fallen asleep or
  /// left the world.
  void store_indentations(std::span<const WorldBody> bodies, SoilMemory& soil);
  /// Ends the contacts of a body that leaves the world.
  void end_contacts_of(std::uint32_t body, std::span<const WorldBody> bodies);

  /// How far the bodies of a pair may move against each other before they can touch, m.
  double clearance(const ContactPair& pair, std::span<const WorldBody> bodies) const {
    return pair.contacts->clearance(motion_of(pair.reference, bodies),
                                    motion_of(pair.block, bodies));
  }
  /// How far a body may move before it can touch one with which it makes no pair, m.
  double remaining_displacement(std::size_t body, const Vec3& centre) const {
    return broad_phase_.remaining_displacement(body, centre, slack_);
  }

  /// First a body's with the terrain, then by the other body; sorted by the smaller number.
  std::span<const ContactPair> all_pairs() const { return pairs_; }
  /// Places in `all` of those that take part in the motion, by the last `update_active_list`;
  /// ascending.
  std::span<const std::uint32_t> active_pairs() const { return active_; }
  /// Places in `all` of the pairs of a body, ascending.
  std::span<const std::uint32_t> pairs_of(std::size_t body) const { return of_body_[body]; }

  /// What contacts dissipated or reassigned, also those that have ended, J.
  struct Losses {
    EnergyBalance on_ground, between_bodies;
    EnergyBalance& of(const ContactPair& pair) {
      return pair.reference == ContactPair::kTerrain ? on_ground : between_bodies;
    }
    EnergyBalance sum() const {
      EnergyBalance sum = on_ground;
      return sum += between_bodies;
    }
  };
  Losses losses() const;
  double stored_energy() const;  ///< J
  /// Has the pair a body that takes part in the motion?
  static bool is_active(const ContactPair& pair, std::span<const WorldBody> bodies) {
    return !bodies[pair.block].is_idle() ||
           (pair.reference != ContactPair::kTerrain && !bodies[pair.reference].is_idle());
  }
  std::uint64_t broad_phase_count() const { return broad_phase_count_; }

  /// All that the motion to come depends on.
  /// @param bodies  those of the pairs
  template <class Bytes>
  void serialize(Bytes& bytes, std::span<const WorldBody> bodies) {
    std::vector<BroadPhase::Pair> keys;
    for (const ContactPair& pair : pairs_) keys.push_back(pair.key());
    bytes(broad_phase_, slack_, keys, ended_.on_ground, ended_.between_bodies, broad_phase_count_);
    if constexpr (Bytes::kReads) {
      pairs_.clear();
      for (const BroadPhase::Pair& key : keys) {
        pairs_.push_back(make_contact_pair(key[0], key[1], bodies));
      }
      index_pairs_by_body(bodies.size());
    }
    for (ContactPair& pair : pairs_) bytes(pair);
  }

 private:
  const BodyMotion& motion_of(std::uint32_t body, std::span<const WorldBody> bodies) const {
    return body == ContactPair::kTerrain ? still_ground_ : bodies[body].motion;
  }
  void update(ContactPair& pair, std::span<const WorldBody> bodies, double duration);
  /// Bounds how far any point of the block has moved as the reference sees it, m: only its growth
  /// means something.
  static double displacement_bound(const ContactPair& pair, std::span<const WorldBody> bodies);
  std::vector<BroadPhase::Pair> find_retained_pairs(std::span<const WorldBody> bodies) const;
  ContactPair make_contact_pair(std::uint32_t first, std::uint32_t second,
                                std::span<const WorldBody> bodies) const;
  void index_pairs_by_body(std::size_t bodies);

  const TerrainSurface* terrain_;
  ContactModel between_bodies_, on_confining_walls_, on_terrain_;
  BodyMotion still_ground_;
  BroadPhase broad_phase_;
  double slack_ = 0.0;  ///< of the broad phase, m
  std::vector<BoundingSphere> spheres_;
  std::vector<ContactPair> pairs_;
  std::vector<std::uint32_t> active_;
  std::vector<std::vector<std::uint32_t>> of_body_;
  Losses ended_;  ///< of pairs that have ended
  std::uint64_t broad_phase_count_ = 0;
};

}  // namespace clast::dem_detail
