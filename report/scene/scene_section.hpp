#pragma once
/// The 3-D view of a report: terrain, blocks in their real shapes, and their paths over time.
#include <string>

#include "report/scene/scene_data.hpp"
#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// The section with everything it needs inside, three.js included. Where that is not installed, or
/// no trajectories are stored, a sentence says so and what to do.
std::string scene_section(const Comparison& comparison, const SceneLimits& limits = {});

}  // namespace clast::report_detail
