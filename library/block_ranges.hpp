#pragma once
/// Allowed ranges of block properties, for options, campaign files and command lines. They extend
/// from a sand grain to a part of a mountain. Numbers outside are typos or wrong units.
#include "core/number_range.hpp"

namespace clast {

inline constexpr NumberRange kBlockLength{1e-4, 1e3, "m"};
inline constexpr NumberRange kBlockVolume{1e-12, 1e9, "m^3"};
inline constexpr NumberRange kBlockMass{1e-9, 1e13, "kg"};
/// Usual sizes. Other blocks are accepted only on request, because most have wrong units.
inline constexpr double kMinUsualLength = 1e-3,
                        kMaxUsualLength = 20.0;  ///< m; shorter particles are sand
inline constexpr double kMaxUsualMass = 1e7;     ///< kg
/// Allowed densities, including pumice and iron meteorites (7900 kg/m^3).
inline constexpr NumberRange kBlockDensity{1.0, 1e5, "kg/m^3"};
inline constexpr NumberRange kMinkowskiRadius{1e-9, 1e3, "m", "sharp edges"};
inline constexpr NumberRange kRadiusFraction{1e-6, 0.25, "of S", "sharp edges"};
inline constexpr NumberRange kMassAccuracy{1e-6, 1e-2};
inline constexpr NumberRange kScanTolerance{1e-6, 1.0, "of L"};
/// Allowed measuring errors of axes.
inline constexpr NumberRange kAxisError{1e-9, 1e3, "m", "exact"};
inline constexpr NumberRange kScaleFactor{1e-9, 1e9};

}  // namespace clast
