#include "dem/simulation/sequence.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <string>

#include "core/byte_archive.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "dem/simulation/detail/block_recorder.hpp"
#include "dem/simulation/detail/release_schedule.hpp"

namespace clast {

using dem_detail::BlockRecorder;
using dem_detail::ReleaseSchedule;

namespace {

class Sequence {
 public:
  Sequence(const TerrainSurface& terrain, std::span<const GroundParameters> zones,
           std::span<const RigidBody> shapes, std::span<const SequenceBlock> blocks,
           const SequenceSettings& settings, const SequenceObservers& observers)
      : terrain_(terrain),
        shapes_(shapes),
        blocks_(blocks),
        settings_(settings),
        observers_(observers),
        schedule_(blocks, settings),
        world_({shapes.begin(), shapes.end()}, settings.world, terrain,
               {zones.begin(), zones.end()}) {}

  /// Restores a saved state. Must be called before `run`.
  void restore(ByteReader& from) {
    serialize(from);
    world_.restore(from);
    if (!from.at_end()) throw InputError("the saved state belongs to another sequence");
    observe_blocks();
    count_released();
  }

  std::vector<SequenceResult> run() {
    const std::size_t together = settings_.at_once ? blocks_.size() : 1;
    while (phase_ != Phase::kFinished || recorders_.size() < blocks_.size()) {
      if (phase_ == Phase::kFinished) add_blocks(recorders_.size(), recorders_.size() + together);
      finish_release();
    }
    std::vector<SequenceResult> results;
    for (std::size_t block = 0; block < blocks_.size(); ++block) results.push_back(finished(block));
    return results;
  }

 private:
  /// Phase of the newest blocks. A run can continue in any phase from a checkpoint.
  enum class Phase : std::uint8_t {
    kSettling,  ///< behind confining walls
    kHeld,      ///< until the last block is released
    kMoving,    ///< until all blocks rest
    kFinished,  ///< all blocks rest
  };

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(phase_, changes_done_, energy_before_, recorders_, walls_, released_at_, newest_, begin_,
          energy_intervals_);
  }

  const RigidBody& body_of(std::size_t block) const { return shapes_[blocks_[block].shape]; }

  /// Smallest height above `start` at which the block's bounding sphere is clear of all others.
  double clear_height(const RigidBody& body, const Vec3& start) const {
    const double radius = body.bounding_radius();
    double height = start.z();
    for (bool raised = true; raised;) {
      raised = false;
      for (std::size_t other = 0; other < world_.body_count(); ++other) {
        if (world_.is_inactive(other)) continue;
        const Vec3& position = world_.state(other).position;
        const double apart = radius + body_of(other).bounding_radius();
        const double squared = apart * apart - (position - start).head<2>().squaredNorm();
        if (squared <= 0.0 || std::abs(height - position.z()) >= std::sqrt(squared)) continue;
        const double clear = position.z() + std::sqrt(squared);
        raised |= clear > height;
        height = std::max(height, clear);
      }
    }
    return height;
  }

  /// Adds the blocks with indices in [first, end).
  void add_blocks(std::size_t first, std::size_t end) {
    energy_before_ = world_.energy_balance();
    released_at_ = world_.time();
    for (std::size_t block = first; block < end; ++block) add(block);
    newest_ = first;
    for (const ConfiningWall& wall : settings_.confining_walls) {
      walls_.push_back(world_.add_confining_wall(wall.shape, wall.pose, wall.first, wall.end));
    }
    phase_ = Phase::kSettling;
    if (walls_.empty()) {
      begin_release();
    } else {
      count_released();
    }
  }

  void begin_release() {
    phase_ = Phase::kHeld;
    count_released();
    observe_blocks();
    if (newest_ == 0) begin_ = world_.energy_sample();
    take_energy();
  }

  void observe_blocks() {
    if (phase_ == Phase::kSettling) return;
    world_.set_observer(
        [this](std::size_t block, const MotionStep& step) { record_step(block, step); });
  }

  /// Runs until all blocks rest.
  void finish_release() {
    if (phase_ == Phase::kSettling) settle();
    const double last = released_at_ + release_held();
    do {
      world_.run_until_rest(last + settings_.max_time, after_step());
    } while (clear_zones());
    take_energy();
    const EnergyBalance energy = of_release(energy_before_, world_.energy_balance());
    for (std::size_t block = newest_; block < recorders_.size(); ++block) {
      SequenceResult& result = recorders_[block].result;
      result.release.duration = world_.time() - released_at_;
      result.release.energy = energy;
      result.blocks_hit = static_cast<std::uint32_t>(recorders_[block].hit_blocks.size());
      recorders_[block].first_rest = world_.state(block).position;
    }
    phase_ = Phase::kFinished;
  }

