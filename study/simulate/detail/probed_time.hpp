#pragma once
/// Computing time of a run or realisation, estimated from its first part.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Returns the i-th fraction, in [0, 1), of a sequence that is spread evenly wherever it ends.
double evenly_spread_fraction(std::size_t i);

/// State of a trial run.
struct ProbedState {
  double time = 0.0;         ///< simulated time, s
  double computed = 0.0;     ///< computing time, s
  std::size_t moving = 0;    ///< number of released blocks that are not at rest
  std::size_t finished = 0;  ///< number of blocks that are at rest or removed
};

/// Interval in which a block moves; times from the first release of its realisation, s.
struct MotionInterval {
  double release = 0.0;
  double end = 0.0;  ///< end of the motion or time limit
};

/// Releases some blocks of a simultaneous release one by one, each without the others, from their
/// places in the mass. This takes a few hundredths of a second a block. The blocks are
/// spread evenly over the realisation. Blocks that cannot be released alone are left out.
/// @param first  index of the first run of the realisation
/// @param most  largest number of blocks
/// @param budget  computing time after which no further motion is added, s
std::vector<MotionInterval> release_blocks_singly(const CampaignPlan& prepared, std::uint32_t first,
                                                  std::size_t most, double budget);

/// Estimates the computing time that is left in a realisation of N blocks, s.
///
/// The computing time per simulated time is proportional to the number of moving blocks. The factor
/// c is that between `earlier` and `now`. Blocks released singly show how long each moves. Contacts
/// among the blocks delay the first stops, because a block rests only when those that it touches
/// rest. So the fraction of blocks that still move follows that of the n single blocks, S(t), with
/// a shift in time: it continues from the time s, nearest to the present one, at which S(s) is the
/// fraction observed now. The computing time that is left is
///
///   c (N/n) sum_i max(0, e_i - max(s, r_i))
///
/// for single motions from r_i to e_i. The estimates for fifteen heaps of 20 to 200 blocks, stopped
/// after a tenth or more of their computing time, were 0.45 to 1.6 times that time. They are lowest
/// on flat ground, where the blocks of a heap come to rest later than single ones.
/// @param earlier  state before `now` in the same realisation
/// @param first_release  simulated time of the first release, s; `now.time` if blocks still settle
/// @param blocks  N
/// @param single  motions of single blocks, at least one; one motion that ends at the time limit
///                gives an upper bound
double estimate_remaining_time(const ProbedState& earlier, const ProbedState& now,
                               double first_release, std::size_t blocks,
                               std::span<const MotionInterval> single);

}  // namespace clast::study_detail
