#pragma once
/// Allowed ranges of the numbers of a campaign. A number outside its range is a typing error or has
/// another unit.
#include "library/block_ranges.hpp"
#include "terrain/terrain_ranges.hpp"

namespace clast::study_detail {

// [ground.NAME]
inline constexpr NumberRange kEnergyRestitutionRange{1e-6, 1.0};
/// Range of friction coefficients; 100 is the tangent of 89.4 degrees.
inline constexpr NumberRange kFrictionRange{1e-6, 100.0, "", ""};
inline constexpr NumberRange kRollingLengthRange{1e-3, 100.0, "m"};
inline constexpr NumberRange kSlipGrowthRange{1e-3, 1e4, "1/m"};
inline constexpr NumberRange kSlipMemoryRange{1e-6, 1e4, "s"};
inline constexpr NumberRange kScarDragRange{1e-3, 100.0};
/// Range of soil densities, from fresh snow to ore.
inline constexpr NumberRange kSoilDensityRange{50.0, 5000.0, "kg/m^3"};
inline constexpr NumberRange kSoilMemoryRange{0.01, 10.0, "m"};

// [blocks] draw, and laws of uncertain numbers
inline constexpr NumberRange kClassFractionRange{1e-6, 1.0, "", ""};
/// Range of the standard deviation of the natural logarithm of a log-normal parameter.
inline constexpr NumberRange kLogSigmaRange{1e-9, 5.0};

// [release]
inline constexpr NumberRange kDropHeightRange{1e-6, 1e4, "m", "on the ground"};

// [contact]
inline constexpr NumberRange kStiffnessRange{1e-3, 1e15, "N/m"};
inline constexpr NumberRange kRollingStiffnessRange{1e-9, 1e15, "N m/rad"};

// [run]
inline constexpr NumberRange kRunTimeRange{1e-3, 1e5, "s"};
/// Range of the length of the direction vector `downslope`.
inline constexpr NumberRange kDirectionLengthRange{1e-6, 1e6};

}  // namespace clast::study_detail
