#pragma once
/// Populations as text and as JSON.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "classify/population_summary.hpp"

namespace clast {

/// Shares of classes, sizes, and how size and shape go together.
std::string summary_text(const PopulationSummary& summary);
/// A sentence per test.
std::string comparison_text(const PopulationComparison& comparison);

/// Rows of "population": {scheme: [...]}.
nlohmann::ordered_json shares_json(const PopulationSummary& summary);
nlohmann::ordered_json size_json(const PopulationSummary& summary);
nlohmann::ordered_json size_and_shape_json(const PopulationSummary& summary);
nlohmann::ordered_json comparison_json(const PopulationComparison& comparison);

}  // namespace clast
