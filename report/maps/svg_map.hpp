#pragma once
/// The map of a plan: relief, zones, release points and barriers in map coordinates.
#include <string>

#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// An SVG element with legend, scale bar and north arrow. The relief is that of the first file.
std::string svg_map(const Comparison& comparison);

}  // namespace clast::report_detail
