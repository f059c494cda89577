#include "classify/long_axes.hpp"

#include "classify/axis_orientation.hpp"

namespace clast {

LongAxisTrends summarise_long_axes(std::span<const MeasuredBlock> blocks) {
  LongAxisTrends all;
  for (const MeasuredBlock& block : blocks) {
    if (!block.deposit || block.axes.L < kLeastElongation * block.axes.I) continue;
    all.trends.push_back(axis_orientation(block.deposit->long_axis).trend);
  }
  all.mean = axial_mean(all.trends);
  all.p_value = rayleigh_p_value(all.mean);
  return all;
}

}  // namespace clast
