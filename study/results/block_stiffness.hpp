#pragma once
/// Contact stiffness of each block, over its runs.
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "study/results/results.hpp"

namespace clast {

/// Range of values; `low` exceeds `high` if it is empty.
struct ValueRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value);  ///< extends the range to contain a value; NaN is ignored
  bool empty() const { return low > high; }
};

/// Range of one stiffness quantity of a block.
struct StiffnessRange {
  std::string name;     ///< name of the quantity, such as "stiffness_n_m"
  std::string heading;  ///< heading with unit, such as "k_n, N/m"
  ValueRange range;     ///< range over the runs of the block
};

/// Contact stiffness and related quantities of a block, as ranges over its runs.
struct BlockStiffnessRanges {
  std::string block;
  std::size_t runs = 0;
  /// Ranges of normal, tangential and rolling stiffness, time step, settled depth, impact depth,
  /// and the rotation at which the rolling resistance reaches its maximum.
  std::vector<StiffnessRange> values;
};

/// Collects the stiffness ranges of each block. They are empty for blocks without runs.
/// @param header  header with blocks and ground parameters
/// @param runs  planned or finished runs
std::vector<BlockStiffnessRanges> collect_stiffness_by_block(const CampaignHeader& header,
                                                             std::span<const RunRecord> runs);
BlockStiffnessRanges combine_stiffness(std::span<const BlockStiffnessRanges> blocks);

/// Formats the stiffness ranges of a block, such as "2.1e+06 to 3.4e+06", or "-" if empty.
std::vector<std::string> format_stiffness_cells(const BlockStiffnessRanges& block);

}  // namespace clast