  /// Runs until the blocks behind confining walls rest.
  void settle() {
    world_.run_until_rest(settings_.settle_time, after_step());
    refuse_settled(true, [&](std::size_t block) {
      return world_.is_inactive(block) ||
             std::any_of(settings_.confining_walls.begin(), settings_.confining_walls.end(),
                         [&](const auto& wall) {
                           const Vec3 inwards = wall.pose.orientation * Vec3::UnitX();
                           const Vec3 from_wall = world_.state(block).position - wall.pose.position;
                           return block >= wall.first && block < wall.end &&
                                  inwards.dot(from_wall) <= 0.0;
                         });
    });
    refuse_settled(false, [&](std::size_t block) { return !world_.is_resting(block); });
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
      if (schedule_.is_confined(block))
        recorders_[block].result.state_after_settling = world_.state(block);
    }
    energy_before_ = world_.energy_balance();
    released_at_ = world_.time();
    begin_release();
  }

  /// @param is_bad  returns true if a block left its walls or still moves
  void refuse_settled(bool left, const std::function<bool(std::size_t)>& is_bad) const {
    std::size_t all = 0, bad = 0, first = 0;
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
      if (!schedule_.is_confined(block)) continue;
      ++all;
      if (is_bad(block) && bad++ == 0) first = block;
    }
    if (bad == 0) return;
    const std::string problem =
        left ? "left their confining walls; place them deeper within the walls"
             : "still move after settle_time = " + format_significant(settings_.settle_time, 6) +
                   " s; give them more time";
    throw SettlingError(std::to_string(bad) + " of " + std::to_string(all) +
                            " blocks that settle, body " + std::to_string(first) + " the first, " +
                            problem,
                        first, bad, left);
  }

  /// Releases the fixed blocks and removes the confining walls, each at its time.
  /// @return  time from the first to the last release, s
  double release_held() {
    struct Change {
      std::vector<std::size_t> freed, removed;
    };
    std::map<double, Change> changes;  // key: time since the first release
    for (std::size_t block = newest_; block < recorders_.size(); ++block) {
      if (schedule_.starts_fixed(block))
        changes[blocks_[block].release_time].freed.push_back(block);
    }
    for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
      changes[settings_.confining_walls[wall].removed_at].removed.push_back(walls_[wall]);
    }
    if (phase_ == Phase::kHeld) {
      auto next = std::next(changes.begin(), static_cast<std::ptrdiff_t>(changes_done_));
      for (; next != changes.end(); ++next, ++changes_done_) {
        const auto& [time, change] = *next;
        world_.run_to_time(released_at_ + time, after_step());
        if (!change.freed.empty()) world_.release_bodies(change.freed);
        count_released();
        for (const std::size_t wall : change.removed) world_.remove_body(wall);
        take_energy();
      }
      phase_ = Phase::kMoving;
    }
    return changes.empty() ? 0.0 : changes.rbegin()->first;
  }

  void take_energy() {
    if (observers_.energy) observers_.energy(world_.energy_sample().change_since(begin_));
  }

  /// Returns the function to call after each step; empty if there is nothing to do.
  std::function<void()> after_step() {
    const bool sample = observers_.energy && settings_.energy_interval > 0.0 && !settling();
    if (!sample && !observers_.progress) return {};
    return [this, sample] {
      if (sample) take_energy_when_due();
      if (observers_.progress) observers_.progress(progress());
    };
  }

  void take_energy_when_due() {
    const double intervals = std::floor((world_.time() - begin_.time) / settings_.energy_interval);
    if (intervals <= energy_intervals_) return;
    energy_intervals_ = intervals;
    take_energy();
  }

  bool is_released(std::size_t block) const {
    return settling() ? schedule_.is_confined(block) : !world_.is_fixed(block);
  }

  /// Counts the released blocks. Called only when their number changes.
  void count_released() {
    released_ = 0;
    for (std::size_t block = 0; block < recorders_.size(); ++block) {
      if (is_released(block)) ++released_;
    }
  }

  bool settling() const { return phase_ == Phase::kSettling; }

  SequenceProgress progress() {
    const auto resting = [this] {
      std::size_t count = 0;
      for (std::size_t block = 0; block < recorders_.size(); ++block) {
        if (is_released(block) && (world_.is_inactive(block) || world_.is_resting(block))) ++count;
      }
      return count;
    };
    const auto save = [this](ByteWriter& to) {
      serialize(to);
      world_.save(to);
    };
    return {world_.time(), released_, settling(), resting, save};
  }

  void add(std::size_t block) {
    SequenceResult& result = recorders_.emplace_back().result;
    RigidState start = blocks_[block].start;
    if (!settings_.at_once) {
      const double height = clear_height(body_of(block), start.position);
      result.raise_height = height - start.position.z();
      start.position.z() = height;
    }
    result.released_at = settings_.at_once ? schedule_.release_time(block) : released_at_;
    world_.add_body(blocks_[block].shape, start, schedule_.starts_fixed(block));
  }

  /// Removes the blocks that rest in cleared zones.
  /// @return  true if any block was removed
  bool clear_zones() {
    bool any = false;
    for (std::size_t block = 0; block < recorders_.size(); ++block) {
      if (world_.is_inactive(block) || !world_.is_resting(block) || !lies_in_cleared_zone(block))
        continue;
      recorders_[block].result.release.settled_penetration = world_.contact_summary(block).overlap;
      recorders_[block].result.removed_at = world_.time();
      world_.remove_body(block);
      any = true;
    }
    return any;
  }

  bool lies_in_cleared_zone(std::size_t block) const {
    const std::vector<std::uint16_t>& cleared = settings_.cleared_zones;
    if (cleared.empty()) return false;
    const Vec3& position = world_.state(block).position;
    const std::optional<std::uint16_t> zone =
        terrain_.zone_at(position.x(), position.y(), position.z());
    return zone && std::find(cleared.begin(), cleared.end(), *zone) != cleared.end();
  }

  /// Returns the energy balance of all blocks between two balances.
  EnergyBalance of_release(const EnergyBalance& before, const EnergyBalance& after) const {
    EnergyBalance part;
    part.initial = before.final + (after.initial - before.initial);
    part.normal = after.normal - before.normal;
    part.friction = after.friction - before.friction;
    part.rolling = after.rolling - before.rolling;
    part.reassigned = after.reassigned - before.reassigned;
    double potential = 0.0;
    for (std::size_t i = 0; i < recorders_.size(); ++i) {
      potential += body_of(i).mass * settings_.world.gravity * world_.state(i).position.z();
    }
    part.close_balance(after.final, part.initial - potential);
    return part;
  }

  void record_step(std::size_t block, const MotionStep& step) {
    BlockRecorder& recorder = recorders_[block];
    recorder.record_step(step);
    if (block >= newest_ && recorder.touching) {
      std::vector<std::size_t> touched = world_.touching_bodies(block);
      std::erase_if(touched, [&](std::size_t other) { return other >= blocks_.size(); });  // walls
      recorder.record_hits(touched);
    }
    if (!observers_.motion) return;
    MotionStep since_release = step;
    const double release = settings_.at_once ? released_at_ : recorder.result.released_at;
    since_release.begin_time -= release;
    since_release.end_time -= release;
    observers_.motion(block, since_release);
  }

  SequenceResult finished(std::size_t block) const {
    SequenceResult result = recorders_[block].result;
    ReleaseResult& release = result.release;
    release.final_state = world_.state(block);
    if (!result.removed_at) release.settled_penetration = world_.contact_summary(block).overlap;
    release.stop_reason = world_.has_left_terrain(block)                  ? StopReason::kLeftTerrain
                          : result.removed_at || world_.is_resting(block) ? StopReason::kRest
                                                                          : StopReason::kMaxTime;
    const Vec3& position = release.final_state.position;
    const std::optional<double> ground =
        terrain_.height_at(position.x(), position.y(), position.z());
    release.below_ground = ground && position.z() < *ground;
    result.later_displacement = (position - recorders_[block].first_rest).norm();
    return result;
  }

  const TerrainSurface& terrain_;
  std::span<const RigidBody> shapes_;
  std::span<const SequenceBlock> blocks_;
  const SequenceSettings& settings_;
  const SequenceObservers& observers_;
  ReleaseSchedule schedule_;
  World world_;
  std::vector<BlockRecorder> recorders_;
  std::vector<std::size_t> walls_;  ///< body indices of the confining walls
  double released_at_ = 0.0;        ///< time at which the newest blocks were released, s
  std::size_t newest_ = 0;          ///< index of the first of the newest blocks
  Phase phase_ = Phase::kFinished;
  std::size_t changes_done_ = 0;   ///< number of releases and removals done, in order of time
  EnergyBalance energy_before_;    ///< energy balance just before the newest blocks were released
  std::size_t released_ = 0;       ///< number of blocks released until now
  EnergySample begin_;             ///< sample at the first release
  double energy_intervals_ = 0.0;  ///< sampling intervals passed at the last sample
};

}  // namespace

