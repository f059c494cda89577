#pragma once
/// Contact stiffness of each block, over its runs.
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "study/results/results.hpp"

namespace clast {

/// Range of values; `low` exceeds `high` if empty.
struct ValueRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value);  ///< ignores NaN
  bool empty() const { return low > high; }
};

/// Range of one stiffness quantity of a block.
struct StiffnessRange {
  std::string name;     ///< column of /runs: "stiffness_n_m"; or "rolling_limit_deg"
  std::string heading;  ///< "k_n, N/m"
  ValueRange range;     ///< over the runs of the block
};

/// Stiffness quantities of the runs of a block. They vary if ground parameters vary between
/// ensemble members, or if a fall from one release point can be faster than the automatic stiffness
/// allows for.
struct BlockStiffness {
  std::string block;
  std::size_t runs = 0;
  /// Ranges of k_n, k_t, k_r, time step, settled depth, impact depth, and the rotation at which
  /// rolling resistance reaches its limit mu_R l f in the deepest impact, with l = S/2 and f = k_n
  /// h. k_r and that rotation vary over ground zones, too.
  std::vector<StiffnessRange> values;
};

/// Collects the ranges for each block in order; empty ranges if it has no runs.
/// @param header  with blocks and ground
/// @param runs  planned or done
std::vector<BlockStiffness> collect_stiffness_by_block(const CampaignHeader& header,
                                                       std::span<const RunRecord> runs);
BlockStiffness combine_stiffness(std::span<const BlockStiffness> blocks);

/// Formats the ranges: "9.52e+07", "2.1e+06 to 3.4e+06", or "-" if empty.
std::vector<std::string> format_stiffness_cells(const BlockStiffness& block);

}  // namespace clast
