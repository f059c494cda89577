#pragma once
/// Allowed ranges of a block's numbers: for options, campaign files and command lines. From a grain
/// of sand to part of a mountain; a number outside is a typing error or in other units.
#include "core/number_range.hpp"

namespace clast {

inline constexpr NumberRange kBlockLength{1e-4, 1e3, "m"};
inline constexpr NumberRange kBlockVolume{1e-12, 1e9, "m^3"};
inline constexpr NumberRange kBlockMass{1e-9, 1e13, "kg"};
/// Blocks beyond these are taken only where that is asked for: most come from wrong units.
inline constexpr double kMinUsualLength = 1e-3, kMaxUsualLength = 20.0;  ///< m; below it lies sand
inline constexpr double kMaxUsualMass = 1e7;                         ///< kg
/// Pumice floats, iron meteorites have 7900 kg/m^3; other bodies are allowed for.
inline constexpr NumberRange kBlockDensity{1.0, 1e5, "kg/m^3"};
inline constexpr NumberRange kMinkowskiRadius{1e-9, 1e3, "m", "sharp edges"};
inline constexpr NumberRange kRadiusFraction{1e-6, 0.25, "of S", "sharp edges"};
inline constexpr NumberRange kMassAccuracy{1e-6, 1e-2};
inline constexpr NumberRange kScanTolerance{1e-6, 1.0, "of L"};
/// The measuring error of taped axes.
inline constexpr NumberRange kAxisError{1e-9, 1e3, "m", "exact"};
/// On all lengths of a scan.
inline constexpr NumberRange kScaleFactor{1e-9, 1e9};

}  // namespace clast
