#pragma once
/// Blocks that stayed where they came to rest: where in the deposit, and which way their long axes
/// point.
#include <cmath>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "study/comparison.hpp"

namespace clast {

/// A block of a deposit. Distances are in plan; right is looking downslope.
struct LyingBlock {
  std::size_t row = 0;  ///< into Comparison::rows
  std::uint32_t file = 0;
  std::uint32_t realisation = 0;  ///< from 0
  double along = 0.0;             ///< along downslope from the highest start of the realisation, m
  double ahead = 0.0;             ///< likewise, from the centre of mass of the deposit
  double aside = 0.0;   ///< to the right of the line along downslope through the centre of mass of
                        ///< the starts, m
  double height = NAN;  ///< of the centre above the ground without blocks, m
  double relative_height = NAN;  ///< over the thickness of the deposit there; 0.5 of a block alone
  double trend = 0.0;   ///< of the long axis, from downslope to the right, rad in (-pi/2, pi/2]
  double plunge = 0.0;  ///< of the long axis below the horizontal, rad in [0, pi/2]
  Vec3 long_axis = Vec3::UnitX();  ///< unit: along downslope, to the right, up
};

/// In order of file, realisation and run. The long axis is that of L of the smallest box. Heights
/// are not numbers off the survey.
std::vector<LyingBlock> lying_blocks(const Comparison& comparison);

/// The highest place of upward triangles on the vertical through (x, y); none beside them.
/// @param skin  of a body, local frame
std::optional<double> top_over(const TriangleMesh& skin, const Vec2& place);

/// The nearest other place of each, of the first of several as near.
/// @param places  two or more
std::vector<std::size_t> nearest_others(const std::vector<Vec3>& places);

}  // namespace clast
