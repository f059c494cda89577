#pragma once
/// Allowed ranges of terrain options. `TerrainOptions`, campaign files and command lines use them.
#include "core/number_range.hpp"

namespace clast {

/// Allowed map coordinates; the earth's circumference is 4e7 m.
inline constexpr NumberRange kMapCoordinateRange{-1e8, 1e8, "m"};

inline constexpr NumberRange kCellSizeRange{1e-4, 1e5, "m"};
inline constexpr NumberRange kPercentileRange{1e-6, 100.0, "", "the lowest point"};
inline constexpr NumberRange kOutlierDistanceRange{1e-6, 1e5, "m"};
inline constexpr NumberRange kHoleWidthRange{1e-6, 1e6, "m", "none is filled"};
inline constexpr NumberRange kCrackWidthRange{1e-9, 1e3, "m", "none is closed"};
inline constexpr NumberRange kSpikeSteepnessRange{1e-3, 1e3, "", "none is levelled"};
inline constexpr NumberRange kSurfaceToleranceRange{1e-9, 1e3, "m"};
inline constexpr NumberRange kBorderDistanceRange{1e-3, 1e6, "m"};
inline constexpr NumberRange kMassThicknessRange{1e-6, 1e4, "m", "all counts"};
inline constexpr NumberRange kGroundRadiusRange{1e-6, 100.0, "m", ""};
inline constexpr int kMaxSmoothing = 1000;  ///< rounds

}  // namespace clast
