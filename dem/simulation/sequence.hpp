#pragma once
/// Sequences of persistent blocks. The blocks are released all at once or one after the other, each
/// when all previous ones are at rest. They may collide with, move and stop each other.
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
  /// Time after the first release until which the block of a multi-block release is fixed, s. Other
  /// blocks may hit it before.
  double release_time = 0.0;
};

/// Confining wall: a fixed body that holds given blocks of a multi-block release while they settle.
/// It touches no other blocks.
struct ConfiningWall {
  std::size_t shape = 0;  ///< index into the shapes
  RigidState pose;        ///< pose of the wall; its x axis points towards the blocks that it holds
  std::size_t first = 0, end = 0;  ///< range of the blocks that it holds
  double removed_at = 0.0;         ///< time of its removal since the first release, s
};

struct SequenceSettings {
  WorldSettings world;
  /// If true, all blocks exist from the start and are released together, except those fixed until
  /// their `release_time`. If false, they are released one after the other.
  bool at_once = false;
  /// Time limit of each release, s; the next block then follows although some still move. For
  /// multi-block releases, the limit counts from the last release.
  double max_time = 0.0;
  /// Interval of energy samples, s. If 0, samples are taken only at each release and each rest.
  double energy_interval = 0.0;
  /// Ground zones that are cleared when all blocks rest. Blocks with their centre in one of them
  /// are removed before the next release. Blocks that they supported may move again.
  std::vector<std::uint16_t> cleared_zones;
  /// Confining walls of a multi-block release. Their blocks settle under gravity before the first
  /// release, while other blocks are fixed. Times and energies count from the first release. A
  /// confined block is released when the first of its walls is removed.
  std::vector<ConfiningWall> confining_walls;
  double settle_time = 20.0;  ///< time limit for settling, s

  void check() const;  ///< throws InputError naming the field and its value
};

/// Error thrown if confined blocks do not settle.
class SettlingError : public SimulationError {
 public:
  SettlingError(const std::string& message, std::size_t first_block, std::size_t of_blocks,
                bool left)
      : SimulationError(message), block(first_block), count(of_blocks), left_wall(left) {}

  std::size_t block = 0;   ///< index of the first block that did not settle
  std::size_t count = 0;   ///< number of blocks that did not settle
  bool left_wall = false;  ///< true if they left their walls, false if they still moved
};

struct SequenceResult {
  /// Result of the block. `duration` and `energy` refer to its own release; those of a multi-block
  /// release refer to the time until all blocks rested. `stop_reason` and `final_state` refer to
  /// the end of the sequence, or to the block's removal. Other values cover the whole sequence,
  /// because later blocks may move it.
  ReleaseResult release;
  double released_at = 0.0;  ///< since the first release, s
  /// Height by which the start was raised, m, so that the bounding sphere is clear of those of all
  /// lying blocks. Always 0 in multi-block releases.
  double raise_height = 0.0;
  std::optional<RigidState>
      state_after_settling;          ///< state after settling; empty if it did not settle
  double later_displacement = 0.0;   ///< from the end of its own release to its final position, m
  std::optional<double> removed_at;  ///< since the first release, s; empty if not removed
  std::uint32_t blocks_hit = 0;  ///< number of other blocks that it touched during its own release

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(release, released_at, raise_height, state_after_settling, later_displacement, removed_at,
          blocks_hit);
  }
};

/// Observer of block motions. It is called in order of time for each block, from any thread. Times
/// count from the block's own release, or from the first release of a multi-block release. It is
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
/// Called after each step; its exceptions end the sequence.
using SequenceProgressObserver = std::function<void(const SequenceProgress&)>;

/// Observer of the energy of all blocks in order of time since the first release. Called at each
/// release, at each rest, and after the first step past each multiple of `energy_interval`.
using EnergyObserver = std::function<void(const EnergySample&)>;

/// Optional observers; they do not affect the results.
struct SequenceObservers {
  SequenceObserver motion = {};
  EnergyObserver energy = {};
  SequenceProgressObserver progress = {};
};

/// Simulates a sequence.
/// @param shapes  shapes of the blocks
/// @param zones  parameters of each ground zone of the terrain
/// @param from  state of the same sequence saved by the same program (`SequenceProgress::save`);
///              the simulation continues bit-identically. If null, it starts from the beginning.
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
