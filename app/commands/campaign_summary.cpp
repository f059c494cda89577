#include "app/commands/campaign_summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>

#include "app/option_flags.hpp"
#include "core/error.hpp"
#include "core/listed.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/text_table.hpp"
#include "study/block_stiffness.hpp"
#include "study/comparison.hpp"

namespace clast {

namespace {

/// "; ground parameters drawn 20 times"; empty where they are not drawn.
std::string ground_draws_text(const PreparedCampaign& prepared) {
  const std::uint32_t members = prepared.campaign.ensemble.members;
  return members > 1 ? "; ground parameters drawn " + std::to_string(members) + " times" : "";
}

/// "4 release points, 64 orientations", for each release set, and how often the ground is drawn.
std::string releases_text(const PreparedCampaign& prepared) {
  std::string text;
  if (const std::optional<StaySummary>& stay = prepared.header.stay) {
    text = counted(prepared.campaign.stay->realisations, "realisation") + " of " +
           counted(stay->blocks_each, "block") +
           (stay->at_once ? " released at once" : " that stay");
    if (stay->at_once) return text + ground_draws_text(prepared);
    const std::vector<std::string>& cleared = prepared.campaign.stay->cleared_zones;
    if (!cleared.empty()) text += ", but are removed from " + printable(listed(cleared));
  }
  for (const ReleasePlan& release : prepared.campaign.releases) {
    text += (text.empty() ? "" : "; ") +
            (release.name.empty() ? "" : printable(release.name) + ": ") +
            counted(release.points.size(), "release point") + ", " +
            counted(release.orientations.size(), "orientation");
  }
  return text + ground_draws_text(prepared);
}

/// The heaps that masses start in, from the least to the largest of the realisations.
std::string masses_text(const PreparedCampaign& prepared) {
  const auto range = [&](auto value) {
    double low = INFINITY, high = -INFINITY;
    for (const MassStart& mass : prepared.masses) {
      low = std::min(low, std::invoke(value, mass));
      high = std::max(high, std::invoke(value, mass));
    }
    const std::string from = with_digits(low, 3), to = with_digits(high, 3);
    return from == to ? from : from + " to " + to;
  };
  const std::string rock = "each mass: " + range(&MassStart::volume) + " m3 of rock, " +
                           range([](const MassStart& mass) { return mass.mass / 1000.0; }) + " t, ";
  if (prepared.campaign.stay->mass->in_place) return rock + "in place\n";
  return rock + "on " + range(&MassStart::area) + " m2 in a heap " +
         range(&MassStart::mean_thickness) + " m thick on average, " +
         range(&MassStart::largest_thickness) + " m at most, of which blocks fill " +
         range([](const MassStart& mass) { return 100.0 * mass.solid_fraction(); }) + " %\n";
}

/// More blocks than this are not printed one by one.
constexpr std::size_t kMostPrinted = 20;

/// Stiffness and time step of the runs of each block, and over all blocks where there are many.
TextTable stiffness_table(const PreparedCampaign& prepared) {
  const std::vector<BlockStiffness> blocks = stiffness_by_block(prepared.header, prepared.runs);
  TextTable table{{"block"}, {}};
  for (const StiffnessValue& value : blocks.front().values) {
    table.headings.push_back(value.heading);
  }
  const auto add = [&](const BlockStiffness& block) {
    std::vector<std::string> row = stiffness_cells(block);
    row.insert(row.begin(), block.block);
    table.rows.push_back(row);
  };
  for (std::size_t i = 0; i < std::min(blocks.size(), kMostPrinted); ++i) add(blocks[i]);
  if (blocks.size() > kMostPrinted) add(over_all(blocks));
  return table;
}

constexpr std::array<StopReason, 4> kReasons = {StopReason::kRest, StopReason::kLeftTerrain,
                                                StopReason::kMaxTime, StopReason::kError};

/// What came out, over all runs.
struct Outcome {
  std::array<std::size_t, 4> reasons = {};
  std::size_t below_ground = 0;
  double largest_energy_error = 0.0;
  std::size_t reassigned = 0;  ///< runs above `kNotableReassigned`
  double largest_reassigned = 0.0;
  std::string first_error;

