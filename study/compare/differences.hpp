#pragma once
/// Differences between groups of runs: how large, how sure, in words.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/group_differences.hpp"

namespace clast {

struct Comparison;

/// Two groups of one kind in one quantity.
struct Difference {
  std::size_t first = 0;  ///< index into Comparison::groups
  std::size_t second = 0;
  std::string quantity;        ///< "runout_m", "EC11 speed_m_s"
  std::size_t first_runs = 0;  ///< with the quantity
  std::size_t second_runs = 0;
  std::size_t points = 0;  ///< clusters of interval and test that either has: release points,
                           ///< or realisations where blocks stay
  /// Runs are drawn by themselves: there is one release point, or one of its own for each group.
  bool by_runs = false;
  double first_mean = 0.0;
  double second_mean = 0.0;
  /// 95 %, of first_mean - second_mean; none where a group is of one realisation.
  std::optional<Interval> interval;
  double cliffs_delta = 0.0;  ///< first against second
  std::optional<double> hedges_g;
  double ks_distance = 0.0;
  /// Of Kolmogorov's and Smirnov's test, clusters kept (clustered_ks); none where a group is of one
  /// realisation, which gives no test.
  std::optional<double> p_value;
  std::optional<double> p_holm;  ///< ... corrected for all differences of the same kind of group
  std::size_t tests = 0;         ///< that it was corrected for

  bool found() const { return p_holm && *p_holm < 0.05; }
  bool interval_excludes_zero() const {
    return interval && (interval->low > 0.0 || interval->high < 0.0);
  }
};

/// Groups of one kind beyond this are not compared pair by pair.
inline constexpr std::size_t kMostGroups = 12;

/// All pairs of blocks, of classes and of the groups of every column, over all files. Of each pair:
/// runout, lateral angle and path length of the runs that came to rest, largest speed of all that
/// did not fail, and speed, energy and height at first crossings of every barrier. Pairs of which a
/// group has fewer than three values are left out.
std::vector<Difference> differences(const Comparison& comparison);

/// The runouts of any two groups, alone: `p_holm` is `p_value`.
/// @return none where a group has fewer than three runs at rest
std::optional<Difference> runout_difference(const Comparison& comparison, std::size_t first,
                                            std::size_t second);

/// What a difference means.
enum class Evidence {
  kOneRealisation,  ///< a group is of one realisation, which can't tell what is chance
  kMoreThanChance,  ///< the means differ by more than chance gives
  kOtherSpread,  ///< values are distributed in another way, the means do not differ beyond chance
  kCanBeChance,  ///< it can be chance
};

/// One realisation where there is no test; more than chance where the test, corrected for all that
/// were made, is below 5 % and the interval excludes zero.
Evidence evidence_of(const Difference& difference);

/// A quantity as readers know it: "EC11 total_energy_j" is "energy at EC11", in kJ.
struct QuantityWords {
  std::string name;
  std::string unit;
  double factor = 1.0;  ///< on values
};
QuantityWords words_of_quantity(const std::string& quantity);

/// "13 m more (10 to 17 m)", or "less": of the first group, with the decimals that its interval
/// leaves.
std::string gap_in_words(const Difference& difference);
/// The same of a gap with its interval, both in `unit`; the unit can be empty.
std::string gap_in_words(double gap, const std::optional<Interval>& interval,
                         const std::string& unit);

/// A sentence to quote.
std::string in_words(const Difference& difference, const Comparison& comparison);

}  // namespace clast
