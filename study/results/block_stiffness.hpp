#pragma once
/// How stiff the contacts of each block are, over its runs.
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "study/results/results.hpp"

namespace clast {

/// Smallest and largest of some values; `low` above `high` where there is none.
struct ValueRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value);  ///< not a number is none
  bool empty() const { return low > high; }
};

/// One quantity of `BlockStiffness`.
struct StiffnessRange {
  std::string name;     ///< as the column of /runs: "stiffness_n_m"; or "rolling_limit_deg"
  std::string heading;  ///< "k_n, N/m"
  ValueRange range;     ///< over the runs of the block
};

/// What the runs of a block have. They differ where its ground differs from member to member of an
/// ensemble, and where the fall from one release point could end faster than "auto" allows for.
struct BlockStiffness {
  std::string block;
  std::size_t runs = 0;
  /// k_n, k_t, k_r, time step, settled depth, impact depth, and the turn of the block after which
  /// rolling resistance is at its limit mu_R l f in the deepest impact, l = S/2, f = k_n h. k_r and
  /// that turn are over the ground zones too.
  std::vector<StiffnessRange> values;
};

/// Every block, in order; one without runs has empty ranges.
/// @param header  blocks and ground
/// @param runs    planned or done
std::vector<BlockStiffness> collect_stiffness_by_block(const CampaignHeader& header,
                                               std::span<const RunRecord> runs);
/// Of the runs of all of them, as if they were one block's.
BlockStiffness over_all(std::span<const BlockStiffness> blocks);

/// The quantities as text, in order: "9.52e+07", "2.1e+06 to 3.4e+06", or "-" for none.
std::vector<std::string> format_stiffness_cells(const BlockStiffness& block);

}  // namespace clast
