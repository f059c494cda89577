#pragma once
/// Provenance of a comparison.
#include <string>

#include "study/compare/comparison_analyses.hpp"

namespace clast {

/// Returns program versions, campaigns and input files with digests as JSON.
std::string make_provenance_json(const ComparisonAnalyses& analyses);

}  // namespace clast
