#pragma once
/// Runout of many blocks released together, compared with single blocks.
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/statistics/mean_intervals.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// Runout of persistent blocks in the realisations of one file, compared with that of single blocks
/// in another file. It is measured downslope from the start of each block.
struct DepositMobility {
  std::uint32_t file = 0;               ///< index of the file with realisations
  std::uint32_t single_block_file = 0;  ///< index of the file with single-block runs
  std::string group;                    ///< "all", or a class such as "class compact"
  std::size_t blocks = 0;               ///< number of blocks at rest in all realisations
  std::size_t runs = 0;                 ///< number of single-block runs at rest
  SampleSummary together_runout;        ///< statistics of the mean runouts of the realisations, m
  SampleSummary
      alone_runout;     ///< statistics of the mean runouts of single blocks by release point, m
  Contrast difference;  ///< difference of the mean runouts: blocks together minus single blocks, m
  SampleSummary together_toe;   ///< statistics of the largest runouts of the realisations, m
  double start_distance = 0.0;  ///< horizontal distance between the mean start positions, m
  /// Mean mass of the persistent blocks divided by that of the single blocks.
  double mass_ratio = 1.0;
  /// Expected largest runout of n single-block runs, m; n is `blocks` per realisation.
  double alone_toe = NAN;
};

/// Maximum distance between two mean start positions that are treated as equal, m.
inline constexpr double kMaxSameStartDistance = 5.0;
/// Maximum relative difference of two mean masses that are treated as equal.
inline constexpr double kMaxSameMassDifference = 0.01;

/// Returns the expected maximum of `count` random draws from `values`, with replacement.
/// @param values  not empty
/// @param count  positive, not necessarily an integer
double expected_maximum(std::span<const double> values, double count);

/// Compares the runouts of each file with persistent blocks and each file with single blocks, for
/// all blocks and for each shape class. Only library blocks that occur in both files are used.
std::vector<DepositMobility> compute_mass_mobility(const Comparison& comparison);

}  // namespace clast
