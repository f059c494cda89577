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
  double from = 0.0;      ///< start of the bin, m along downslope from the run's release point
  double to = 0.0;        ///< end of the bin, m
  std::size_t runs = 0;
  Summary energy;  ///< J
  Summary speed;   ///< m/s
  Summary height;  ///< of the centre above the ground, m: the envelope of passing heights
  Vec2 place =
      Vec2::Zero();  ///< mean path: mean of the runs' mean positions in the bin, map coordinates, m
};

/// Computes the bins by group, then distance; empty without stored trajectories. Bins have about
/// 1/50 of the longest runout, rounded, and at least 0.5 m.
std::vector<ProfileBin> compute_profiles(const Comparison& comparison);

/// Returns the bin in which a barrier would meet the least energy: the one with the smallest 95th
/// percentile beyond the first energy peak, among bins passed by at least half of the `started`
/// runs of a group. Null if there is none.
const ProfileBin* find_least_energy_position(const std::vector<ProfileBin>& bins, std::size_t group,
                                             std::size_t started);

}  // namespace clast
