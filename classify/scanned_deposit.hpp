#pragma once
/// Statistics of the population of a deposit whose surface was scanned.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "classify/long_axes.hpp"
#include "classify/population_summary.hpp"
#include "classify/visibility_correction.hpp"
#include "core/statistics/statistics.hpp"

namespace clast {

/// Weight of each found block in the sizes of a deposit.
enum class SizeWeighting {
  kNumber,     ///< 1
  kArea,       ///< area of the body in plan
  kGrid,       ///< exposed area: the blocks under the points of a grid (Wolman)
  kCorrected,  ///< 1 over the probability that a block of this size is found
};
inline constexpr std::array kSizeWeightings = {SizeWeighting::kNumber, SizeWeighting::kArea,
                                               SizeWeighting::kGrid, SizeWeighting::kCorrected};
/// Returns the name of a weighting: "number", "area", "grid" or "corrected".
std::string name_of(SizeWeighting weighting);

/// Sizes of which percentiles are computed: L, I, S (m) and volume (m^3).
inline constexpr std::array kWeightedQuantities = {"L", "I", "S", "volume"};
/// Percentiles of sizes, and their names.
inline constexpr std::array kWeightedPercentiles = {0.16, 0.50, 0.84, 0.95};
inline constexpr std::array kWeightedPercentileNames = {"D16", "D50", "D84", "P95"};

/// Estimated value with its 95 % interval.
struct EstimatedValue {
  double value = 0.0;
  Interval interval = {};
};

/// Percentiles of sizes by one weighting: `percentiles[quantity][percentile]`.
struct WeightedSizes {
  SizeWeighting weighting = SizeWeighting::kNumber;
  std::array<std::array<EstimatedValue, kWeightedPercentiles.size()>, kWeightedQuantities.size()>
      percentiles;
};

/// Fraction of one class by number.
struct CorrectedFraction {
  std::string name;
  EstimatedValue found;      ///< of the blocks that were found
  EstimatedValue corrected;  ///< of all blocks of the deposit
};
struct CorrectedSchemeFractions {
  std::string scheme;
  std::vector<CorrectedFraction> fractions;
};

struct ScannedDepositSummary {
  std::size_t blocks = 0;        ///< number of found blocks
  double expected_blocks = 0.0;  ///< sum of their confidences
  VisibilityCorrection correction;
  /// Number of blocks of the deposit that are as large as the smallest found one.
  EstimatedValue corrected_blocks;
  std::array<WeightedSizes, kSizeWeightings.size()> sizes;
  std::vector<CorrectedSchemeFractions> schemes;
  LongAxisTrends long_axes;
};

/// Computes the statistics of the blocks of a deposit.
///
/// Percentiles and numbers are those of the median sizes (`median_block_sizes`), fractions of
/// classes are means of random replicates, and intervals are those of the replicates. In each,
/// sizes are drawn from their intervals (`draw_block_sizes`), blocks are kept with the probability
/// of their confidence, and the number of bodies that each stands for varies as it does if bodies
/// of a finite deposit are found independently of each other (docs/theory/deposits.md).
/// @return empty if fewer than `kLeastCorrectedBlocks` scaled blocks have an observation, or if all
/// have a confidence of 0
/// @param threads  number of threads, 0: one per core; does not affect the result
std::optional<ScannedDepositSummary> summarise_scanned_deposit(const Population& population,
                                                               const PopulationOptions& options,
                                                               unsigned threads = 0);

}  // namespace clast
