#pragma once
/// Report of a comparison as one self-contained HTML page.
#include <string>

#include "study/compare/comparison_analyses.hpp"

namespace clast::report_detail {

std::string make_comparison_page(const ComparisonAnalyses& analyses);

}  // namespace clast::report_detail
