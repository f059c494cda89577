#pragma once
/// Plan views of a deposit: relief and blocks in cells, and outlines of blocks.
#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"
#include "terrain/relief.hpp"

namespace clast::report_detail {

/// Deposit seen from above. Cells are row-major from the top (largest y).
struct DepositPlan {
  PlanWindow window;  ///< m
  Relief relief;      ///< heights of the highest points, m; NaN where there are none
  std::vector<std::uint32_t> blocks;  ///< block of the highest point of each cell; 0: none
};

/// Makes the plan of a deposit. Far strays are outside its window; small gaps between points are
/// filled from their surroundings.
/// @param points  at least one, m
/// @param block_of_point  block of each point from 1; 0: none
/// @param spacing  point spacing, m
DepositPlan make_deposit_plan(std::span<const Vec3> points,
                              std::span<const std::uint32_t> block_of_point, double spacing);

/// Renders the relief of a plan as a shaded PNG file.
std::string render_plan_png(const DepositPlan& plan);

/// Traces polygons around points in plan, counter-clockwise and not closed. Points within about two
/// cells of each other are in one polygon; holes are not traced. The largest polygon is first.
/// @param cell  side of the cells in which points are joined, m
std::vector<std::vector<Vec2>> trace_plan_outlines(std::span<const Vec2> points, double cell);

}  // namespace clast::report_detail
