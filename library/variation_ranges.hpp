#pragma once
/// Allowed ranges of variations, for options, campaign files and Python.
#include <cstddef>

#include "core/number_range.hpp"

namespace clast {

inline constexpr NumberRange kVariedRatioRange{0.01, 1.0};
inline constexpr NumberRange kVariedConvexityRange{0.01, 1.0};
inline constexpr NumberRange kVariedRadiusFractionRange{1e-3, 0.4, "of S", "sharp edges"};
inline constexpr NumberRange kVariedRoundnessRange{0.01, 1.0};
/// Edge length of the mesh for roundness, relative to the diameter of the ball of equal volume.
inline constexpr NumberRange kRoundnessEdgeRange{0.01, 0.2};
inline constexpr NumberRange kDetailGainRange{0.01, 10.0, "", "smooth"};
inline constexpr NumberRange kSuperellipsoidExponentRange{1.0, 20.0};
/// Smallest axis ratio in a grid of shapes over a shape diagram.
inline constexpr NumberRange kMinRatioRange{0.01, 0.99};
inline constexpr int kMaxGridSteps = 100;  ///< maximum number of steps along a side of that grid
/// Number of vertices of a simplified core.
inline constexpr std::size_t kMinVariedVertices = 8, kMaxVariedVertices = 2000;
inline constexpr int kMinDegree = 2, kMaxDegree = 20;
inline constexpr std::size_t kMaxSeriesBodies = 100'000;  ///< maximum number of bodies of a series

}  // namespace clast
