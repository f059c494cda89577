#pragma once
/// Mobility of multi-block releases, compared with single blocks.
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/statistics/mean_intervals.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// Runout of persistent blocks in the realisations of one file, compared with single-block runs of
/// another file. Runouts are those of blocks at rest, along the downslope direction from each
/// start.
struct DepositMobility {
  std::uint32_t file = 0;   ///< index of the file with realisations
  std::uint32_t alone = 0;  ///< index of the file with single-block runs
  std::string group;        ///< "all", or "class compact"
  std::size_t blocks = 0;   ///< over all realisations
  std::size_t runs = 0;     ///< number of single-block runs
  Summary together_runout;  ///< mean runout of each realisation, over the realisations, m
  Summary alone_runout;  ///< mean runout of each release point, over the points, m; over the runs
                         ///< if there is one point
  Contrast difference;   ///< together minus alone, m (`welch_difference`)
  Summary together_toe;  ///< largest runout of each realisation, over the realisations, m
  double starts_apart = 0.0;  ///< horizontal distance between the mean starts, m
  double mass_ratio = 1.0;    ///< mean block mass together over mean block mass alone
  double alone_toe =
      NAN;  ///< expected largest runout of as many single runs as a realisation has blocks, m
};

/// Maximum distance between mean starts that count as equal, m.
inline constexpr double kSameStart = 5.0;
/// Maximum relative difference of mean masses that count as equal.
inline constexpr double kSameMass = 0.01;

/// Returns the expected maximum of `count` draws with replacement from `values`: the sum of x_i
/// ((i/N)^n - ((i-1)/N)^n) over the N ascending values.
/// @param values  not empty
/// @param count  positive, not necessarily an integer
double expected_largest(std::span<const double> values, double count);

/// Computes the mobility for each pair of a file with realisations and a file with single runs,
/// over their common library blocks: for all blocks and for each class (compact, elongated). Groups
/// without a block at rest in either file are omitted.
std::vector<DepositMobility> compute_mass_mobility(const Comparison& comparison);

}  // namespace clast
