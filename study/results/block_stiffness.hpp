#pragma once
/// Contact stiffness of each block, over its runs.
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "study/results/results.hpp"

namespace clast {

/// Range of values. If it is empty, `low` exceeds `high`.
struct ValueRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value);  ///< ignores NaN
  bool empty() const { return low > high; }
};

/// Range of one stiffness quantity of a block.
struct StiffnessRange {
  std::string name;     ///< column of /runs, such as "stiffness_n_m", or "rolling_limit_deg"
  std::string heading;  ///< heading with unit, such as "k_n, N/m"
  ValueRange range;     ///< over the runs of the block
};

/// Stiffness quantities of the runs of a block. They vary if ground parameters vary between
/// ensemble members, or if a fall from a release point can be too fast for the automatic stiffness.
struct BlockStiffnessRanges {
  std::string block;
  std::size_t runs = 0;
  /// Ranges of k_n, k_t, k_r, time step, settled depth, impact depth and rolling limit. The rolling
  /// limit is the rotation at which the rolling resistance reaches its maximum mu_R l k_n h, where
  /// l = S/2 and h is the impact depth. k_r and the rolling limit also vary over ground zones.
  std::vector<StiffnessRange> values;
};

/// Collects the ranges for each block, in the order of the blocks. Empty for blocks without runs.
/// @param header  header with blocks and ground
/// @param runs  planned or finished runs
std::vector<BlockStiffnessRanges> collect_stiffness_by_block(const CampaignHeader& header,
                                                             std::span<const RunRecord> runs);
BlockStiffnessRanges combine_stiffness(std::span<const BlockStiffnessRanges> blocks);

/// Formats the ranges as "9.52e+07", "2.1e+06 to 3.4e+06", or "-" if empty.
std::vector<std::string> format_stiffness_cells(const BlockStiffnessRanges& block);

}  // namespace clast
