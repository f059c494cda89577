#include "app/commands/campaign_summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

#include "app/option_flags.hpp"
#include "core/comma_separated.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/text_table.hpp"
#include "study/compare/comparison.hpp"
#include "study/compare/outcome.hpp"
#include "study/results/block_stiffness.hpp"
#include "study/simulate/memory_need.hpp"

namespace clast {

namespace {

/// "; ground parameters drawn 20 times"; empty where they are not drawn.
std::string ground_draws_text(const CampaignPlan& prepared) {
  const std::uint32_t members = prepared.campaign.ensemble.members;
  return members > 1 ? "; ground parameters drawn " + std::to_string(members) + " times" : "";
}

/// "4 release points, 64 orientations", for each release set, and how often the ground is drawn.
std::string releases_text(const CampaignPlan& prepared) {
  std::string text;
  if (const std::optional<PersistentBlocksSettings>& stay = prepared.header.persistent_blocks) {
    text = format_count(prepared.campaign.persistent_blocks->realisations, "realisation") + " of " +
           format_count(stay->blocks_per_realisation, "block") +
           (stay->at_once ? "" : " that stay");
    const std::size_t masses = prepared.campaign.persistent_blocks->masses.size();
    if (stay->at_once) {
      return text +
             (masses > 1 ? " in " + format_count(masses, "mass", "masses") : " released at once") +
             ground_draws_text(prepared);
    }
    const std::vector<std::string>& cleared = prepared.campaign.persistent_blocks->cleared_zones;
    if (!cleared.empty())
      text += ", but are removed from " + escape_nonprintable(comma_separated(cleared));
  }
  for (const ReleaseSet& release : prepared.campaign.releases) {
    text += (text.empty() ? "" : "; ") +
            (release.name.empty() ? "" : escape_nonprintable(release.name) + ": ") +
            format_count(release.points.size(), "release point") + ", " +
            format_count(release.orientations.size(), "orientation");
  }
  return text + ground_draws_text(prepared);
}

/// Describes a mass at its start, with ranges over the realisations.
std::string mass_text(const CampaignPlan& prepared, std::size_t mass) {
  const std::vector<MultiBlockRelease>& plans = prepared.campaign.persistent_blocks->masses;
  const auto range = [&](auto value) {
    double low = INFINITY, high = -INFINITY;
    for (std::size_t i = mass; i < prepared.masses.size(); i += plans.size()) {
      low = std::min(low, std::invoke(value, prepared.masses[i]));
      high = std::max(high, std::invoke(value, prepared.masses[i]));
    }
    const std::string from = format_significant(low, 3), to = format_significant(high, 3);
    return from == to ? from : from + " to " + to;
  };
  std::string rock = prepared.masses.size() > 1 ? "each mass: " : "the mass: ";
  if (plans.size() > 1) {
    rock = "mass " + escape_nonprintable(prepared.campaign.releases[mass].name) + ", released at " +
           format_significant(plans[mass].release_time, 6) +
           " s: " + format_count(prepared.masses[mass].blocks, "block") + ", ";
  }
  rock += range(&MultiBlockStart::volume) + " m3 of rock, " +
          range([](const MultiBlockStart& start) { return start.mass / 1000.0; }) + " t, ";
  if (plans[mass].in_place) return rock + "in place\n";
  return rock + "on " + range(&MultiBlockStart::area) + " m2 in a heap " +
         range(&MultiBlockStart::mean_thickness) + " m thick on average, " +
         range(&MultiBlockStart::largest_thickness) + " m at most, of which blocks fill " +
         range([](const MultiBlockStart& start) { return 100.0 * start.solid_fraction(); }) +
         (plans[mass].settle ? " %, before they settle\n" : " %\n");
}

/// A line for each mass; empty without.
std::string masses_text(const CampaignPlan& prepared) {
  std::string text;
  if (prepared.masses.empty()) return text;
  for (std::size_t mass = 0; mass < prepared.campaign.persistent_blocks->masses.size(); ++mass) {
    text += mass_text(prepared, mass);
  }
  return text;
}

/// "about 210 MB of memory for each realisation"; empty where blocks are run one by one.
std::string memory_line(const CampaignPlan& prepared) {
  const double bytes = estimate_realisation_memory(prepared);
  return bytes > 0.0 ? "about " + format_memory(bytes) + " of memory for each realisation\n" : "";
}

/// "66 bodies made of 1 block of scans.h5"; empty where blocks run as they are.
std::string made_text(const CampaignPlan& prepared) {
  const CampaignBlocks& choice = prepared.choice;
  if (choice.parents.empty()) return "";
  return format_count(choice.library.size(), "body", "bodies") + " made of " +
         format_count(choice.parents.size(), "block") + " of " +
         escape_nonprintable(prepared.campaign.blocks.library.string()) + "\n";
}

/// More blocks than this are not printed one by one.
constexpr std::size_t kMaxPrintedStarts = 20;

/// Stiffness and time step of the runs of each block, and over all blocks where there are many.
TextTable stiffness_table(const CampaignPlan& prepared) {
  const std::vector<BlockStiffnessRanges> blocks =
      collect_stiffness_by_block(prepared.header, prepared.runs);
  TextTable table{{"block"}, {}};
  for (const StiffnessRange& value : blocks.front().values) {
    table.headings.push_back(value.heading);
  }
  const auto add = [&](const BlockStiffnessRanges& block) {
    std::vector<std::string> row = format_stiffness_cells(block);
    row.insert(row.begin(), block.block);
    table.rows.push_back(row);
  };
  for (std::size_t i = 0; i < std::min(blocks.size(), kMaxPrintedStarts); ++i) add(blocks[i]);
  if (blocks.size() > kMaxPrintedStarts) add(combine_stiffness(blocks));
  return table;
}

}  // namespace

void print_plan(const CampaignPlan& prepared) {
  std::cout << format_count(prepared.runs.size(), "run") << ": "
            << format_count(prepared.bodies.size(), "block") << ", " << releases_text(prepared)
            << "\n"
            << made_text(prepared) << masses_text(prepared) << memory_line(prepared);
  for (const std::string& warning : prepared.header.warnings) {
    std::cout << "warning: " << format_for_terminal(warning) << "\n";
  }
}

void print_stiffness(const CampaignPlan& prepared) {
  std::cout << "\nstiffness and time step of the runs of each block\n"
            << stiffness_table(prepared).text();
}

void print_outcome(const CampaignResults& results) {
  const StopReasonCounts outcome = count_stop_reasons(results);
  TextTable table{{"stop reason", "runs"}, {}};
  for (std::size_t i = 0; i < kStopReasons.size(); ++i) {
    table.rows.push_back({name_of(kStopReasons[i]), std::to_string(outcome.reasons[i])});
  }
  std::cout << table.text() << outcome.below_ground << " runs ended below ground, "
            << results.crossings.size() << " barrier crossings, largest energy error "
            << (outcome.largest_energy_error ? format_rounded(*outcome.largest_energy_error, 2)
                                             : std::string("not known"))
            << "\n";
  for (const std::string& warning : describe_failed_runs(outcome)) {
    std::cout << "warning: " << warning << "\n";
  }
}

}  // namespace clast
