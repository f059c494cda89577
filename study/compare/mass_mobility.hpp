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
/// another file. The runout of a block at rest is measured downslope from its start.
struct DepositMobility {
  std::uint32_t file = 0;               ///< index of the file with realisations
  std::uint32_t single_block_file = 0;  ///< index of the file with single-block runs
  std::string group;                    ///< "all", or a class such as "class compact"
  std::size_t blocks = 0;               ///< number of blocks at rest in all realisations
  std::size_t runs = 0;                 ///< number of single-block runs at rest
  Summary together_runout;              ///< statistics of the mean runouts of the realisations, m
  Summary alone_runout;  ///< statistics of the mean runouts of the release points, m; if there is
                         ///< one point, of the runouts of its runs
  Contrast difference;   ///< together minus alone, m (`welch_difference`)
  Summary together_toe;  ///< statistics of the largest runouts of the realisations, m
  double start_distance = 0.0;  ///< horizontal distance between the mean start positions, m
  double mass_ratio =
      1.0;  ///< mean mass of the persistent blocks divided by that of the single blocks
  double alone_toe = NAN;  ///< expected largest runout of n single-block runs, where n is the mean
                           ///< number of blocks at rest per realisation, m
};

/// Maximum distance between two mean start positions that are treated as equal, m.
inline constexpr double kMaxSameStartDistance = 5.0;
/// Maximum relative difference of two mean masses that are treated as equal.
inline constexpr double kMaxSameMassDifference = 0.01;

/// Returns the expected maximum of n = `count` draws with replacement from `values`. It is the sum
/// of x_i ((i/N)^n - ((i-1)/N)^n) over the N values x_1 <= ... <= x_N.
/// @param values  not empty
/// @param count  positive, not necessarily an integer
double expected_maximum(std::span<const double> values, double count);

/// Computes the mobility for each pair of a file with persistent blocks and a file with
/// single-block runs. Only library blocks that occur in both files are used. There is one result
/// for all blocks and one for each class (compact, elongated). Results without a block at rest in
/// one of the files are omitted.
std::vector<DepositMobility> compute_mass_mobility(const Comparison& comparison);

}  // namespace clast
