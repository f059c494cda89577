#include "study/simulate/realisation.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/byte_archive.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "dem/simulation/sequence.hpp"
#include "mesh/triangle_tree.hpp"
#include "study/simulate/detail/confining_walls.hpp"

namespace clast::study_detail {

namespace {

/// Negligible duration, s.
constexpr double kInstant = 1e-9;
/// Between energies where no states are stored, s.
constexpr double kEnergyInterval = 1.0;

// Collects what the stored results need of a motion, as it goes by.
class RunObserver {
 public:
  /// @param body  of the block; must outlive the observer
  RunObserver(const CampaignPlan& prepared, const RunRecord& run, const RigidBody& body)
      : impacts(body, run.run), prepared_(prepared), planned_(run), body_(body) {}

  void observe_step(const MotionStep& step) {
    const double gravity = prepared_.campaign.gravity;
    const double interval = prepared_.campaign.trajectory_interval;
    if (interval > 0.0) add_frames(step, interval, gravity);
    for (std::uint32_t i = 0; i < prepared_.header.barriers.size(); ++i) {
      for (Crossing& crossing :
           find_crossings(prepared_.header.barriers[i], body_, step, *prepared_.surface, gravity)) {
        crossing.run = planned_.run;
        crossing.barrier = i;
        crossings.push_back(crossing);
      }
    }
    impacts.observe_step(step);
    last = step.end;
    last_time = step.end_time;
  }

  /// Returns the run to store, with its final state if that is not on a frame.
  StoredRun stored(const ReleaseResult& result) {
    StoredRun run;
    run.record = planned_;
    run.record.result = result;
    impacts.finish();
    run.record.contacts = impacts.statistics;
    run.impacts = std::move(impacts.impacts);
    run.crossings = std::move(crossings);
    std::stable_sort(run.crossings.begin(), run.crossings.end(),
                     [](const Crossing& a, const Crossing& b) { return a.time < b.time; });
    run.trajectory = std::move(trajectory);
    const double end = std::max(result.duration, last_time);
    if (prepared_.campaign.trajectory_interval > 0.0 &&
        (run.trajectory.time.empty() || run.trajectory.time.back() < end)) {
      run.trajectory.time.push_back(end);
      run.trajectory.states.push_back(result.final_state);
    }
    return run;
  }

  /// All that it has seen.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(trajectory.time, trajectory.states, crossings, impacts, last, last_time, next_frame_);
  }

  Trajectory trajectory;
  std::vector<Crossing> crossings;
  ImpactObserver impacts;
  std::optional<RigidState> last;  ///< end of the last step seen
  double last_time = 0.0;

 private:
  /// Frames are counted, not added up, so that those of all runs fall on the same times.
  void add_frames(const MotionStep& step, double interval, double gravity) {
    const auto add = [&](double time, const RigidState& state) {
      trajectory.time.push_back(time);
      trajectory.states.push_back(state);
    };
    // A block that was held, or at rest among others: none until it moves.
    if (step.begin_time > last_time + interval) {
      if (!last) add(0.0, step.begin);
      next_frame_ = static_cast<std::uint64_t>(std::ceil(step.begin_time / interval));
      add(step.begin_time, step.begin);
      if (static_cast<double>(next_frame_) * interval <= step.begin_time) ++next_frame_;
    }
    for (double time; (time = static_cast<double>(next_frame_) * interval) <= step.end_time;
         ++next_frame_) {
      add(time, time >= step.end_time
                    ? step.end
                    : interpolate_state(body_, step, std::max(time, step.begin_time), gravity));
    }
  }

