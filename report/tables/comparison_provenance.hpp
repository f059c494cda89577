#pragma once
/// Where the figures of a comparison come from.
#include <string>

#include "study/compare/comparison_analyses.hpp"

namespace clast {

/// What made the results, as JSON: program versions, campaigns and input files with their hashes.
std::string make_provenance_json(const ComparisonAnalyses& analyses);

}  // namespace clast
