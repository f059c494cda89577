#pragma once
/// Key results of a comparison, shown at the beginning of a report.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Runout of a group of runs, with 95 % confidence intervals. In ensembles, intervals are ranges
/// over the members.
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
  /// Index into Comparison::groups of the group with the larger mean runout.
  std::size_t farther = 0;
  std::size_t nearer = 0;  ///< index into Comparison::groups of the other group
  /// Result of the test of the difference.
  ContrastVerdict verdict = ContrastVerdict::kTooFewValues;
  double mean_difference = 0.0;  ///< difference of the means, m
  /// Interval of the difference, m; empty for a single realisation.
  std::optional<Interval> interval;
  /// True if the difference is due to a few long runouts, so that the medians hardly differ.
  bool due_to_few_runs = false;
};

/// Passing probability of a group of runs at a barrier, with energy, speed and height of the
/// passages.
struct CrossingEstimate {
  std::size_t group = 0;
  std::size_t started = 0;
  std::size_t crossed = 0;
  double passing_probability = 0.0;
  /// Interval of the probability; empty for a single realisation.
  std::optional<Interval> interval;
  /// Kinetic energy of the passages, J. It and the next three members are 95th percentiles, or
  /// maxima if `largest` is true.
  double energy = 0.0;
  double speed = 0.0;    ///< m/s
  double height = 0.0;   ///< height of the centre of mass above the ground, m
  double top = 0.0;      ///< upper bound of the height of the block surface above the ground, m
  bool largest = false;  ///< true if there are fewer than `kMinPassages` passages
  double largest_energy = 0.0;  ///< maximum over the passages, J
  double largest_top = 0.0;     ///< m
  /// Ranges of `energy`, `speed` and `top` over the ensemble members. Empty for one member.
  std::optional<Interval> energy_range, speed_range, top_range;
};

struct BarrierSummary {
  std::size_t line = 0;  ///< index into Comparison::lines
  CrossingEstimate all;
  std::vector<CrossingEstimate> classes;  ///< estimates by shape class (compact, elongated)
};

/// Key results of one file, or of all files together.
struct FileSummary {
  std::optional<std::uint32_t> file;  ///< index into Comparison::results; empty: all files
  StopCounts stops;
  RunoutEstimate all;
  std::vector<RunoutEstimate> classes;           ///< one entry per Garcia class that occurs
  std::optional<RunoutContrast> class_contrast;  ///< difference between the first two shape classes
  /// Summaries of the barriers, the lowest one first, those without passages last.
  std::vector<BarrierSummary> passages;
  /// Number of clusters of dependent runs (release points or realisations) on which the intervals
  /// are based.
  std::size_t clusters = 0;
  bool clusters_are_realisations = false;  ///< true if the clusters are realisations
  std::size_t draws = 0;   ///< number of ensemble members if there are several; otherwise 0
  std::size_t blocks = 0;  ///< number of blocks of the library
  /// True if most blocks occur in only some of the clusters. The intervals then include the
  /// uncertainty due to the choice of blocks.
  bool samples_blocks = false;
};

struct KeyResults {
  /// One summary per file; a single one of all files if each has blocks of one shape class only.
  std::vector<FileSummary> file_summaries;
  /// Runout difference between two files with equal release points; empty for other comparisons.
  std::optional<RunoutContrast> files;

  /// True if any file has several ensemble members.
  bool has_draws() const;
};

/// Limit for `RunoutContrast::due_to_few_runs`. It is true if the difference of the medians is less
/// than this fraction of the difference of the means.
inline constexpr double kMaxFewRunsRatio = 0.25;

/// Minimum number of passages for which a 95th percentile is given.
inline constexpr std::size_t kMinPassages = 20;

KeyResults summarise_key_results(const Comparison& comparison);

}  // namespace clast
