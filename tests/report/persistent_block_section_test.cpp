// The sections on blocks that stay.
#include <gtest/gtest.h>

#include <cmath>

#include "core/number_text.hpp"
#include "report/charts/plotly_chart.hpp"
#include "report/pages/report_sections.hpp"
#include "study/compare/mass_mobility.hpp"
#include "tests/study/energies_that_are_lost.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

using namespace report_detail;

TEST(StaySection, SaysHowBlocksWereInEachOthersWay) {
  EXPECT_EQ(format_persistent_blocks_section(compared(hand_made_results())), "");
  CampaignResults results = hand_made_results();
  results.persistent_blocks = {3, {0.01, 0.5, 0.3}};
  results.planned_runs = 6;
  for (std::uint32_t run = 0; run < 6; ++run)
    results.persistent_block_records.push_back({.run = run});
  const double side = results.blocks[results.runs[2].block].axes.S;
  results.persistent_block_records[2].later_displacement = 0.09 * side;  // its contacts yielded
  results.persistent_block_records[3].later_displacement = 2.5;
  results.persistent_block_records[4].later_displacement = 1.25;
  results.persistent_block_records[4].blocks_hit = 2;
  results.persistent_block_records[5].blocks_hit = 1;
  results.persistent_block_records[5].removed_at = 12.0;
  const Comparison comparison = compared(std::move(results));
  const std::string head = format_provenance_section(comparison);
  EXPECT_TRUE(contains(head, "2 realisations of 3 blocks"));
  EXPECT_TRUE(contains(head, "except for 1 block that was removed"));
  const std::string html = format_persistent_blocks_section(comparison);
  EXPECT_EQ(unbalanced(html), "");
  const std::string all = html.substr(html.find(">all<"));
  for (const char* cell : {">2 (33.3 %)<", ">0.50<", ">1.88<", ">2.50<", ">1 (16.7 %)<"}) {
    EXPECT_TRUE(contains(all, cell)) << cell << " in " << all;
  }
}

TEST(DepositSection, GivesMeansOverRealisationsForEachFile) {
  const Comparison single = compared(hand_made_results());
  EXPECT_EQ(format_deposit_section(single), "");
  CampaignResults results = hand_made_results();
  results.persistent_blocks = {3, {0.01, 0.5, 0.3}, true};
  results.planned_runs = 6;
  for (std::uint32_t run = 0; run < 6; ++run)
    results.persistent_block_records.push_back({.run = run});
  results.runs[5].result.stop_reason = StopReason::kLeftTerrain;
  results.runs[4].result.final_state.position.z() += 0.75;
  CampaignResults gone = results;
  for (RunRecord& run : gone.runs) run.result.stop_reason = StopReason::kLeftTerrain;
  const Comparison comparison = compared(results, gone);
  EXPECT_TRUE(contains(format_provenance_section(comparison),
                       "2 realisations of 3 blocks, released at once"));
  CampaignResults masses = results;
  masses.release_points.resize(3);
  masses.set_of_point.resize(3);
  EXPECT_TRUE(contains(format_provenance_section(compared(masses)),
                       "2 realisations of 3 blocks, released as 3 block masses"));
  EXPECT_EQ(format_persistent_blocks_section(comparison), "");
  const DepositResults deposits = measure_deposits(comparison);
  ASSERT_EQ(deposits.realisations.size(), 4u);
  const double minimum = deposits.realisations[0].thickness;
  const double maximum = deposits.realisations[1].thickness;
  ASSERT_GT(maximum, minimum + 0.5);
  const std::string html = format_deposit_section(comparison);
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_TRUE(contains(html, "file 2: least"));
  const std::string thickness = html.substr(html.find(">largest thickness"));
  for (const std::string& cell : {">" + format_decimals(minimum, 2) + "<",
                                  ">" + format_decimals(maximum, 2) + "<", std::string(">-<")}) {
    EXPECT_TRUE(contains(thickness.substr(0, thickness.find("</tr>")), cell))
        << cell << " in " << thickness;
  }
  const std::string figures = html.substr(html.find("Statistics of the deposit"));
  const std::string deposited_blocks = figures.substr(figures.find("blocks in the deposit"));
  EXPECT_TRUE(contains(deposited_blocks.substr(0, deposited_blocks.find("</tr>")), ">2.0<"));
}

TEST(EnergySection, SaysWhatTheEnergyWasDissipatedBy) {
  EXPECT_EQ(format_energy_section(compared(boxes_that_stay())), "");
  CampaignResults results = energies_that_are_lost();
  const std::string one_by_one = format_energy_section(compared(results));
  EXPECT_TRUE(contains(one_by_one,
                       "Of the energy dissipated in contacts, friction took 70 %, normal forces "
                       "20 % and rolling resistance 10 %; 40 % was dissipated in contacts between "
                       "blocks, the rest in contacts with the ground."));
  EXPECT_FALSE(contains(one_by_one, "Dissipated and kinetic energy against time"));
  results.persistent_blocks->at_once = true;
  const std::string html = format_energy_section(compared(results, results));
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_TRUE(contains(html, "file 2: smallest fraction"));
  const std::string friction = html.substr(html.find(">friction on the ground<"));
  for (const char* cell : {">0.400<", ">40.0 %<"}) {
    EXPECT_TRUE(contains(friction.substr(0, friction.find("</tr>")), cell)) << cell;
  }
  if (plotly_is_installed()) {
    EXPECT_TRUE(contains(html, "Kinetic energy of all blocks together"));
    EXPECT_TRUE(contains(html, "Dissipated and kinetic energy against time, file 2"));
  }
}