  std::size_t errors() const { return reasons.back(); }  ///< `kReasons` ends with them
};

Outcome outcome_of(const CampaignResults& results) {
  Outcome outcome;
  for (const RunRecord& run : results.runs) {
    const auto reason = std::find(kReasons.begin(), kReasons.end(), run.result.stop_reason);
    ++outcome.reasons[static_cast<std::size_t>(reason - kReasons.begin())];
    if (run.result.below_ground) ++outcome.below_ground;
    outcome.largest_energy_error = std::max(outcome.largest_energy_error, run.result.energy.error);
    const double reassigned = reassigned_share(run.result.energy).value_or(0.0);
    if (reassigned > kNotableReassigned) ++outcome.reassigned;
    outcome.largest_reassigned = std::max(outcome.largest_reassigned, reassigned);
    if (run.result.stop_reason == StopReason::kError && outcome.first_error.empty()) {
      outcome.first_error = "run " + std::to_string(run.run) + ": " + run.result.message;
    }
  }
  return outcome;
}

}  // namespace

nlohmann::ordered_json plan_json(const PreparedCampaign& prepared) {
  nlohmann::ordered_json blocks = nlohmann::ordered_json::array();
  for (const BlockSummary& block : prepared.header.blocks) blocks.push_back(block.id);
  nlohmann::ordered_json stiffness = nlohmann::ordered_json::array();
  for (const BlockStiffness& block : stiffness_by_block(prepared.header, prepared.runs)) {
    nlohmann::ordered_json row = {{"block", block.block}};
    for (const StiffnessValue& value : block.values) {
      if (!value.range.empty()) row[value.name] = {value.range.low, value.range.high};
    }
    stiffness.push_back(row);
  }
  nlohmann::ordered_json plan = {{"runs", prepared.runs.size()},
                                 {"blocks", blocks},
                                 {"release_points", prepared.header.release_points.size()},
                                 {"stiffness", stiffness},
                                 {"warnings", prepared.header.warnings}};
  if (const std::optional<StaySummary>& stay = prepared.header.stay) {
    plan["realisations"] = prepared.campaign.stay->realisations;
    plan["blocks_per_realisation"] = stay->blocks_each;
    for (const MassStart& mass : prepared.masses) {
      nlohmann::ordered_json row = {{"volume_m3", mass.volume}, {"mass_kg", mass.mass}};
      if (!prepared.campaign.stay->mass->in_place) {
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

void print_plan(const PreparedCampaign& prepared) {
  std::cout << counted(prepared.runs.size(), "run") << ": "
            << counted(prepared.bodies.size(), "block") << ", " << releases_text(prepared) << "\n"
            << (prepared.masses.empty() ? "" : masses_text(prepared))
            << stiffness_table(prepared).text();
  for (const std::string& warning : prepared.header.warnings) {
    std::cout << "warning: " << shown(warning) << "\n";
  }
}

void print_outcome(const CampaignResults& results) {
  const Outcome outcome = outcome_of(results);
  TextTable table{{"stop reason", "runs"}, {}};
  for (std::size_t i = 0; i < kReasons.size(); ++i) {
    table.rows.push_back({name_of(kReasons[i]), std::to_string(outcome.reasons[i])});
  }
  std::cout << table.text() << outcome.below_ground << " runs ended below ground, "
            << results.crossings.size() << " barrier crossings, largest energy error "
            << rounded(outcome.largest_energy_error, 2) << "\n";
  if (outcome.reassigned > 0) {
    std::cout
        << "warning: " << counted(outcome.reassigned, "run")
        << " lose or gain more than 10 % of the energy they dissipate where contacts change, at "
           "most "
        << rounded(100.0 * outcome.largest_reassigned, 2)
        << " %; clast compare says which and what to try\n";
  }
}

void check_outcome(const CampaignResults& results, const std::filesystem::path& file) {
  const Outcome outcome = outcome_of(results);
  if (outcome.errors() == 0) return;
  throw SimulationError(
      std::to_string(outcome.errors()) + " of " + counted(results.runs.size(), "run") +
      " ended with an error, the first: " + outcome.first_error + ". All runs are in " +
      file.string() +
      "; clast compare lists the failed ones and leaves them out of its statistics. Try a "
      "smaller "
      "[contact] time_step_s, or stiffness = \"auto\", and look at the ground at the place named");
}

nlohmann::ordered_json outcome_json(const CampaignResults& results) {
  const Outcome outcome = outcome_of(results);
  nlohmann::ordered_json reasons;
  for (std::size_t i = 0; i < kReasons.size(); ++i) {
    reasons[name_of(kReasons[i])] = outcome.reasons[i];
  }
  return {{"stop_reasons", reasons},
          {"below_ground", outcome.below_ground},
          {"crossings", results.crossings.size()},
          {"largest_energy_error", outcome.largest_energy_error},
          {"largest_reassigned_share", outcome.largest_reassigned}};
}

}  // namespace clast
