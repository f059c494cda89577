#include "report/json/campaign_json.hpp"

#include "study/compare/outcome.hpp"
#include "study/results/block_stiffness.hpp"
#include "study/simulate/memory_need.hpp"

namespace clast {

nlohmann::ordered_json power_json(const PlannedPower& power) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!power.is_known()) return json;
  json["runout_scatter_m"] = power.runout_deviation;
  json["design_effect_assumed"] = power.design_effect();
  json["smallest_difference_m"] = power.detectable_difference();
  if (power.margin) json["runs_needed"] = power.runs_needed();
  return json;
}

nlohmann::ordered_json plan_json(const CampaignPlan& prepared) {
  nlohmann::ordered_json blocks = nlohmann::ordered_json::array();
  for (const BlockSummary& block : prepared.header.blocks) blocks.push_back(block.id);
  nlohmann::ordered_json stiffness = nlohmann::ordered_json::array();
  for (const BlockStiffnessRanges& block :
       collect_stiffness_by_block(prepared.header, prepared.runs)) {
    nlohmann::ordered_json row = {{"block", block.block}};
    for (const StiffnessRange& value : block.values) {
      if (!value.range.empty()) row[value.name] = {value.range.low, value.range.high};
    }
    stiffness.push_back(row);
  }
  nlohmann::ordered_json plan = {{"runs", prepared.runs.size()},
                                 {"blocks", blocks},
                                 {"varied_blocks", prepared.choice.parents},
                                 {"release_points", prepared.header.release_points.size()},
                                 {"stiffness", stiffness},
                                 {"warnings", prepared.header.warnings}};
  if (const std::optional<PersistentBlocksSettings>& stay = prepared.header.persistent_blocks) {
    plan["realisations"] = prepared.campaign.persistent_blocks->realisations;
    plan["blocks_per_realisation"] = stay->blocks_per_realisation;
    plan["memory_bytes_per_realisation"] = estimate_realisation_memory(prepared);
    const std::vector<MultiBlockRelease>& plans = prepared.campaign.persistent_blocks->masses;
    for (std::size_t i = 0; i < prepared.masses.size(); ++i) {
      const MultiBlockStart& mass = prepared.masses[i];
      const std::size_t of_realisation = i % plans.size();
      nlohmann::ordered_json row;
      if (plans.size() > 1) row["name"] = prepared.campaign.releases[of_realisation].name;
      row["blocks"] = mass.blocks;
      row["release_time_s"] = plans[of_realisation].release_time;
      row["volume_m3"] = mass.volume;
      row["mass_kg"] = mass.mass;
      if (!plans[of_realisation].in_place) {
        row["area_m2"] = mass.area;
        row["mean_thickness_m"] = mass.mean_thickness;
        row["largest_thickness_m"] = mass.largest_thickness;
        row["solid_fraction"] = mass.solid_fraction();
      }
      plan["masses"].push_back(row);
    }
  }
  return plan;
}

nlohmann::ordered_json outcome_json(const CampaignResults& results) {
  const StopReasonCounts outcome = count_stop_reasons(results);
  nlohmann::ordered_json reasons;
  for (std::size_t i = 0; i < kStopReasons.size(); ++i) {
    reasons[name_of(kStopReasons[i])] = outcome.reasons[i];
  }
  const auto or_null = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  };
  return {{"stop_reasons", reasons},
          {"below_ground", outcome.below_ground},
          {"crossings", results.crossings.size()},
          {"largest_energy_error", or_null(outcome.largest_energy_error)},
          {"largest_reassigned_share", or_null(outcome.largest_reassigned)},
          {"outcome_warnings", describe_failed_runs(outcome)}};
}

}  // namespace clast
