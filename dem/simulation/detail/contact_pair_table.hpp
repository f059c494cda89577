#pragma once
/// Contact pairs of a simulation: two bodies that are near each other, or a body near the terrain,
/// with their contacts.
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

/// Pair of two bodies, or of a body and the terrain.
struct ContactPair {
  /// Index of the terrain in a pair.
  static constexpr std::uint32_t kTerrain = 0xffffffffu;

  std::uint32_t reference;  ///< index of the reference body, or kTerrain
  std::uint32_t block;
  std::unique_ptr<PairContactState> contacts;
  // Kept here, where they are read for many pairs that do nothing:
  bool has_load = false;  ///< true if contact forces act
  /// Value of `displacement_bound` below which contact is impossible, m.
  double separated_until = -1e300;
  double arm = 0.0;  ///< largest distance of a block point from the centre of the reference body, m
  double time_since_update = 0.0;  ///< time without an update of the contacts, s

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(*contacts, has_load, separated_until, arm, time_since_update);
  }

  BroadPhase::Pair key() const { return {std::min(reference, block), std::max(reference, block)}; }
  /// True if the indices of the bodies of the pair are below `end`. The terrain is always included.
  bool has_bodies_below(std::size_t end) const {
    return block < end && (reference == kTerrain || reference < end);
  }
};

/// Table of all contact pairs of a simulation. A pair is kept while its bodies are near each other.
/// Results do not depend on the number of threads.
class ContactPairTable {
 public:
  /// Makes an empty table; all arguments must outlive it.
  /// @param terrain  terrain of the world, or null
  /// @param between_bodies  contact model of two bodies
  /// @param on_confining_walls  contact model of a wall and a confined body
  /// @param on_terrain  contact model of a body on the terrain
  ContactPairTable(const TerrainSurface* terrain, const ContactModel& between_bodies,
                   const ContactModel& on_confining_walls, const ContactModel& on_terrain)
      : terrain_(terrain),
        between_bodies_(between_bodies),
        on_confining_walls_(on_confining_walls),
        on_terrain_(on_terrain) {}

  /// Computes the slack of the broad phase from the sizes of the moving bodies.
  void update_slack(std::span<const WorldBody> bodies);
  /// Runs the broad phase if necessary. Pairs whose bodies are no longer near are removed.
  /// @param moved  bodies that may have moved since the last call; default: all
  void update_pairs(std::span<const WorldBody> bodies,
                    std::optional<std::span<const std::uint32_t>> moved = {});
  /// Lists the active pairs. Call it when the moving bodies or the pairs have changed.
  void update_active_list(std::span<const WorldBody> bodies);
  /// Computes contacts and loads of the active pairs at the poses after a step of `duration`. The
  /// loads of other pairs do not change.
  void update_contacts(std::span<const WorldBody> bodies, double duration, ThreadPool& team);
  /// Computes contacts and loads of the pairs for which `is_new` is true, without a step.
  void begin_contacts(std::span<const WorldBody> bodies,
                      const std::function<bool(const ContactPair&)>& is_new);
  /// Requests a broad phase at the next `update_pairs`. Called if the set of movable bodies has
  /// changed.
  void request_broad_phase() { broad_phase_ = {}; }
  /// Stores residual indentations of bodies that fell asleep or left the ground or the world.
  void store_indentations(std::span<const WorldBody> bodies, SoilMemory& soil);
  /// Ends the contacts of a body that leaves the world.
  void end_contacts_of(std::uint32_t body, std::span<const WorldBody> bodies);

  /// Returns the relative displacement before which the bodies of a pair cannot touch, m.
  double clearance(const ContactPair& pair, std::span<const WorldBody> bodies) const {
    return pair.contacts->clearance(motion_of(pair.reference, bodies),
                                    motion_of(pair.block, bodies));
  }
  /// Returns the distance that a body may move before it can touch a body with which it has no pair
  /// yet, m.
  double remaining_displacement(std::size_t body, const Vec3& centre) const {
    return broad_phase_.remaining_displacement(body, centre, slack_);
  }

  /// Returns all pairs, sorted by body index.
  std::span<const ContactPair> all_pairs() const { return pairs_; }
  /// Returns the ascending indices of the pairs that were active at the last `update_active_list`.
  std::span<const std::uint32_t> active_pairs() const { return active_; }
  /// Returns the ascending indices of the pairs of a body.
  std::span<const std::uint32_t> pairs_of(std::size_t body) const { return of_body_[body]; }

  /// Energies lost in the contacts of all pairs, including removed pairs, J.
  struct ContactLosses {
    EnergyBalance on_ground, between_bodies;
    EnergyBalance& of(const ContactPair& pair) {
      return pair.reference == ContactPair::kTerrain ? on_ground : between_bodies;
    }
    EnergyBalance sum() const {
      EnergyBalance sum = on_ground;
      return sum += between_bodies;
    }
  };
  ContactLosses losses() const;
  double stored_energy() const;  ///< J
  /// True if at least one body of the pair is moving.
  static bool is_active(const ContactPair& pair, std::span<const WorldBody> bodies) {
    return !bodies[pair.block].is_idle() ||
           (pair.reference != ContactPair::kTerrain && !bodies[pair.reference].is_idle());
  }
  std::uint64_t broad_phase_count() const { return broad_phase_count_; }

  /// Serialises the state that determines the future motion.
  /// @param bodies  bodies to which the pairs refer
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
  void update_contacts(ContactPair& pair, std::span<const WorldBody> bodies, double duration);
  /// Returns an upper bound of the accumulated displacement of any block point relative to the
  /// reference body, m. Only differences between two times are meaningful.
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
  ContactLosses ended_;  ///< energies lost in removed pairs
  std::uint64_t broad_phase_count_ = 0;
};

}  // namespace clast::dem_detail
