#pragma once
/// What a comparison says, for a reader of its first lines: a few numbers with their intervals, and
/// whether the data support them.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Where the runs of a group come to rest. Here and below `interval` is the 95 % interval; where
/// the ground is drawn more than once (`FileSummary::draws`) it is the range over the draws instead,
/// as `range_of_draw_means`.
struct RunoutEstimate {
  std::size_t group = 0;  ///< into Comparison::groups
  std::size_t started = 0;
  std::size_t at_rest = 0;
  double mean = 0.0;                 ///< of the runs at rest, m
  std::optional<Interval> interval;  ///< of the mean, m; none of one realisation
  double median = 0.0;               ///< half of the runs at rest stop before, m
  double p95 = 0.0;                  ///< 95 % of the runs at rest stop before, m
  double farthest = 0.0;             ///< m

  /// Enough runs came to rest for their mean to stand for the group.
  bool stands() const { return at_rest >= 3 && 2 * at_rest >= started; }
};

/// Which of two groups runs farther.
struct RunoutContrast {
  std::size_t farther = 0;  ///< into Comparison::groups: the one with the larger mean
  std::size_t nearer = 0;
  /// Too few where few runs, or less than half of a group, came to rest.
  Verdict verdict = Verdict::kTooFewValues;
  double gap = 0.0;                  ///< mean of `farther` less that of `nearer`, m
  std::optional<Interval> interval;  ///< m; none of one realisation
  /// The medians differ far less than the means: some blocks of `farther` run on, most do not.
  bool of_few = false;
};

/// How many runs of a group pass a barrier, and how strongly.
struct CrossingEstimate {
  std::size_t group = 0;
  std::size_t started = 0;
  std::size_t crossed = 0;
  double share = 0.0;
  std::optional<Interval> interval;  ///< of the share; none of one realisation
  /// What 95 % of the passages stay below; from few of them, the largest.
  double energy = 0.0;  ///< J
  double speed = 0.0;   ///< m/s
  double height = 0.0;  ///< of the centre above the ground, m
  double top = 0.0;     ///< as `BarrierGroupStatistics::top`, m
  bool largest = false;
  double largest_energy = 0.0;  ///< of all passages, J
  double largest_top = 0.0;     ///< m
  /// Ranges of `energy`, `speed` and `top` over the draws of the ground that have passages; none of
  /// one draw.
  std::optional<Interval> energy_range, speed_range, top_range;
};

/// One barrier.
struct BarrierSummary {
  std::size_t line = 0;  ///< into Comparison::lines
  CrossingEstimate all;
  std::vector<CrossingEstimate> classes;  ///< those of Garcia that occur, if more than one
};

/// What is said of the runs of one file, or of all of them.
struct FileSummary {
  std::optional<std::uint32_t> file;
  StopCounts stops;
  RunoutEstimate all;
  std::vector<RunoutEstimate> classes;    ///< those of Garcia that occur
  std::optional<RunoutContrast> gap;         ///< between the first two classes
  std::vector<BarrierSummary> passages;  ///< the last that is passed on the way down comes first
  /// Independent places, or realisations, behind the intervals.
  std::size_t clusters = 0;
  bool of_realisations = false;
  std::size_t draws = 0;   ///< of the ground, where it is drawn more than once; else 0
  std::size_t blocks = 0;  ///< of the library
  /// Places or realisations have other blocks, so that the intervals speak of more blocks than
  /// those that ran. Else they cover runs of these blocks only.
  bool samples_blocks = false;
};

struct KeyResults {
  /// One for all files where each class has files of its own, else one for each file.
  std::vector<FileSummary> statements;
  /// Between two files with the same release points.
  std::optional<RunoutContrast> files;

  /// Ground is drawn more than once in a statement.
  bool has_draws() const;
};

/// Medians that differ by less than this share of the gap of the means leave it to few runs.
inline constexpr double kGapOfFew = 0.25;

/// Passages from which on 95 % of them mean something.
inline constexpr std::size_t kFewestPassages = 20;

KeyResults answer(const Comparison& comparison);

}  // namespace clast
