#pragma once
/// Energy, speed and height of groups of runs against distance along the slope.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Statistics of the runs of a group within one distance bin. Each run counts once, with its
/// largest value in the bin.
struct ProfileBin {
  std::size_t group = 0;  ///< index into Comparison::groups
  double from =
      0.0;          ///< start of the bin: distance from the release point in downslope direction, m
  double to = 0.0;  ///< end of the bin, m
  std::size_t runs = 0;
  Summary energy;                ///< J
  Summary speed;                 ///< m/s
  Summary height;                ///< height of the centre above the ground, m
  Vec2 position = Vec2::Zero();  ///< mean of the mean positions of the runs in the bin, map, m
};

/// Computes the bins, ordered by group, then distance. Empty if no trajectories are stored. The
/// length of a bin is about 1/50 of the longest runout and at least 0.5 m.
std::vector<ProfileBin> compute_profiles(const Comparison& comparison);

/// Returns the bin in which a barrier would receive the least energy. It is the bin with the
/// smallest 95th percentile of the energy beyond the first energy peak. Only bins that at least
/// half of the `started` runs of the group pass are considered. Null if there is no such bin.
const ProfileBin* find_least_energy_bin(const std::vector<ProfileBin>& bins, std::size_t group,
                                        std::size_t started);

}  // namespace clast
