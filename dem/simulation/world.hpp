#pragma once
/// World: many colliding blocks, with or without a terrain.
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

/// Settings of a world other than bodies and terrain.
struct WorldSettings : MotionSettings {
  GroundParameters between_bodies;                       ///< contact parameters of two bodies
  GroundParameters on_confining_walls{.friction = 0.0};  ///< of a wall and a confined body
  /// Largest drift of a stationary body, as a fraction of its smallest side S; if 0, no body
  /// sleeps. A body is stationary if it was in contact with less than ten times `rest_energy` for
  /// twice `sleep_duration`, and its mean poses in both halves differ by at most this drift. It
  /// falls asleep if all bodies that it touches are stationary. A sleeping body keeps its pose and
  /// costs nothing. It wakes if a body that is not stationary touches it, or touches a sleeping
  /// body connected to it.
  double sleep_drift = 1e-3;
  double sleep_duration = 0.5;  ///< s
  unsigned threads = 1;  ///< number of threads; 0: one per core. It does not affect the result

  void check() const;  ///< throws InputError naming the field and its value
};

/// Contact statistics, current and accumulated.
struct WorldStatistics {
  std::uint64_t steps = 0;
  std::uint64_t broad_phase_count = 0;  ///< number of broad phase updates
  std::uint64_t pair_steps = 0;         ///< number of touching pairs, summed over the steps
  std::size_t near_pairs = 0;           ///< current number of pairs found by the broad phase
  std::size_t searched_pairs = 0;       ///< current number of pairs in the narrow phase
  std::size_t touching_pairs = 0;       ///< now
  std::size_t active_pairs = 0;         ///< current number of pairs with a moving body
  std::size_t sleeping_bodies = 0;      ///< now
  std::size_t contact_points = 0;       ///< now
  double max_overlap = 0.0;             ///< now, m
};

/// Observer of body motions. It may be called from several threads at once for different bodies.
using BodyObserver = std::function<void(std::size_t body, const MotionStep&)>;

/// World of moving bodies. Each body has one of the shared shapes and a state. A body may be fixed
/// until it is freed. Contacts with the terrain and between bodies use the same law.
///
/// Invariant: states, contacts and energies belong to the same time, `time()`.
class World {
 public:
  /// Makes a world without terrain.
  /// @param shapes  shapes and masses that bodies refer to
  /// @throws InputError  if settings are out of range
  /// @throws SimulationError  if a shape has no mass
  World(std::vector<RigidBody> shapes, const WorldSettings& settings);
  /// Makes a world with terrain.
  /// @param terrain  must outlive the world
  /// @param zones  parameters of each ground zone of the terrain
  World(std::vector<RigidBody> shapes, const WorldSettings& settings, const TerrainSurface& terrain,
        std::vector<GroundParameters> zones);
  ~World();
  World(World&&) noexcept;

  /// Sets the observer of all moving bodies. Times are those of the world.
  void set_observer(BodyObserver observer);

  /// Adds a body and returns its index, counted from 0.
  /// @throws SimulationError  if the shape does not exist, the state is not finite, or the start is
  ///                          outside the terrain
  std::size_t add_body(std::size_t shape, const RigidState& state, bool fixed = false);
  /// Adds a confining wall and returns its index. It is a fixed body that touches only the bodies
  /// with indices in [first, end), with the contact parameters `on_confining_walls`.
  /// @throws SimulationError  as `add_body`
  std::size_t add_confining_wall(std::size_t shape, const RigidState& state, std::size_t first,
                                 std::size_t end);
  /// Removes a body. It keeps its index, its last state and its energy. The bodies that it touched
  /// are woken and do not count as resting.
  /// @throws SimulationError  if the body does not exist
  void remove_body(std::size_t body);
  /// Frees fixed bodies, which start at rest. The energy of each is added to
  /// `EnergyBalance::initial`. Bodies in contact with them keep their contact history.
  /// @throws SimulationError  if a body does not exist, is not fixed or was removed, if it is
  ///                          outside or below the terrain, or if it overlaps the ground or another
  ///                          freed body by more than `start_overlap`
  void release_bodies(std::span<const std::size_t> bodies);

  /// Advances by one step. Its length is `stiffness.time_step` during an impact and before a
  /// possible impact. Otherwise it is up to twice `stiffness.max_time_step`; it may be longer if
  /// all bodies are in free flight.
  /// @throws SimulationError  if a body overlaps another or the ground at its start by more than
  ///                          `start_overlap`, or if its motion is not finite; the message names
  ///                          the body
  void step();
  /// Advances until all bodies rest or are removed, or until `time` is reached.
  /// @param after_step  called after each step
  /// @return kRest, kLeftTerrain if all movable bodies are removed, or kMaxTime
  StopReason run_until_rest(double time, const std::function<void()>& after_step = {});
  /// Advances until `time`, also if all bodies rest.
  void run_to_time(double time, const std::function<void()>& after_step = {});

  double time() const;  ///< s
  std::size_t body_count() const;
  const RigidState& state(std::size_t body) const;
  bool is_fixed(std::size_t body) const;
  /// True if the body is at rest by `rest_energy` and `rest_duration`, or fixed.
  bool is_resting(std::size_t body) const;
  /// True if the body sleeps (`WorldSettings::sleep_drift`).
  bool is_asleep(std::size_t body) const;
  /// True if the body left the terrain or was removed.
  bool is_inactive(std::size_t body) const;
  /// True if the centre of the body passed the border of the terrain. The body is then inactive.
  bool has_left_terrain(std::size_t body) const;
  /// Returns the total contact force on a body, N, world axes.
  Vec3 contact_force(std::size_t body) const;
  /// Summarises the current contacts of a body. The zone is that of the touched ground. If the body
  /// touches only other bodies, it is the zone below the deepest contact. It is 0 without contacts.
  ContactSummary contact_summary(std::size_t body) const;
  /// Returns the ascending indices of the bodies that touch a body.
  std::vector<std::size_t> touching_bodies(std::size_t body) const;
  /// Returns the largest current overlap of two bodies, m; 0 if they do not touch.
  double overlap(std::size_t body, std::size_t other) const;

  /// Returns the total momentum of the moving bodies; angular momentum is about the origin.
  Vec3 linear_momentum() const;
  Vec3 angular_momentum() const;
  /// Energy balance since the first body was added; `initial` includes the energy of later bodies.
  EnergyBalance energy_balance() const;
  /// Returns the present energies and the dissipation since the first body was added.
  EnergySample energy_sample() const;
  WorldStatistics statistics() const;

  /// Saves the state that determines the motion.
  void save(ByteWriter& to) const;
  /// Restores a state saved by the same program in a world with equal shapes, settings, terrain and
  /// zones; the motion continues bit-identically.
  /// @throws InputError  if the bytes are of another world; this one is then unusable
  void restore(ByteReader& from);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
