#pragma once
/// What passes a barrier against time, realisation by realisation of blocks that stay: a fence that
/// stops many blocks has to take what comes together. Each run counts once, at the crossing that
/// counts at the barrier, as in the statistics of barriers.
#include <cmath>
#include <functional>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/realisation_curve.hpp"

namespace clast {

/// What passes within a time as long as this counts as together, s; a convention.
inline constexpr double kPassageWindow = 1.0;

/// The passage of a block.
struct BlockCrossing {
  std::size_t row = 0;  ///< into Comparison::rows
  double time = 0.0;    ///< since the first block of the realisation was released, s
  double mass = 0.0;    ///< of the block, kg
  double volume = 0.0;  ///< of the block, m^3
  double energy = 0.0;  ///< translational and rotational, J
};

/// A sum over passages.
using CrossingValue = std::function<double(const BlockCrossing&)>;

/// The most that passes within `kPassageWindow`.
struct WindowMaximum {
  double value = 0.0;
  double from = NAN;  ///< passage that the first such window begins with, s
};
/// @param passages  in order of time
WindowMaximum find_window_maximum(const std::vector<BlockCrossing>& passages, double window,
                           const CrossingValue& value);

/// The passages of one barrier in one realisation.
struct RealisationCrossings {
  std::size_t line = 0;  ///< into Comparison::lines
  std::uint32_t file = 0;
  std::uint32_t realisation = 0;       ///< from 0
  std::size_t blocks = 0;              ///< released
  std::vector<BlockCrossing> passages;  ///< in order of time
  WindowMaximum most_blocks, most_mass, most_energy;
  double largest_energy = 0.0;  ///< of a block, J

  double sum(const CrossingValue& value) const;
  double first() const { return passages.empty() ? NAN : passages.front().time; }
  double last() const { return passages.empty() ? NAN : passages.back().time; }
};

/// By barrier, file and realisation; of files that have the barrier, those without a passage too.
std::vector<RealisationCrossings> collect_barrier_crossings(const Comparison& comparison);

/// What has passed until a time, from 0 to the last passage.
/// @param realisations  of one barrier and file
/// @return empty where nothing passed
RealisationCurve passage_curve(const std::vector<const RealisationCrossings*>& realisations,
                               const CrossingValue& value);

}  // namespace clast
