#pragma once
/// The comparison as one self-contained HTML page: no script or picture from elsewhere.
#include <string>

#include "study/compare/comparison_analyses.hpp"

namespace clast::report_detail {

std::string make_comparison_page(const ComparisonAnalyses& analyses);

}  // namespace clast::report_detail
