#pragma once
/// Many blocks on one terrain, or without one, that hit each other.
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "dem/simulation/energy_sample.hpp"
#include "dem/simulation/release.hpp"

namespace clast {

class ByteReader;
class ByteWriter;

/// Everything about a world that is not bodies or terrain.
struct WorldSettings : MotionSettings {
  GroundParameters between_bodies;  ///< what two bodies do to each other
  GroundParameters on_confining_walls{.friction =
                                          0.0};  ///< what a form and a body that it holds do
  /// A body stays where it is when it was in contact and had less than ten times `rest_energy` for
  /// twice `sleep_duration`, s, and its mean places in the first and the second half differ by no
  /// more than this share of S. It falls asleep when all that touches it stays too: it is at rest
  /// then, costs nothing and keeps its place until a body that does not stay touches it, or another
  /// one asleep that it touches. 0: none ever sleeps.
  double sleep_drift = 1e-3;
  double sleep_duration = 0.5;
  unsigned threads = 1;  ///< 0: one per core; changes no bit of the result

  void check() const;  ///< throws InputError naming the field and its value
};

/// Counts of bodies' contacts, now and over the run.
struct WorldStatistics {
  std::uint64_t steps = 0;
  std::uint64_t broad_phase_count = 0;  ///< how often near bodies were searched again
  std::uint64_t pair_steps = 0;         ///< touching pairs, summed over the steps
  std::size_t near_pairs = 0;  ///< now, of the broad phase: bounding spheres overlap or soon might
  std::size_t searched_pairs = 0;  ///< now, of the narrow phase: near enough to search for contacts
  std::size_t touching_pairs = 0;  ///< now
  std::size_t active_pairs = 0;    ///< now, near pairs with a body that is not asleep
  std::size_t sleeping_bodies = 0;  ///< now
  std::size_t contact_points = 0;   ///< now
  double max_overlap = 0.0;         ///< now, m
};

/// Sees how a body moved in a step; called from any of the world's threads, for different bodies at
/// a time.
using BodyObserver = std::function<void(std::size_t body, const MotionStep&)>;

/// Bodies in motion. Every body has a shape out of a common list, a state, and may be fixed: then
/// nothing moves it until it is freed. Bodies and terrain touch by the same contact search and the
/// same law.
///
/// Invariant: states, contacts and energies always belong to one instant, `time()`.
class World {
 public:
  /// @param shapes  the bodies' shapes and masses; many bodies may share one
  /// @throws InputError       settings out of range; SimulationError  a shape without mass
  World(std::vector<RigidBody> shapes, const WorldSettings& settings);
  /// @param terrain  must outlive the world
  /// @param zones    parameters of each of its ground zones, by zone number
  World(std::vector<RigidBody> shapes, const WorldSettings& settings, const TerrainSurface& terrain,
        std::vector<GroundParameters> zones);
  ~World();
  World(World&&) noexcept;

  /// Has every step seen from now on, for each body that takes part in it. Times are the world's.
  void set_observer(BodyObserver observer);

  /// Numbers bodies from 0 in the order they come.
  /// @throws SimulationError  no such shape, a state that is not finite, or a start off the terrain
  std::size_t add_body(std::size_t shape, const RigidState& state, bool fixed = false);
  /// Adds a form: a fixed body that holds others while they settle. Nothing but the bodies from
  /// `first` to before `end` touches it, with the parameters `on_confining_walls`. It has the next
  /// number.
  /// @throws SimulationError  as `add_body`
  std::size_t add_confining_wall(std::size_t shape, const RigidState& state, std::size_t first,
                                 std::size_t end);
  /// Takes a body away, fixed or not. It keeps its number and the state it had, with that state's
  /// energy; what it touched is woken, and does not count as resting.
  /// @throws SimulationError  no such body
  void remove_body(std::size_t body);
  /// Lets fixed bodies move from now on, from rest where they are; each brings its energy to
  /// `initial`. What leaned on them keeps its contacts.
  /// @throws SimulationError  no such body, or one that is not fixed or that is gone; off the
  ///                          terrain or below it; deeper in the ground, or in a body that did not
  ///                          move either, than a start may be
  void release_bodies(std::span<const std::size_t> bodies);

  /// One step: of `stiffness.time_step` while there is an impact and before one may begin, else up
  /// to twice `stiffness.max_time_step`, or as far as all bodies fly freely.
  /// @throws SimulationError  a body starts inside another or inside the ground deeper than
  ///                          allowed, or its motion is not finite any more; names the body
  void step();
  /// Steps until every body rests or is gone (kRest; kLeftTerrain when all that could move are
  /// gone), or `time` is reached (kMaxTime).
  /// @param after_step  called after every step
  StopReason run_until_rest(double time, const std::function<void()>& after_step = {});
  /// Steps until `time` is reached, whether bodies rest or not.
  void run_to_time(double time, const std::function<void()>& after_step = {});

  double time() const;  ///< s
  std::size_t body_count() const;
  const RigidState& state(std::size_t body) const;
  bool is_fixed(std::size_t body) const;
  /// At rest as `rest_energy` and `rest_duration` define it. A fixed body is.
  bool is_resting(std::size_t body) const;
  /// Left out of the motion until something touches it (`WorldSettings::sleep_drift`).
  bool is_asleep(std::size_t body) const;
  /// Out of the motion: it left the terrain, or was removed.
  bool is_inactive(std::size_t body) const;
  /// Its centre passed the border of the terrain: it stays there, gone.
  bool has_left_terrain(std::size_t body) const;
  /// Force of all contacts on the body, N, world axes.
  Vec3 contact_force(std::size_t body) const;
  /// All contacts of the body now. Their zone is that of the ground it touches; where it touches
  /// only bodies, of the ground below the deepest contact, 0 without any.
  ContactSummary contact_summary(std::size_t body) const;
  /// Bodies that it touches now, ascending.
  std::vector<std::size_t> touching_bodies(std::size_t body) const;
  /// Largest overlap of the two bodies now, m; 0 when they don't touch.
  double overlap(std::size_t body, std::size_t other) const;

  /// Sums of m v and of x cross m v + J w over the bodies that move, about the origin.
  Vec3 linear_momentum() const;
  Vec3 angular_momentum() const;
  /// Balance since the first body came. A body added later brings its energy to `initial`.
  EnergyBalance energy_balance() const;
  /// The energy now, and what has become of the rest.
  EnergySample energy_sample() const;
  WorldStatistics statistics() const;

  /// Writes all that its motion depends on.
  void save(ByteWriter& to) const;
  /// Restores a state that `save` wrote in the same program, of a world with the same shapes,
  /// settings, terrain and zones: its motion continues with the same bits.
  /// @throws InputError  the bytes are of another world; this one is only to be destroyed then
  void restore(ByteReader& from);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
