#pragma once
/// Energies of persistent blocks against time, for each realisation.
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "study/compare/comparison.hpp"
#include "study/compare/realisation_curve.hpp"

namespace clast {

/// Energies of all blocks of one realisation against time.
struct RealisationEnergies {
  std::uint32_t file = 0;             ///< index into Comparison::results
  std::uint32_t realisation = 0;      ///< index of the realisation, from 0
  std::vector<EnergySample> samples;  ///< energies in order of time, not empty
};

/// Collects the energies of persistent blocks by file and realisation. Empty if not stored.
std::vector<RealisationEnergies> collect_realisation_energies(const Comparison& comparison);

/// Function that computes a quantity from the energies at one time.
using EnergyValue = std::function<double(const EnergySample&)>;

/// Computes a quantity against time: mean, minimum and maximum over the realisations, at equal time
/// steps until the last one comes to rest.
/// @param realisations  realisations with energy samples
/// @return empty if there are no realisations, or if their duration is zero
RealisationCurve compute_energy_curve(const std::vector<const RealisationEnergies*>& realisations,
                                      const EnergyValue& value);

/// Fractions of the dissipated energy of one realisation, by mechanism.
struct EnergyFractions {
  DissipatedEnergy on_ground, between_blocks;
  double largest_kinetic = NAN;  ///< largest total kinetic energy of all samples, J
};
/// Computes the fractions of the dissipated energy of one realisation, by mechanism.
/// @return all NaN except `largest_kinetic` if nothing was dissipated
EnergyFractions compute_energy_fractions(const std::vector<EnergySample>& samples);

}  // namespace clast
