#pragma once
/// Where the energy of blocks that stay goes, realisation by realisation and against time.
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/realisation_curve.hpp"

namespace clast {

/// Energies of all blocks of one realisation.
struct RealisationEnergies {
  std::uint32_t file = 0;             ///< index into Comparison::results
  std::uint32_t realisation = 0;      ///< from 0
  std::vector<EnergySample> samples;  ///< one at least, in order of time
};

/// By file and realisation; none of older results and other engines.
std::vector<RealisationEnergies> collect_realisation_energies(const Comparison& comparison);

/// A figure of an instant.
using EnergyValue = std::function<double(const EnergySample&)>;

/// The figure at equal steps of time until the last realisation rests, linear between samples; a
/// realisation that rests keeps its last value.
/// @param realisations  with the samples asked for
/// @return empty without realisations, or where they take no time
RealisationCurve compute_energy_curve(const std::vector<const RealisationEnergies*>& realisations,
                              const EnergyValue& value);

/// What the energy of one realisation was dissipated by until its end, as shares.
struct EnergyFractions {
  Dissipation on_ground, between_blocks;
  double largest_kinetic = NAN;  ///< of all blocks together, at any sample, J
};
/// @return all not a number but `largest_kinetic` where nothing was dissipated
EnergyFractions compute_energy_fractions(const std::vector<EnergySample>& samples);

}  // namespace clast
