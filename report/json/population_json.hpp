#pragma once
/// Populations of blocks as JSON (docs/formats.md).
#include <nlohmann/json.hpp>

#include "classify/population_summary.hpp"

namespace clast {

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
