#pragma once
/// Allowed ranges of block properties, for options, campaign files and command lines. They extend
/// from a sand grain to a part of a mountain. Numbers outside are typos or wrong units.
#include "core/number_range.hpp"

namespace clast {

inline constexpr NumberRange kBlockLengthRange{1e-4, 1e3, "m"};
inline constexpr NumberRange kBlockVolumeRange{1e-12, 1e9, "m^3"};
inline constexpr NumberRange kBlockMassRange{1e-9, 1e13, "kg"};
/// Usual sizes. Other blocks are accepted only on request, because most have wrong units.
inline constexpr double kMinUsualLength = 1e-3,
                        kMaxUsualLength = 20.0;  ///< m; shorter particles are sand
inline constexpr double kMaxUsualMass = 1e7;     ///< kg
/// Allowed densities, including pumice and iron meteorites (7900 kg/m^3).
inline constexpr NumberRange kBlockDensityRange{1.0, 1e5, "kg/m^3"};
inline constexpr NumberRange kMinkowskiRadiusRange{1e-9, 1e3, "m", "sharp edges"};
inline constexpr NumberRange kRadiusFractionRange{1e-6, 0.25, "of S", "sharp edges"};
inline constexpr NumberRange kMassAccuracyRange{1e-6, 1e-2};
inline constexpr NumberRange kScanToleranceRange{1e-6, 1.0, "of L"};
/// Allowed measuring errors of axes.
inline constexpr NumberRange kAxisErrorRange{1e-9, 1e3, "m", "exact"};
inline constexpr NumberRange kScaleFactorRange{1e-9, 1e9};

}  // namespace clast
