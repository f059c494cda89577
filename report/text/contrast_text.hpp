#pragma once
/// Differences in words: of groups of runs, of files of realisations, of blocks together and alone.
#include <string>

#include "study/compare/comparison.hpp"
#include "study/compare/mass_mobility.hpp"
#include "study/compare/realisation_figures.hpp"

namespace clast {

/// A quantity as readers know it: "EC11 total_energy_j" is "energy at EC11", in kJ.
struct QuantityText {
  std::string name;
  std::string unit;
  double factor = 1.0;  ///< on values
};
QuantityText quantity_text(const std::string& quantity);

/// "13 m more (10 to 17 m)", or "less": of the first group, with the decimals that its interval
/// leaves.
/// @param unit    of what is printed; can be empty
/// @param factor  on values
std::string describe_difference(const Contrast& contrast, const std::string& unit, double factor = 1.0);
std::string describe_difference(const Difference& difference);
std::string describe_difference(const DepositQuantityDifference& difference);

/// A sentence to quote.
std::string in_words(const Difference& difference, const Comparison& comparison);

/// "travel angle: file 1 31.2 deg, file 2 28.4 deg; 2.8 deg more (1.1 to 4.5 deg), from 4 and 4
/// realisations", and whether that can be chance.
std::string in_words(const DepositQuantityDifference& difference);

/// "class compact: 12.1 m together, 15.3 m alone; 3.2 m less (1.1 to 5.3 m)", and how far apart
/// they start and how their masses differ, where that is more than `kSameStart` or `kSameMass`.
std::string in_words(const DepositMobility& mobility);

}  // namespace clast
