#pragma once
/// Computing time of a run, estimated from its first part.
#include <cstddef>

namespace clast::study_detail {

/// State of a trial run.
struct ProbedState {
  double time = 0.0;       ///< simulated time, s
  double computed = 0.0;   ///< computing time, s
  std::size_t moving = 0;  ///< number of blocks that are not at rest
};

/// Estimates the computing time that is left in a run, s.
///
/// The computing time per simulated time is proportional to the number n of moving blocks, which
/// decays exponentially. If n fell from n1 to n2 in a simulated time dt, whose computing time was
/// c, the simulated time t that is left takes c n2 / (n1 - n2) (1 - (n2/n1)^(t/dt)); if n does not
/// decrease, it takes c t/dt.
/// @param earlier  state before `now` in the same run
/// @param left  simulated time from `now` to the time limit, s
double estimate_remaining_time(const ProbedState& earlier, const ProbedState& now, double left);

}  // namespace clast::study_detail
