#pragma once
/// Campaign plans and outcomes as JSON (docs/formats.md, `simulate --json`).
#include <nlohmann/json.hpp>

#include "study/results/results.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Returns the planned statistical power of a campaign with its assumptions as JSON. Empty if
/// unknown.
nlohmann::ordered_json power_json(const PlannedPower& power);

/// Returns runs, blocks, release points, stiffness and warnings of a prepared campaign as JSON.
nlohmann::ordered_json plan_json(const CampaignPlan& prepared);

/// Returns stop reasons, barrier crossings and energy errors of a campaign as JSON.
nlohmann::ordered_json outcome_json(const CampaignResults& results);

}  // namespace clast