  const CampaignPlan& prepared_;
  const RunRecord& planned_;
  const RigidBody& body_;
  std::uint64_t next_frame_ = 0;
};

/// Makes the result of a failed run.
ReleaseResult failed(const RunObserver& observer, const RunRecord& run, const char* message) {
  ReleaseResult result;
  result.stop_reason = StopReason::kError;
  result.message = message;
  result.duration = observer.last_time;
  result.final_state = observer.last.value_or(run.start);
  return result;
}

StoredRun single_run(const CampaignPlan& prepared, const RunRecord& planned,
                     const SequenceProgressObserver& after_step, const MotionObserver& observe) {
  const RigidBody body = prepared.bodies[planned.block];
  RunObserver observer(prepared, planned, body);
  try {
    return observer.stored(simulate_release(
        *prepared.surface, prepared.header.ground_sets[planned.ground_set].zones, body,
        planned.start, release_settings(prepared.campaign, planned), [&](const MotionStep& step) {
          observer.observe_step(step);
          if (observe) observe(step);
          if (after_step) after_step({.time = step.end_time, .released = 1});
        }));
  } catch (const std::exception& error) {  // one bad run never costs the campaign
    return observer.stored(failed(observer, planned, error.what()));
  }
}

SequenceSettings sequence_settings(const CampaignPlan& prepared, const RunRecord& run) {
  const Campaign& campaign = prepared.campaign;
  SequenceSettings sequence;
  WorldSettings& settings = sequence.world;
  static_cast<MotionSettings&>(settings) = motion_settings(campaign, run);
  settings.between_bodies = campaign.persistent_blocks->between_blocks;
  sequence.at_once = !campaign.persistent_blocks->masses.empty();
  sequence.max_time = campaign.max_time;
  sequence.energy_interval =
      campaign.trajectory_interval > 0.0 ? campaign.trajectory_interval : kEnergyInterval;
  if (const double time = campaign.persistent_blocks->settling_time(); time > 0.0)
    sequence.settle_time = time;
  const std::vector<std::string>& cleared = campaign.persistent_blocks->cleared_zones;
  for (std::size_t zone = 0; zone < prepared.header.zone_names.size(); ++zone) {
    if (std::find(cleared.begin(), cleared.end(), prepared.header.zone_names[zone]) !=
        cleared.end()) {
      sequence.cleared_zones.push_back(static_cast<std::uint16_t>(zone));
    }
  }
  return sequence;
}

/// Message on the blocks that did not settle, with advice.
std::string not_settled(const CampaignPlan& prepared, std::span<const RunRecord> planned,
                        const SettlingError& error, double settle_time) {
  const RunRecord& first = planned[error.block];
  const std::string& name = prepared.campaign.releases[first.point].name;
  return "[mass]" + (name.empty() ? "" : " " + name) + ": " + format_count(error.count, "block") +
         ", " + prepared.header.blocks[first.block].id + " the first, " +
         (error.left_wall
              ? "left the confining walls behind which they settle; widen the polygon, or give "
                "thickness_m"
              : "still moved after settle_time_s = " + format_significant(settle_time, 6) +
                    "; raise it, or give a rolling_friction or friction with which they come to "
                    "rest");
}

/// The shapes of the blocks of some runs, each once.
struct ShapesOfRuns {
  ShapesOfRuns(const CampaignPlan& prepared, std::span<const RunRecord> runs) {
    std::map<std::uint32_t, std::size_t> place;  // of a body, by the first block that has it
    for (const RunRecord& run : runs) {
      const auto [found, is_new] =
          place.try_emplace(prepared.bodies.first_equal_body(run.block), shapes.size());
      if (is_new) shapes.push_back(prepared.bodies[run.block]);
      of_run.push_back(found->second);
    }
  }
  std::vector<RigidBody> shapes;
  std::vector<std::size_t> of_run;
};

std::vector<StoredRun> realisation(const CampaignPlan& prepared, std::span<const RunRecord> planned,
                                   const SequenceProgressObserver& after_step, unsigned threads,
                                   ByteReader* from) {
  auto [shapes, shape_of_run] = ShapesOfRuns(prepared, planned);
  std::vector<SequenceBlock> blocks;
  std::vector<std::unique_ptr<RunObserver>> observers;
  for (const RunRecord& run : planned) {
    const std::vector<MultiBlockRelease>& masses = prepared.campaign.persistent_blocks->masses;
    const double held = masses.empty() ? 0.0 : masses[run.point].release_time;
    blocks.push_back({shape_of_run[blocks.size()], run.start, held});
  }
  SequenceSettings settings = sequence_settings(prepared, planned.front());
  settings.world.threads = threads;
  ConfiningWalls faces = build_confining_walls(prepared, planned);
  for (ConfiningWall& form : faces.confining_walls) form.shape += shapes.size();
  shapes.insert(shapes.end(), faces.shapes.begin(), faces.shapes.end());
  settings.confining_walls = std::move(faces.confining_walls);
  for (std::size_t i = 0; i < planned.size(); ++i) {
    observers.push_back(
        std::make_unique<RunObserver>(prepared, planned[i], shapes[shape_of_run[i]]));
  }
  std::vector<SequenceResult> results;
  std::vector<EnergyRecord> energies;
  const auto serialize = [&](auto& bytes) {
    for (const std::unique_ptr<RunObserver>& observer : observers) bytes(*observer);
    bytes(energies);
  };
  if (from) serialize(*from);
  const auto with_observers = [&](const SequenceProgress& progress) {
    SequenceProgress all = progress;
    all.save_state = [&](ByteWriter& to) {
      serialize(to);
      progress.save_state(to);
    };
    after_step(all);
  };
  std::string message;
  try {
    results = simulate_sequence(
        *prepared.surface, prepared.header.ground_sets[planned.front().ground_set].zones, shapes,
        blocks, settings,
        {[&](std::size_t block, const MotionStep& step) { observers[block]->observe_step(step); },
         [&](const EnergySample& sample) {
           energies.push_back({planned.front().run, sample});
         },
         after_step ? SequenceProgressObserver(with_observers) : SequenceProgressObserver()},
        from);
  } catch (const SettlingError& error) {
    message = not_settled(prepared, planned, error, settings.settle_time);
  } catch (const std::exception& error) {
    if (from && !from->at_end()) throw InputError(error.what());  // it could not be restored
    message = "the realisation failed (body numbers start at 0, in the order of release): " +
              std::string(error.what());
  }
  std::vector<StoredRun> runs;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    if (results.empty()) {
      runs.push_back(observers[i]->stored(failed(*observers[i], planned[i], message.c_str())));
      continue;
    }
    const SequenceResult& result = results[i];
    runs.push_back(observers[i]->stored(result.release));
    runs.back().record.start.position.z() += result.raise_height;
    if (result.state_after_settling) runs.back().record.start = *result.state_after_settling;
    runs.back().persistent_block_records.push_back(
        {planned[i].run, result.released_at, result.raise_height, result.later_displacement,
         result.blocks_hit, result.removed_at.value_or(std::nan(""))});
  }
  runs.front().energies = std::move(energies);
  return runs;
}

