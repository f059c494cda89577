#pragma once
/// Key results of a comparison: the few numbers with intervals that open a report.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Runout of a group of runs. Intervals in this header are 95 % confidence intervals. If the ground
/// is drawn more than once, they are ranges over the draws (`compute_range_over_draws`).
struct RunoutEstimate {
  std::size_t group = 0;             ///< index into Comparison::groups
  std::size_t started = 0;           ///< number of runs
  std::size_t at_rest = 0;           ///< number of runs that came to rest
  double mean = 0.0;                 ///< mean runout of the runs at rest, m
  std::optional<Interval> interval;  ///< interval of the mean, m; empty for a single realisation
  double median = 0.0;               ///< median runout of the runs at rest, m
  double p95 = 0.0;                  ///< 95th percentile of the runout of the runs at rest, m
  double farthest = 0.0;             ///< largest runout of the runs at rest, m

  /// True if at least three runs, and at least half of all runs, came to rest.
  bool is_representative() const { return at_rest >= 3 && 2 * at_rest >= started; }
};

/// Difference in mean runout between two groups.
struct RunoutContrast {
  std::size_t farther = 0;  ///< index into Comparison::groups of the group with the larger mean
  std::size_t nearer = 0;   ///< index of the other group
  /// Result of the test. `kTooFewValues` if one of the groups is not representative.
  Verdict verdict = Verdict::kTooFewValues;
  double mean_difference = 0.0;  ///< difference of the means, m
  std::optional<Interval>
      interval;  ///< interval of the difference, m; empty for a single realisation
  /// True if the difference is due to a few long runouts. The medians then differ by less than
  /// `kMaxFewRunsRatio` times the difference of the means.
  bool due_to_few_runs = false;
};

/// Passing probability of a group at a barrier, and the intensity of its passages.
struct CrossingEstimate {
  std::size_t group = 0;
  std::size_t started = 0;
  std::size_t crossed = 0;
  double passing_probability = 0.0;
  std::optional<Interval>
      interval;  ///< interval of the probability; empty for a single realisation
  /// The following four are 95th percentiles over the passages, or maxima if `largest` is true.
  double energy = 0.0;   ///< J
  double speed = 0.0;    ///< m/s
  double height = 0.0;   ///< of the centre of mass above the ground, m
  double top = 0.0;      ///< upper bound of the block surface (`BarrierGroupStatistics::top`), m
  bool largest = false;  ///< true if there are fewer than `kMinPassages` passages
  double largest_energy = 0.0;  ///< maximum over the passages, J
  double largest_top = 0.0;     ///< m
  /// Ranges of `energy`, `speed` and `top` over the ground draws with passages. Empty for one draw.
  std::optional<Interval> energy_range, speed_range, top_range;
};

struct BarrierSummary {
  std::size_t line = 0;  ///< index into Comparison::lines
  CrossingEstimate all;
  std::vector<CrossingEstimate> classes;  ///< one entry per Garcia class that occurs
};

/// Key results of one file, or of all files together.
struct FileSummary {
  std::optional<std::uint32_t> file;  ///< index into Comparison::results; empty: all files
  StopCounts stops;
  RunoutEstimate all;
  std::vector<RunoutEstimate> classes;           ///< one entry per Garcia class that occurs
  std::optional<RunoutContrast> class_contrast;  ///< between the first two classes
  std::vector<BarrierSummary>
      passages;  ///< one entry per barrier, the lowest one first; barriers without passages last
  /// Number of independent clusters (release points or realisations) behind the intervals.
  std::size_t clusters = 0;
  bool clusters_are_realisations = false;  ///< true if the clusters are realisations
  std::size_t draws = 0;   ///< number of ground draws if there is more than one; otherwise 0
  std::size_t blocks = 0;  ///< number of blocks of the library
  /// True if clusters have different blocks. Intervals then include the uncertainty due to the
  /// sampling of blocks. Otherwise, they are valid for these blocks only.
  bool samples_blocks = false;
};

struct KeyResults {
  /// One entry per file. If each file has blocks of one class only, one entry for all files.
  std::vector<FileSummary> file_summaries;
  /// Runout difference between the files. Only for exactly two files with equal release points.
  std::optional<RunoutContrast> files;

  /// True if any entry has more than one ground draw.
  bool has_draws() const;
};

/// Upper limit of the ratio of the differences of medians and of means for `due_to_few_runs`.
inline constexpr double kMaxFewRunsRatio = 0.25;

/// Minimum number of passages for which a 95th percentile is given.
inline constexpr std::size_t kMinPassages = 20;

KeyResults summarise_key_results(const Comparison& comparison);

}  // namespace clast
