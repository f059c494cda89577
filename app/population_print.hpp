#pragma once
/// Populations as text and as JSON.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "classify/population_summary.hpp"

namespace clast {

/// A row per block: axes, classes, and how sure the class of the first scheme is.
std::string blocks_text(const Population& population, const PopulationOptions& options);
/// Shares of classes, sizes, and how size and shape go together.
std::string summary_text(const PopulationSummary& summary);
/// A sentence per test.
std::string comparison_text(const PopulationComparison& comparison);

/// A block of "blocks": its axes, every class with its certainty, every index of form.
nlohmann::ordered_json measured_block_json(const MeasuredBlock& block, const SchemeOptions& limits);
/// Formula and source of every index of form.
nlohmann::ordered_json formulas_json();
/// Rows of "population": {scheme: [...]}.
nlohmann::ordered_json shares_json(const PopulationSummary& summary);
nlohmann::ordered_json size_json(const PopulationSummary& summary);
nlohmann::ordered_json size_and_shape_json(const PopulationSummary& summary);
nlohmann::ordered_json comparison_json(const PopulationComparison& comparison);

}  // namespace clast
