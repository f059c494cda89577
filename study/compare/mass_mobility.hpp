#pragma once
/// How far blocks go that stay together, against the same blocks alone: where files of both are
/// compared.
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/statistics/mean_intervals.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// Blocks that lie in realisations of one file, against runs of another whose blocks had the
/// terrain to themselves. Runouts are of blocks that came to rest, along downslope from the start
/// of each.
struct DepositMobility {
  std::uint32_t file = 0;   ///< of realisations
  std::uint32_t alone = 0;  ///< file of single runs
  std::string group;        ///< "all", or "class compact"
  std::size_t blocks = 0;   ///< in all realisations
  std::size_t runs = 0;     ///< of single blocks
  Summary together_runout;  ///< over realisations, of the mean of each, m
  Summary
      alone_runout;     ///< over release points, of the mean of each, m; over the runs of one point
  Contrast difference;  ///< together less alone, m; as `welch_difference`
  Summary together_toe;       ///< over realisations, of the largest runout, m
  double starts_apart = 0.0;  ///< distance in plan of the mean starts of both, m
  double mass_ratio = 1.0;    ///< mean mass of the blocks together over that of those alone
  double alone_toe = NAN;     ///< expected largest of as many single runs as realisations have, m
};

/// Mean starts up to this distance are the same place, m.
inline constexpr double kSameStart = 5.0;
/// Mean masses that differ by up to this share are the same.
inline constexpr double kSameMass = 0.01;

/// The expected largest of `count` draws with replacement out of `values`: the sum of x_i ((i/N)^n
/// -
/// ((i - 1)/N)^n) over the N values in rising order.
/// @param values  not empty
/// @param count   positive, not necessarily whole
double expected_largest(std::span<const double> values, double count);

/// Every file of realisations against every file of single runs, over the blocks of the library
/// that both have; of all blocks and of each class (compact, elongated). Groups without a block at
/// rest in either are left out.
std::vector<DepositMobility> compute_mass_mobility(const Comparison& comparison);

}  // namespace clast
