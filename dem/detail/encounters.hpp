#pragma once
/// Which bodies of a world are near each other or the terrain, and their contacts from step to
/// step.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/parallel.hpp"
#include "dem/detail/actor.hpp"
#include "dem/detail/body_pair.hpp"
#include "dem/detail/near_pairs.hpp"
#include "dem/terrain_surface.hpp"

namespace clast::dem_detail {

/// Two bodies, or a body and the terrain.
struct Encounter {
  /// The terrain's number in a pair of bodies.
  static constexpr std::uint32_t kTerrain = 0xffffffffu;

  std::uint32_t ground;  ///< kTerrain, or the body that takes the ground's place
  std::uint32_t block;
  std::unique_ptr<BodyPair> contacts;

  NearPairs::Pair key() const { return {std::min(ground, block), std::max(ground, block)}; }
  /// True when no body of it has a number from `end` on.
  bool between(std::size_t end) const {
    return block < end && (ground == kTerrain || ground < end);
  }
};

/// All encounters, each kept as long as the two stay near. Loops write only what belongs to one
/// encounter, so that the number of threads changes no bit.
class Encounters {
 public:
  /// @param terrain         none, or it must outlive the encounters
  /// @param between_bodies  rules of two bodies; what they refer to must outlive the encounters
  /// @param on_terrain      rules of a body on the terrain, likewise
  Encounters(const TerrainSurface* terrain, const BodyPair::Rules& between_bodies,
             const BodyPair::Rules& on_terrain)
      : terrain_(terrain), between_bodies_(between_bodies), on_terrain_(on_terrain) {}

  /// How far bounding spheres may be apart to be listed follows from the bodies that move.
  void set_slack(std::span<const Actor> actors);
  /// Lists those who are near anew where that is due. What is no longer near is ended.
  void refresh(std::span<const Actor> actors);
  /// Contacts of all at the places that the actors have moved to in a step of `duration`.
  void update(std::span<const Actor> actors, double duration, ThreadTeam& team);
  /// The same, without a step, where a body takes part for the first time.
  /// @param known  bodies below this number take part already
  void begin(std::span<const Actor> actors, std::size_t known);
  /// Ends the contacts of a body that leaves the world.
  void part(std::uint32_t body, std::span<const Actor> actors);

  /// First a body's with the terrain, then by the other body; sorted by the smaller number.
  std::span<const Encounter> all() const { return encounters_; }
  /// Places in `all` of those that a body takes part in, ascending.
  std::span<const std::uint32_t> of(std::size_t body) const { return of_body_[body]; }

  /// What contacts dissipated and moved about, also those that are no more, J.
  EnergyLedger losses() const;
  double stored_energy() const;  ///< J
  std::uint64_t lists_made() const { return lists_made_; }

 private:
  const BodyMotion& motion_of(std::uint32_t body, std::span<const Actor> actors) const {
    return body == Encounter::kTerrain ? still_ground_ : actors[body].motion;
  }
  std::vector<NearPairs::Pair> near_ones(std::span<const Actor> actors) const;
  Encounter encounter(std::uint32_t first, std::uint32_t second,
                      std::span<const Actor> actors) const;

  const TerrainSurface* terrain_;
  BodyPair::Rules between_bodies_, on_terrain_;
  BodyMotion still_ground_;
  NearPairs near_;
  double slack_ = 0.0;  ///< of the list of near pairs, m
  std::vector<BoundingSphere> spheres_;
  std::vector<Encounter> encounters_;
  std::vector<std::vector<std::uint32_t>> of_body_;
  EnergyLedger parted_;  ///< losses of those that are no more
  std::uint64_t lists_made_ = 0;
};

}  // namespace clast::dem_detail
