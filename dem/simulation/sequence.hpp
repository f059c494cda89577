#pragma once
/// Simulation of several blocks that stay on the terrain. They are released at once, or one after
/// the other when all previous ones are at rest. They may collide with, move and stop each other.
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "dem/simulation/world.hpp"

namespace clast {

struct SequenceBlock {
  std::size_t shape = 0;  ///< index into the shapes
  RigidState start;
  /// Time between the first release and that of this block, s. Until then it is fixed, but other
  /// blocks may hit it. Used only if `SequenceSettings::at_once` is true.
  double release_time = 0.0;
};

/// Confining wall: a fixed body that holds a range of blocks while they settle before their
/// release. It touches no other blocks.
struct ConfiningWall {
  std::size_t shape = 0;  ///< index into the shapes
  RigidState pose;        ///< pose of the wall; its x axis points towards the blocks that it holds
  std::size_t first = 0, end = 0;  ///< range of the indices of the blocks that it holds
  double removed_at = 0.0;         ///< time from the first release to the removal of the wall, s
};

struct SequenceSettings {
  WorldSettings world;
  /// True if all blocks exist from the start and are released together, or at their `release_time`.
  /// False if they are released one after the other.
  bool at_once = false;
  /// Time limit of each release, s. After it, the next block is released although some blocks still
  /// move.
  double max_time = 0.0;
  /// Interval of energy samples, s. If 0, samples are taken only at each release and each rest.
  double energy_interval = 0.0;
  /// Indices of the ground zones that are cleared. Blocks that come to rest in one of them are
  /// removed before the next release. Blocks that they supported may move again.
  std::vector<std::uint16_t> cleared_zones;
  /// Confining walls of blocks that are released at once. These blocks settle under gravity before
  /// the first release. A confined block is released when the first of its walls is removed.
  std::vector<ConfiningWall> confining_walls;
  double settle_time = 20.0;  ///< time limit for settling, s

  void check() const;  ///< throws InputError naming the field and its value
};

/// Error thrown if blocks do not settle behind confining walls.
class SettlingError : public SimulationError {
 public:
  SettlingError(const std::string& message, std::size_t first_block, std::size_t of_blocks,
                bool left)
      : SimulationError(message), block(first_block), count(of_blocks), left_wall(left) {}

  std::size_t block = 0;   ///< index of the first block that did not settle
  std::size_t count = 0;   ///< number of blocks that did not settle
  bool left_wall = false;  ///< true if blocks left their walls; false if they still moved
};

struct SequenceResult {
  /// Motion of the block. `duration` and `energy` refer to its own release, or to the time until
  /// all blocks rested if they are released at once. Other values refer to the whole simulation,
  /// because later blocks may move it.
  ReleaseResult release;
  double released_at = 0.0;  ///< time from the first release to that of the block, s
  /// Height by which the start position was raised to be clear of blocks that lay there, m.
  double raise_height = 0.0;
  /// State after settling behind confining walls; empty if not confined.
  std::optional<RigidState> state_after_settling;
  /// Distance from the position at the end of its own release to the final position, m.
  double later_displacement = 0.0;
  /// Time from the first release to its removal, s; empty if not removed.
  std::optional<double> removed_at;
  std::uint32_t blocks_hit = 0;  ///< number of other blocks that it touched during its own release

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(release, released_at, raise_height, state_after_settling, later_displacement, removed_at,
          blocks_hit);
  }
};

/// Observer of block motions. It is called in order of time for each block, from any thread. It is
/// not called while a block sleeps, is fixed or settles.
using SequenceObserver = std::function<void(std::size_t block, const MotionStep&)>;

struct SequenceProgress {
  double time = 0.0;         ///< simulated time including settling, s
  std::size_t released = 0;  ///< number of released blocks
  bool settling = false;     ///< true while blocks settle behind confining walls
  // Both functions may be called only while the observer runs. They are empty for single releases.

  /// Counts released blocks that are at rest or removed.
  std::function<std::size_t()> count_resting = {};
  /// Saves the complete state, from which `simulate_sequence` can continue.
  std::function<void(ByteWriter& to)> save_state = {};
};
/// Observer of the progress, called after each step. If it throws, the simulation ends.
using SequenceProgressObserver = std::function<void(const SequenceProgress&)>;

/// Observer of the energies of all blocks. It is called at each release, when all blocks rest, and
/// at the interval `energy_interval`.
using EnergyObserver = std::function<void(const EnergySample&)>;

/// Optional observers of a simulation. They do not affect the results.
struct SequenceObservers {
  SequenceObserver motion = {};
  EnergyObserver energy = {};
  SequenceProgressObserver progress = {};
};

/// Simulates the motion of several blocks on a terrain.
/// @param shapes  shapes of the blocks
/// @param zones  parameters of each ground zone of the terrain
/// @param from  state of the same sequence that `SequenceProgress::save_state` saved; the
///              simulation continues bit-identically. If null, it starts from the beginning.
/// @throws InputError  if settings are out of range or the state is of another sequence
/// @throws SettlingError  if confined blocks do not settle
/// @throws SimulationError  if a start is outside the terrain or inside the ground or a block, or
///                          if a motion is not finite; the message gives the index of the block
std::vector<SequenceResult> simulate_sequence(const TerrainSurface& terrain,
                                              std::span<const GroundParameters> zones,
                                              std::span<const RigidBody> shapes,
                                              std::span<const SequenceBlock> blocks,
                                              const SequenceSettings& settings,
                                              const SequenceObservers& observers = {},
                                              ByteReader* from = nullptr);

}  // namespace clast
