#pragma once
/// Section with the 3-D view of a report: terrain, blocks with their shapes, and trajectories.
#include <string>

#include "report/scene/scene_data.hpp"
#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// Formats the section with the 3-D view of a report. If three.js is not installed, or no
/// trajectories are stored, it has a note instead.
std::string format_scene_section(const Comparison& comparison, const SceneLimits& limits = {});

}  // namespace clast::report_detail
