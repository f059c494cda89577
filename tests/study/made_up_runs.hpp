#pragma once
/// Campaigns whose answer is known: runs of two blocks from several release points.
#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "tests/study/hand_made_results.hpp"

namespace clast {

/// What the runs of `made_up_results` are like.
struct MadeUpRuns {
  double compact = 40.0;    ///< mean runout, m
  double elongated = 30.0;  ///< none of them where not finite
  double scatter = 3.0;     ///< m, of runs
  double places = 4.0;      ///< m, of release points
  std::uint32_t points = 8;
  int runs_each = 12;  ///< of each block at each point
  std::uint64_t seed = 1;
};

/// Runs that all come to rest, without crossings.
inline CampaignResults made_up_results(const MadeUpRuns& asked = {}) {
  Random random(asked.seed);
  CampaignResults results = hand_made_results();
  results.blocks[1].mass = results.blocks[0].mass;
  results.ground = {{0.01, 0.7, 0.6}, {0.01, 0.7, 0.6}};
  results.barriers.clear();
  results.crossings.clear();
  results.runs.clear();
  results.release_points.assign(asked.points, Vec3(0.0, 0.0, 2.0));
  std::vector<double> places;
  for (std::uint32_t i = 0; i < asked.points; ++i) places.push_back(asked.places * random.normal());
  for (std::uint32_t point = 0; point < asked.points; ++point) {
    for (std::uint32_t block = 0; block < 2; ++block) {
      const double mean = block == 0 ? asked.compact : asked.elongated;
      for (int i = 0; i < asked.runs_each && std::isfinite(mean); ++i) {
        results.runs.push_back(hand_made_run(static_cast<std::uint32_t>(results.runs.size()), block,
                                             mean + places[point] + asked.scatter * random.normal(),
                                             0.0));
        results.runs.back().point = point;
      }
    }
  }
  results.planned_runs = static_cast<std::uint32_t>(results.runs.size());
  return results;
}

/// A barrier at `x` m, and a crossing of every run that comes so far, with energy 1000 (x_stop - x)
/// J and a height of 1 % of that distance.
inline void add_barrier(CampaignResults& results, const std::string& name, double x) {
  const auto barrier = static_cast<std::uint32_t>(results.barriers.size());
  results.barriers.push_back({name, {Vec2(x, -20.0), Vec2(x, 20.0)}});
  for (const RunRecord& run : results.runs) {
    const double beyond = run.result.final_state.position.x() - x;
    if (!(beyond > 0.0)) continue;
    Crossing crossing = hand_made_crossing(run.run, barrier, 1.0, 2.0);
    crossing.translational_energy = 1000.0 * beyond;
    crossing.rotational_energy = 0.0;
    crossing.height = 0.01 * beyond;
    results.crossings.push_back(crossing);
  }
  std::stable_sort(results.crossings.begin(), results.crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.run < b.run; });
}

/// Makes the runs those of so many realisations of blocks that are released together.
inline void let_stay(CampaignResults& results, std::uint32_t realisations) {
  results.persistent_blocks = {results.planned_runs / realisations, {0.01, 0.5, 0.3}, true};
  results.persistent_block_records.clear();
  for (const RunRecord& run : results.runs)
    results.persistent_block_records.push_back({.run = run.run});
}

/// Draws the ground so many times: run i is of draw i mod `draws`, and stops `farther` m farther
/// for each draw.
inline void draw_ground(CampaignResults& results, std::uint32_t draws, double farther) {
  for (std::uint32_t member = 0; member < draws; ++member) {
    results.ground_sets.push_back(
        {"", member, {{0.01, 0.5 + 0.01 * member, 0.35}, {0.01, 0.3, 0.0}}});
  }
  for (RunRecord& run : results.runs) {
    run.ground_set = run.run % draws;
    run.result.final_state.position.x() += farther * run.ground_set;
  }
}

}  // namespace clast