/// Depth of a point in the core of a body, m; 0 outside.
double depth_inside(const RigidBody& body, const RigidState& state, const Vec3& point) {
  const TriangleMesh core = core_mesh(body.shape);
  if (core.triangles.empty()) return 0.0;
  return std::max(0.0,
                  -TriangleTree(core).signed_distance(state.world_from_body().inverse() * point));
}

}  // namespace

void check_multi_block_start(const CampaignPlan& prepared, std::uint32_t first) {
  const std::span runs(&prepared.runs[first], prepared.header.runs_per_realisation());
  WorldSettings settings = sequence_settings(prepared, runs.front()).world;
  const double allowed = std::exchange(settings.start_overlap, 1e300);
  const auto [shapes, shape_of_run] = ShapesOfRuns(prepared, runs);
  World world(shapes, settings, *prepared.surface,
              prepared.header.ground_sets[runs.front().ground_set].zones);
  for (std::size_t i = 0; i < runs.size(); ++i) world.add_body(shape_of_run[i], runs[i].start);
  world.run_until_rest(kInstant);
  std::size_t overlapping = 0;
  std::pair<std::size_t, std::size_t> worst;
  double deepest = 0.0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t other = 0; other < i; ++other) {
      const RigidBody &body = shapes[shape_of_run[i]], &other_body = shapes[shape_of_run[other]];
      const double apart = (runs[i].start.position - runs[other].start.position).norm();
      if (apart >= body.bounding_radius() + other_body.bounding_radius()) continue;
      // One that lies in another touches no surface.
      const double overlap = std::max(
          {world.overlap(i, other), depth_inside(body, runs[i].start, runs[other].start.position),
           depth_inside(other_body, runs[other].start, runs[i].start.position)});
      if (overlap <= allowed * std::min(body.size(), other_body.size())) continue;
      ++overlapping;
      if (overlap <= deepest) continue;
      deepest = overlap;
      worst = {other, i};
    }
  }
  if (overlapping == 0) return;
  const auto id = [&](std::size_t i) { return prepared.header.blocks[runs[i].block].id; };
  throw SimulationError(prepared.campaign.file.string() +
                        ": [mass] in_place: " + format_count(overlapping, "pair") +
                        " of blocks overlap, the largest overlap is that of " + id(worst.first) +
                        " and " + id(worst.second) + ", by " + format_significant(deepest, 3) +
                        " m; select blocks that do not overlap, or cut the mass again");
}

std::vector<StoredRun> simulate_realisation(const CampaignPlan& prepared, std::uint32_t first,
                                            const SequenceProgressObserver& after_step,
                                            unsigned threads, const MotionObserver& observe,
                                            ByteReader* from) {
  if (!prepared.header.persistent_blocks) {
    return {single_run(prepared, prepared.runs[first], after_step, observe)};
  }
  const std::uint32_t each = prepared.header.persistent_blocks->blocks_per_realisation;
  return realisation(prepared, std::span(&prepared.runs[first], each), after_step, threads, from);
}

}  // namespace clast::study_detail
