#pragma once
/// Texts of differences between groups, files and releases.
#include <string>

#include "study/compare/comparison.hpp"
#include "study/compare/deposit_quantities.hpp"
#include "study/compare/mass_mobility.hpp"

namespace clast {

/// Displayed name and unit of a quantity, such as "energy at EC11" in kJ for "EC11 total_energy_j".
struct QuantityLabel {
  std::string name;
  std::string unit;
  double factor = 1.0;  ///< displayed value divided by stored value
};
QuantityLabel quantity_label(const std::string& quantity);

/// Describes the difference between the first and the second group, such as "13 m more (10 to 17
/// m)". The number of decimals depends on the interval.
/// @param unit  displayed unit; may be empty
/// @param factor  displayed value divided by stored value
std::string describe_difference(const Contrast& contrast, const std::string& unit,
                                double factor = 1.0);
std::string describe_difference(const GroupDifference& difference);
std::string describe_difference(const DepositQuantityDifference& difference);

/// Describes a difference between two groups in a complete sentence.
std::string describe_effect(const GroupDifference& difference, const Comparison& comparison);

/// Describes a difference of deposits and its significance, such as "travel angle: file 1 31.2 deg,
/// file 2 28.4 deg; 2.8 deg more (1.1 to 4.5 deg), from 4 and 4 realisations".
std::string describe_effect(const DepositQuantityDifference& difference);

/// Describes the mobility of a deposit, such as "class compact: 12.1 m together, 15.3 m alone; 3.2
/// m less (1.1 to 5.3 m)". Differences of starts and masses are included if they exceed
/// `kMaxSameStartDistance` or `kMaxSameMassDifference`.
std::string describe_effect(const DepositMobility& mobility);

}  // namespace clast