void SequenceSettings::check() const {
  world.check();
  if (!(max_time > 0.0)) {
    throw InputError("max_time = " + format_significant(max_time, 6) + "; must be above 0");
  }
  if (!(energy_interval >= 0.0)) {
    throw InputError("energy_interval = " + format_significant(energy_interval, 6) +
                     "; must be 0 or more");
  }
  if (!(settle_time > 0.0)) {
    throw InputError("settle_time = " + format_significant(settle_time, 6) + "; must be above 0");
  }
  if (!confining_walls.empty() && !at_once) {
    throw InputError("confining walls are for blocks that are released at once; also give at_once");
  }
}

std::vector<SequenceResult> simulate_sequence(
    const TerrainSurface& terrain, std::span<const GroundParameters> zones,
    std::span<const RigidBody> shapes, std::span<const SequenceBlock> blocks,
    const SequenceSettings& settings, const SequenceObservers& observers, ByteReader* from) {
  settings.check();
  for (const SequenceBlock& block : blocks) {
    if (block.release_time >= 0.0) continue;
    throw InputError("release_time = " + format_significant(block.release_time, 6) +
                     "; must be 0 or more");
  }
  Sequence sequence(terrain, zones, shapes, blocks, settings, observers);
  if (from) sequence.restore(*from);
  return sequence.run();
}

}  // namespace clast
