#pragma once
/// Simulation of many colliding bodies, with or without a terrain.
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

/// Settings of a simulation of many bodies.
struct WorldSettings : MotionSettings {
  GroundParameters between_bodies;  ///< contact parameters of two bodies
  /// Contact parameters of a confining wall and a body.
  GroundParameters on_confining_walls{.friction = 0.0};
  /// Largest drift of a stationary body during `sleep_duration`, as a fraction of its smallest side
  /// S; if 0, no body sleeps. A body falls asleep if it and all bodies that it touches are
  /// stationary. A sleeping body keeps its pose and needs no computing time. It wakes if a moving
  /// body touches it or a sleeping body connected to it.
  double sleep_drift = 1e-3;
  double sleep_duration = 0.5;  ///< duration of each time window whose mean poses are compared, s
  unsigned threads = 1;  ///< number of threads; 0: one per core. It does not affect the result

  void check() const;  ///< throws InputError naming the field and its value
};

/// Counts of steps, contact pairs and sleeping bodies of a simulation.
struct WorldStatistics {
  std::uint64_t steps = 0;
  std::uint64_t broad_phase_count = 0;  ///< number of broad phase updates
  std::uint64_t pair_steps = 0;         ///< number of touching pairs, summed over the steps
  std::size_t near_pairs = 0;           ///< current number of pairs found by the broad phase
  std::size_t searched_pairs = 0;       ///< current number of pairs in the narrow phase
  std::size_t touching_pairs = 0;       ///< current number of touching pairs
  std::size_t active_pairs = 0;         ///< current number of pairs with a moving body
  std::size_t sleeping_bodies = 0;      ///< current number of sleeping bodies
  std::size_t contact_points = 0;       ///< current number of contact points
  double max_overlap = 0.0;             ///< largest current overlap, m
};

/// Observer of body motions. It may be called from several threads at once for different bodies.
using BodyObserver = std::function<void(std::size_t body, const MotionStep&)>;

/// Simulation of moving bodies. Each body has one of the shared shapes and a state. A body may be
/// fixed until it is released. Contacts with the terrain and between bodies use the same law.
///
/// Invariant: states, contacts and energies belong to the same time, `time()`.
class World {
 public:
  /// Makes a simulation without terrain.
  /// @param shapes  bodies in their principal frames, to which `add_body` refers by index
  /// @throws InputError  if settings are out of range
  /// @throws SimulationError  if a shape has no mass
  World(std::vector<RigidBody> shapes, const WorldSettings& settings);
  /// Makes a simulation with a terrain.
  /// @param terrain  terrain surface; must outlive this object
  /// @param zones  parameters of each ground zone of the terrain
  World(std::vector<RigidBody> shapes, const WorldSettings& settings, const TerrainSurface& terrain,
        std::vector<GroundParameters> zones);
  ~World();
  World(World&&) noexcept;

  /// Sets the observer of all moving bodies.
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
  /// Releases fixed bodies, which then start to move from rest. The energy of each body is added to
  /// `EnergyBalance::initial`.
  /// @throws SimulationError  if a body does not exist, is not fixed or was removed, if it is
  ///                          outside or below the terrain, or if it overlaps the ground or another
  ///                          freed body by more than `start_overlap`
  void release_bodies(std::span<const std::size_t> bodies);

  /// Advances the simulation by one time step, whose length depends on the contacts.
  /// @throws SimulationError  if a body overlaps another or the ground at its start by more than
  ///                          `start_overlap`, or if its motion is not finite; the message names
  ///                          the body
  void step();
  /// Advances the simulation until all bodies rest or are removed, or until `time` (s) is reached.
  /// @param after_step  called after each step
  /// @return kRest, kLeftTerrain if all movable bodies are removed, or kMaxTime
  StopReason run_until_rest(double time, const std::function<void()>& after_step = {});
  /// Advances the simulation until `time` (s), also if all bodies rest.
  void run_to_time(double time, const std::function<void()>& after_step = {});

  double time() const;  ///< s
  std::size_t body_count() const;
  const RigidState& state(std::size_t body) const;
  bool is_fixed(std::size_t body) const;
  /// True if the body is fixed, or at rest according to `rest_energy` and `rest_duration`.
  bool is_resting(std::size_t body) const;
  /// True if the body sleeps, so that its motion is not computed.
  bool is_asleep(std::size_t body) const;
  /// True if the body left the terrain or was removed.
  bool is_inactive(std::size_t body) const;
  /// True if the centre of the body passed the border of the terrain. The body is then inactive.
  bool has_left_terrain(std::size_t body) const;
  /// Returns the total contact force on a body, N, world axes.
  Vec3 contact_force(std::size_t body) const;
  /// Summarises the current contacts of a body: their number, and overlap, position and ground zone
  /// of the deepest one.
  ContactSummary contact_summary(std::size_t body) const;
  /// Returns the ascending indices of the bodies that touch a body.
  std::vector<std::size_t> touching_bodies(std::size_t body) const;
  /// Returns the largest current overlap of two bodies, m; 0 if they do not touch.
  double overlap(std::size_t body, std::size_t other) const;

  /// Returns the total linear momentum of the moving bodies, kg m/s.
  Vec3 linear_momentum() const;
  Vec3 angular_momentum() const;
  /// Returns the energy balance since the first body was added. `initial` includes the energy of
  /// bodies added later.
  EnergyBalance energy_balance() const;
  /// Returns the present energies and the dissipation since the first body was added.
  EnergySample energy_sample() const;
  WorldStatistics statistics() const;

  /// Saves the state that determines the future motion.
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
