#pragma once
/// Sequences of persistent blocks: released one after the other, each when all previous ones are at
/// rest, or all at once. Blocks may collide with, move and stop each other.
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
  /// Time for which the block is fixed after the first release, s, in multi-block releases. Others
  /// may hit it.
  double release_time = 0.0;
};

/// Confining wall: fixed body that touches only given blocks of a multi-block release while they
/// settle, until it is removed.
struct ConfiningWall {
  std::size_t shape = 0;           ///< index into the shapes
  RigidState pose;                 ///< its x axis points to the blocks that it holds
  std::size_t first = 0, end = 0;  ///< range of these blocks
  double removed_at = 0.0;         ///< since the first release, s; empty if not removed
};

struct SequenceSettings {
  WorldSettings world;
  /// True: all blocks exist from the start and are released together unless fixed. False: one after
  /// the other.
  bool at_once = false;
  /// Time limit of each release, s, for multi-block releases since the last release; then the next
  /// block follows although some still move.
  double max_time = 0.0;
  /// Interval of energy samples, s; 0: only at each release and rest.
  double energy_interval = 0.0;
  /// Ground zones that are cleared when all blocks rest: blocks with their centre in one of them
  /// are removed before the next release; supported blocks may move again.
  std::vector<std::uint16_t> cleared_zones;
  /// Confining walls of a multi-block release: their blocks settle under gravity before the first
  /// release, while other blocks are fixed. Times and energies count from then on; a block is
  /// released when its first wall is removed.
  std::vector<ConfiningWall> confining_walls;
  double settle_time = 20.0;  ///< time limit for settling, s

  void check() const;  ///< throws InputError naming the field and its value
};

/// Error: confined blocks do not settle.
class SettlingError : public SimulationError {
 public:
  SettlingError(const std::string& message, std::size_t first_block, std::size_t of_blocks,
                bool left)
      : SimulationError(message), block(first_block), count(of_blocks), left_wall(left) {}

  std::size_t block = 0;   ///< first of them
  std::size_t count = 0;   ///< number of such blocks
  bool left_wall = false;  ///< they left their walls; false: they still moved after `settle_time`
};

struct SequenceResult {
  /// Result of the block. `duration` and `energy` refer to its own release (shared by multi-block
  /// releases, until all blocks rested), `stop_reason` and `final_state` to the end of the sequence
  /// or its removal; other values are summed over the whole sequence, because later blocks may move
  /// it.
  ReleaseResult release;
  double released_at = 0.0;  ///< since the first release, s
  /// Additional start height, m, which keeps its bounding sphere clear of those of all lying blocks
  /// (one after the other only).
  double raise_height = 0.0;
  std::optional<RigidState> settled;  ///< state after settling; empty if it did not settle
  double later_displacement = 0.0;    ///< from the end of its own release to its final position, m
  std::optional<double> removed_at;   ///< since the first block was released, s; none: it stayed
  std::uint32_t blocks_hit = 0;       ///< number of other blocks touched during its own release

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(release, released_at, raise_height, settled, later_displacement, removed_at, blocks_hit);
  }
};

/// Observer of block motions, called in order of time for each block, from any thread. Times count
/// from its own release, or from the first release of a multi-block release. Not called while a
/// block sleeps, is fixed or settles.
using SequenceObserver = std::function<void(std::size_t block, const MotionStep&)>;

struct SequenceProgress {
  double time = 0.0;         ///< simulated time including settling, s
  std::size_t released = 0;  ///< number of released blocks
  bool settling = false;     ///< behind confining walls
  // Both functions are valid only while the observer runs, and empty for single runs.

  /// Counts released blocks that are at rest or removed.
  std::function<std::size_t()> resting = {};
  /// Saves the complete state, from which `simulate_sequence` can continue.
  std::function<void(ByteWriter& to)> save = {};
};
/// Called after each step; its exceptions end the sequence.
using SequenceProgressObserver = std::function<void(const SequenceProgress&)>;

/// Observer of the energy of all blocks, in order of time since the first release: at each release,
/// after the first step past each multiple of `energy_interval`, and at each rest. It does not
/// affect the steps.
using EnergyObserver = std::function<void(const EnergySample&)>;

/// Optional observers; they do not affect the results.
struct SequenceObservers {
  SequenceObserver motion = {};
  EnergyObserver energy = {};
  SequenceProgressObserver progress = {};
};

/// Simulates a sequence.
/// @param shapes  of the blocks
/// @param zones  parameters of each ground zone of the terrain
/// @param from  state of the same sequence saved by the same program (`SequenceProgress::save`), to
///              continue bit-identically; null: start from the beginning
/// @throws InputError  if settings are out of range or the state is of another sequence
/// @throws SettlingError  if confined blocks do not settle
/// @throws SimulationError  if a start is outside the terrain or inside the ground or a block, or a
///                          motion is not finite; with the index of the block
std::vector<SequenceResult> simulate_sequence(const TerrainSurface& terrain,
                                              std::span<const GroundParameters> zones,
                                              std::span<const RigidBody> shapes,
                                              std::span<const SequenceBlock> blocks,
                                              const SequenceSettings& settings,
                                              const SequenceObservers& observers = {},
                                              ByteReader* from = nullptr);

}  // namespace clast