/// Files of two realisations whose blocks stop as far as given.
CampaignResults realisations_that_stop_at(const std::vector<double>& distances) {
  CampaignResults results = hand_made_results();
  results.persistent_blocks = {3, {0.01, 0.5, 0.3}, true};
  for (std::uint32_t run = 0; run < 6; ++run) {
    results.persistent_block_records.push_back({.run = run});
    const double x = distances[run / 3];
    results.runs[run].result.final_state.position = {x, 0.0, -0.5 * x};
  }
  return results;
}

TEST(DepositSection, SaysWhatFilesDifferIn) {
  const auto page = [](CampaignResults first, CampaignResults second) {
    const Comparison comparison = compared(std::move(first), std::move(second));
    return format_deposit_section(comparison);
  };
  const std::string far =
      page(realisations_that_stop_at({30.0, 30.1}), realisations_that_stop_at({10.0, 10.1}));
  EXPECT_EQ(unbalanced(far), "");
  EXPECT_TRUE(contains(far, "against file 2 (hand-made), significant differences:</b> "));
  EXPECT_TRUE(contains(far, "distance of the centre of mass 20.0 m more (19."));
  EXPECT_TRUE(contains(far, ">2 and 2<"));
  const std::string same =
      page(realisations_that_stop_at({30.0, 31.0}), realisations_that_stop_at({30.5, 31.5}));
  EXPECT_TRUE(contains(same, "no quantity differs significantly"));
  EXPECT_TRUE(contains(
      same, "Not significant, because the 95 % interval of the difference contains zero:"));
  // One file alone has intervals of means, but nothing to differ from.
  const Comparison alone = compared(realisations_that_stop_at({30.0, 31.0}));
  const std::string one = format_deposit_section(alone);
  EXPECT_TRUE(contains(one, "95 % interval of the mean"));
  EXPECT_EQ(one.find("Differences between the files"), std::string::npos);
}

TEST(DepositSection, WithOneRealisationSaysWhatAnIntervalTakes) {
  CampaignResults single = realisations_that_stop_at({30.0, 30.0});
  single.persistent_blocks->blocks_per_realisation = 6;
  const Comparison comparison = compared(single, single);
  EXPECT_TRUE(contains(format_deposit_section(comparison),
                       "because it requires two realisations of each file"));
}

TEST(DepositSection, SetsBlocksTogetherAgainstTheSameAlone) {
  const Comparison comparison =
      compared(realisations_that_stop_at({30.0, 31.0}), hand_made_results());
  const std::string html = format_deposit_section(comparison);
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_TRUE(contains(html,
                       "Runout of file 1 (hand-made) against single blocks of file 2 "
                       "(hand-made), all: 30.5 m together, "));
  // Of three single runs each with the runouts 10, 20, 30, 40, 10, 20 m.
  const double largest =
      expected_maximum(std::vector<double>{10.0, 20.0, 30.0, 40.0, 10.0, 20.0}, 3.0);
  EXPECT_TRUE(
      contains(html,
               "The farthest block of a realisation stops after 30.5 m on average; the farthest "
               "of the same number of single runs would stop after " +
                   format_decimals(largest, 1) + " m."));
  EXPECT_TRUE(contains(html, ">class elongated<"));
}

TEST(BarrierSection, SaysWhatPassesTogether) {
  EXPECT_EQ(format_barrier_section(compared(hand_made_results())).find("within 1 s"),
            std::string::npos);
  CampaignResults results = hand_made_results();
  results.persistent_blocks = {3, {0.01, 0.5, 0.3}, true};
  for (std::uint32_t run = 0; run < 6; ++run)
    results.persistent_block_records.push_back({.run = run});
  const std::string at_once = format_barrier_section(compared(results));
  EXPECT_EQ(unbalanced(at_once), "");
  // Runs 3 and 5: 150 v^2 + 50 J at 6 and 3 m/s, of 300 and 500 kg.
  EXPECT_TRUE(
      contains(at_once,
               "B&lt;1&gt;: within 1 s at most 2 blocks, at most 800 kg and at most 6.9 kJ pass; "
               "the largest energy of a single block is 5.5 kJ. From 2 "
               "realisations."));
  EXPECT_TRUE(contains(at_once, "most energy in 1 s, kJ"));
  results.persistent_blocks->at_once = false;
  EXPECT_TRUE(contains(format_barrier_section(compared(std::move(results))),
                       "From 2 realisations with blocks released one after another."));
}

}  // namespace
}  // namespace clast
