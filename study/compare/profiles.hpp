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
  double from = 0.0;      ///< start of the bin: downslope distance from the release point, m
  double to = 0.0;        ///< end of the bin, m
  std::size_t runs = 0;
  SampleSummary energy;          ///< kinetic energy, J
  SampleSummary speed;           ///< speed, m/s
  SampleSummary height;          ///< height of the centre above the ground, m
  Vec2 position = Vec2::Zero();  ///< mean position of the runs in the bin, map coordinates, m
};

/// Computes energy, speed and height of all groups in distance bins, ordered by group, then
/// distance. Empty if no trajectories are stored.
std::vector<ProfileBin> compute_profiles(const Comparison& comparison);

/// Finds the bin in which a barrier would receive the least energy, behind the first peak of the
/// energy. At least half of the `started` runs must pass it. Null if there is no such bin.
const ProfileBin* find_least_energy_bin(const std::vector<ProfileBin>& bins, std::size_t group,
                                        std::size_t started);

}  // namespace clast
