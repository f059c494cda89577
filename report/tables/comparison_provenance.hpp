#pragma once
/// Provenance of a comparison.
#include <string>

#include "study/compare/comparison_analyses.hpp"

namespace clast {

/// Makes the provenance of a comparison as JSON: program versions, campaigns and input files with
/// digests.
std::string make_provenance_json(const ComparisonAnalyses& analyses);

}  // namespace clast
