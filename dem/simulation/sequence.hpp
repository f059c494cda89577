#pragma once
/// Blocks released onto one terrain, where they stay: one after the other, each when all before it
/// have come to rest, or all at once. They may hit and move each other, or be stopped by others.
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "dem/simulation/world.hpp"

namespace clast {

/// A block of a sequence.
struct SequenceBlock {
  std::size_t shape = 0;  ///< index into the shapes
  RigidState start;
  /// Of blocks released at once, s: until then, since the first of them was released, it is held
  /// where it is. Others may hit it.
  double release_time = 0.0;
};

/// A fixed body that holds blocks released at once while they settle, and until it is removed. All
/// else passes through it.
struct SequenceForm {
  std::size_t shape = 0;           ///< index into the shapes
  RigidState pose;                 ///< its x axis points to the blocks that it holds
  std::size_t first = 0, end = 0;  ///< these blocks
  double removed_at = 0.0;         ///< since the first release, s
};

struct SequenceSettings {
  WorldSettings world;
  /// All blocks are there together, each at its very start, and those that are not held released at
  /// once; else one after the other.
  bool at_once = false;
  /// Of each release, s, of blocks at once since the last of them was released: then the next block
  /// follows though some still move.
  double max_time = 0.0;
  /// Between samples of the energy, s; 0: none but at each release and rest.
  double energy_interval = 0.0;
  /// Ground zones that are cleared whenever all blocks rest: a block whose centre lies in one of
  /// them is removed before the next one is released, and what it held may move on.
  std::vector<std::uint16_t> cleared_zones;
  /// Of blocks at once: what they hold settles by gravity before the first release, while all other
  /// blocks are held. Times and energies count from then on, and a block is released when the first
  /// of its forms is removed.
  std::vector<SequenceForm> confining_walls;
  double settle_time = 20.0;  ///< s, that what settles must rest after

  void check() const;  ///< throws InputError naming the field and its value
};

/// Blocks that forms hold do not settle.
class SettlingError : public SimulationError {
 public:
  SettlingError(const std::string& message, std::size_t first_block, std::size_t of_blocks,
                bool left)
      : SimulationError(message), block(first_block), count(of_blocks), left_wall(left) {}

  std::size_t block = 0;   ///< the first of them
  std::size_t count = 0;   ///< how many do not
  bool left_wall = false;  ///< they left their forms; else they still moved after `settle_time`
};

/// What became of a block of a sequence.
struct SequenceResult {
  /// `duration` and `energy` are of its own release, which blocks released at once share: until all
  /// blocks rested, and of all of them.
  /// `stop_reason` and `final_state` are of the end of the sequence, all else is summed up over all
  /// of it, since later blocks may move this one. Of a block that was removed, the end is then.
  ReleaseResult release;
  double released_at = 0.0;  ///< since the first block was released, s
  /// How much higher than asked for it was released, m: one after the other, its bounding sphere is
  /// clear of the bounding spheres of all blocks that lie there.
  double raise_height = 0.0;
  std::optional<RigidState> settled;  ///< of a block that settled: where it was then
  double later_displacement = 0.0;    ///< from the end of its own release to its last place, m
  std::optional<double> removed_at;   ///< since the first block was released, s; none: it stayed
  std::uint32_t blocks_hit = 0;       ///< other blocks that it touched during its own release

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(release, released_at, raise_height, settled, later_displacement, removed_at, blocks_hit);
  }
};

/// Sees how a block moved in a step, in the order of time; called from any of the world's threads,
/// for different blocks at a time. Times count from its own release, of blocks released at once
/// from the first release. There is nothing to see while it sleeps or is held, and while blocks
/// settle.
using SequenceObserver = std::function<void(std::size_t block, const MotionStep&)>;

/// How far a sequence has come.
struct SequenceProgress {
  double time = 0.0;         ///< simulated since the first block came, what settled included, s
  std::size_t released = 0;  ///< blocks so far
  bool settling = false;     ///< behind forms
  // Both functions are valid only while the observer runs, and empty for single runs.

  /// Counts the blocks released so far that are now at rest or gone.
  std::function<std::size_t()> resting = {};
  /// Writes the complete state of the sequence, for `simulate_sequence` to continue from.
  std::function<void(ByteWriter& to)> save = {};
};
/// Called after each step; what it throws ends the sequence.
using SequenceProgressObserver = std::function<void(const SequenceProgress&)>;

/// Sees the energy of all blocks, in the order of time since the first block was released: at each
/// release, after the first step that reaches each multiple of `energy_interval`, and at each rest.
/// It changes nothing: steps are as long as without.
using EnergyObserver = std::function<void(const EnergySample&)>;

/// Each may be left out. None of them changes a bit of the results.
struct SequenceObservers {
  SequenceObserver motion = {};
  EnergyObserver energy = {};
  SequenceProgressObserver progress = {};
};

/// Releases all blocks, in their order or at once.
///
/// @param shapes  that the blocks have
/// @param zones   parameters of each ground zone of the terrain, by zone number
/// @param from    a state of the same sequence, saved by the same program
/// (`SequenceProgress::save`)
///                and all that is left to read: it continues from there, with bit-identical results
///                and observations. Null: it starts from the beginning
/// @throws InputError       settings out of range; the saved state is of another sequence
/// @throws SettlingError    blocks that forms hold do not come to rest behind them
/// @throws SimulationError  a start off the terrain, inside the ground or a block, or a motion
///                          that is not finite any more: with the number of the block, from 0
std::vector<SequenceResult> simulate_sequence(const TerrainSurface& terrain,
                                              std::span<const GroundParameters> zones,
                                              std::span<const RigidBody> shapes,
                                              std::span<const SequenceBlock> blocks,
                                              const SequenceSettings& settings,
                                              const SequenceObservers& observers = {},
                                              ByteReader* from = nullptr);

}  // namespace clast
