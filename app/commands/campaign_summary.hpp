#pragma once
/// What `clast simulate` says about a campaign before its runs, and about their results.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "study/campaign_runner.hpp"
#include "study/results.hpp"

namespace clast {

/// Runs, blocks, release points, stiffness by block and warnings: docs/formats.md, `simulate
/// --json`.
nlohmann::ordered_json plan_json(const PreparedCampaign& prepared);
/// The same on stdout, for people.
void print_plan(const PreparedCampaign& prepared);

/// Stop reasons, runs below ground, barrier crossings, largest errors of energy.
nlohmann::ordered_json outcome_json(const CampaignResults& results);
/// The same on stdout, for people.
void print_outcome(const CampaignResults& results);

/// All runs are kept, but a campaign with failed ones has failed.
/// @param file  that holds the results
/// @throws SimulationError  any run ended with an error
void check_outcome(const CampaignResults& results, const std::filesystem::path& file);

}  // namespace clast
