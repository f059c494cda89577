#pragma once
/// How groups of runs fare along the slope: energy, speed and height against distance.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Runs of a group that came by at a distance. Each run counts once in a bin, with its largest
/// value there.
struct ProfileBin {
  std::size_t group = 0;  ///< into Comparison::groups
  double from = 0.0;      ///< m along downslope from the run's own release point
  double to = 0.0;
  std::size_t runs = 0;
  Summary energy;  ///< J
  Summary speed;   ///< m/s
  Summary height;  ///< of the centre above the ground, m: the envelope of passing heights
  Vec2 place = Vec2::Zero();  ///< map, m: mean of the runs' mean places here, the mean path
};

/// By group, then distance; from the stored trajectories, so empty where there are none. Bins are
/// about a fiftieth of the longest runout and at least 0.5 m, a round number of metres.
std::vector<ProfileBin> profiles(const Comparison& comparison);

/// Where a barrier would meet the least energy while it still meets blocks: beyond the first peak
/// of energy, of the bins that at least half of the `started` runs of a group come by, the one with
/// the smallest 95th percentile. None where there is no such bin.
const ProfileBin* least_energy_place(const std::vector<ProfileBin>& bins, std::size_t group,
                                     std::size_t started);

}  // namespace clast
