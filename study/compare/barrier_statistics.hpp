#pragma once
/// Barrier passages against time, for each realisation of persistent blocks. Only the counted
/// crossing of each run is a passage (`BarrierCrossing::counted`).
#include <cmath>
#include <functional>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/realisation_curve.hpp"

namespace clast {

/// Length of the time window within which passages are taken to load a barrier together, s. The
/// value is a convention.
inline constexpr double kPassageWindow = 1.0;

/// Passage of one block at a barrier.
struct BlockCrossing {
  std::size_t row = 0;  ///< index into Comparison::rows
  double time = 0.0;    ///< since the first block of the realisation was released, s
  double mass = 0.0;    ///< kg
  double volume = 0.0;  ///< m^3
  double energy = 0.0;  ///< translational plus rotational kinetic energy, J
};

/// Contribution of one passage to a sum, such as its mass.
using CrossingValue = std::function<double(const BlockCrossing&)>;

/// Time window with the largest sum over its passages.
struct WindowMaximum {
  double value = 0.0;
  double from = NAN;  ///< time of the first passage of that window, s
};
/// Finds the window of length `window` (s) with the largest sum of `value`.
/// @param passages  in order of time
WindowMaximum find_window_maximum(const std::vector<BlockCrossing>& passages, double window,
                                  const CrossingValue& value);

/// Passages of one realisation at one barrier.
struct RealisationCrossings {
  std::size_t line = 0;  ///< index into Comparison::lines
  std::uint32_t file = 0;
  std::uint32_t realisation = 0;        ///< from 0
  std::size_t blocks = 0;               ///< number of released blocks
  std::vector<BlockCrossing> passages;  ///< in order of time
  WindowMaximum max_blocks_in_window, max_mass_in_window, max_energy_in_window;
  double largest_energy = 0.0;  ///< largest energy of a single block, J

  double sum(const CrossingValue& value) const;
  double first() const { return passages.empty() ? NAN : passages.front().time; }
  double last() const { return passages.empty() ? NAN : passages.back().time; }
};

/// Collects the passages, ordered by barrier, file and realisation. Realisations without a passage
/// are included for files that have the barrier.
std::vector<RealisationCrossings> collect_barrier_crossings(const Comparison& comparison);

/// Computes the cumulative sum of `value` against time, from 0 to the last passage.
/// @param realisations  passages of all realisations of one file at one barrier
/// @return empty if there is no passage
RealisationCurve passage_curve(const std::vector<const RealisationCrossings*>& realisations,
                               const CrossingValue& value);

}  // namespace clast
