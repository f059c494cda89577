#pragma once
/// Barrier passages against time, for each realisation of persistent blocks. Only the counted
/// crossing of each run is a passage (`BarrierCrossing::counted`).
#include <cmath>
#include <functional>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/realisation_curve.hpp"

namespace clast {

/// Length of the time window within which passages load a barrier together, s.
inline constexpr double kPassageWindow = 1.0;

/// Passage of one block at a barrier.
struct BlockCrossing {
  std::size_t row = 0;  ///< index into Comparison::rows
  double time = 0.0;    ///< time since the first release of the realisation, s
  double mass = 0.0;    ///< kg
  double volume = 0.0;  ///< m^3
  double energy = 0.0;  ///< translational plus rotational kinetic energy, J
};

/// Function that returns the contribution of one passage to a sum, such as its mass.
using CrossingValue = std::function<double(const BlockCrossing&)>;

/// Largest sum over the passages in any time window.
struct WindowMaximum {
  double value = 0.0;
  double from = NAN;  ///< time of the first passage in that window, s
};
/// Finds the time window with the largest sum of `value` over its passages.
/// @param passages  passages passages of the blocks, in order of time
WindowMaximum find_window_maximum(const std::vector<BlockCrossing>& passages, double window,
                                  const CrossingValue& value);

/// Passages of one realisation at one barrier.
struct RealisationCrossings {
  std::size_t line = 0;  ///< index into Comparison::lines
  std::uint32_t file = 0;
  std::uint32_t realisation = 0;        ///< index of the realisation, from 0
  std::size_t blocks = 0;               ///< number of released blocks
  std::vector<BlockCrossing> passages;  ///< in order of time
  WindowMaximum max_blocks_in_window, max_mass_in_window, max_energy_in_window;
  double largest_energy = 0.0;  ///< largest energy of a single block, J

  double sum(const CrossingValue& value) const;
  double first() const { return passages.empty() ? NAN : passages.front().time; }
  double last() const { return passages.empty() ? NAN : passages.back().time; }
};

/// Collects the barrier passages of all realisations, ordered by barrier, file and realisation.
/// Realisations without a passage are included.
std::vector<RealisationCrossings> collect_barrier_crossings(const Comparison& comparison);

/// Computes the cumulative sum of `value` over the passages against time, over several
/// realisations.
/// @param realisations  realisations of one file at one barrier
/// @return empty if there is no passage
RealisationCurve passage_curve(const std::vector<const RealisationCrossings*>& realisations,
                               const CrossingValue& value);

}  // namespace clast
