#pragma once
/// Orientation of the long axes of blocks.
#include <span>
#include <vector>

#include "classify/measured_block.hpp"
#include "core/statistics/axial_statistics.hpp"

namespace clast {

/// Least L/I of blocks whose long axis is used: those of compact blocks point anywhere.
inline constexpr double kLeastElongation = 1.2;

/// Trends of long axes in a population.
struct LongAxisTrends {
  std::vector<double> trends;  ///< trends of the blocks of a deposit with L/I of `kLeastElongation`
  AxialMean mean;              ///< mean of the undirected trends
  double p_value = 1.0;        ///< Rayleigh test of uniform trends
};

LongAxisTrends summarise_long_axes(std::span<const MeasuredBlock> blocks);

}  // namespace clast
