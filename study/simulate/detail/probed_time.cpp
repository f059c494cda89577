#include "study/simulate/detail/probed_time.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/error.hpp"
#include "dem/simulation/release.hpp"

namespace clast::study_detail {

namespace {

// Thrown by a single release that takes too long; no error of the release.
struct SingleReleaseOver {};

/// Time at which the fraction `left` of the single motions has not ended, nearest to `now`.
double time_with_fraction_left(std::span<const MotionInterval> single, double left, double now) {
  std::vector<double> ends;
  for (const MotionInterval& motion : single) ends.push_back(motion.end);
  std::sort(ends.begin(), ends.end());
  const auto count = static_cast<double>(ends.size());
  const double moving = std::clamp(std::ceil(left * count - 1e-9), 1.0, count);
  const std::size_t stopped = ends.size() - static_cast<std::size_t>(moving);
  return std::clamp(now, stopped > 0 ? ends[stopped - 1] : 0.0, ends[stopped]);
}

}  // namespace

double evenly_spread_fraction(std::size_t i) {
  constexpr double kGoldenRatio = 0.61803398874989485;
  return std::fmod(0.5 + static_cast<double>(i) * kGoldenRatio, 1.0);
}

std::vector<MotionInterval> release_blocks_singly(const CampaignPlan& prepared, std::uint32_t first,
                                                  std::size_t most, double budget) {
  const std::size_t together = prepared.header.runs_per_realisation();
  const std::size_t count = std::min(most, together);
  const auto begin = std::chrono::steady_clock::now();
  const auto check_budget = [&](const MotionStep&) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    if (spent.count() > budget) throw SingleReleaseOver();
  };
  std::vector<MotionInterval> motions;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = evenly_spread_fraction(i) * static_cast<double>(together);
    const RunRecord& run = prepared.runs[first + static_cast<std::size_t>(place)];
    try {
      const ReleaseResult result =
          simulate_release(*prepared.surface, prepared.header.ground_sets[run.ground_set].zones,
                           prepared.bodies[run.block], run.start,
                           release_settings(prepared.campaign, run), check_budget);
      if (result.stop_reason == StopReason::kError) continue;
      const double release = prepared.campaign.persistent_blocks->masses[run.point].release_time;
      motions.push_back({release, release + result.duration});
    } catch (const SingleReleaseOver&) {
      break;
    } catch (const Error&) {  // in the ground without the blocks that carry it
      continue;
    }
  }
  return motions;
}

double estimate_remaining_time(const ProbedState& earlier, const ProbedState& now,
                               double first_release, std::size_t blocks,
                               std::span<const MotionInterval> single) {
  const double block_time = 0.5 * static_cast<double>(earlier.moving + now.moving) *
                            std::max(now.time - earlier.time, 1e-12);
  if (block_time == 0.0 || now.finished >= blocks) return 0.0;
  const double cost = (now.computed - earlier.computed) / block_time;
  const double left = static_cast<double>(blocks - now.finished) / static_cast<double>(blocks);
  const double begin = time_with_fraction_left(single, left, now.time - first_release);
  double block_time_left = 0.0;
  for (const MotionInterval& motion : single) {
    block_time_left += std::max(0.0, motion.end - std::max(begin, motion.release));
  }
  return cost * block_time_left * static_cast<double>(blocks) / static_cast<double>(single.size());
}

}  // namespace clast::study_detail
