#pragma once
/// A campaign before its runs and what came out of them, as JSON (docs/formats.md, `simulate
/// --json`).
#include <nlohmann/json.hpp>

#include "study/results/results.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// What the campaign could tell apart, with its assumptions; empty where nothing is known.
nlohmann::ordered_json power_json(const PlannedPower& power);

/// Runs, blocks, release points, stiffness by block and warnings.
nlohmann::ordered_json plan_json(const CampaignPlan& prepared);

/// Stop reasons, runs below ground, barrier crossings, largest errors of energy.
nlohmann::ordered_json outcome_json(const CampaignResults& results);

}  // namespace clast
