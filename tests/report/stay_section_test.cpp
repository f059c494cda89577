// The sections on blocks that stay.
#include <gtest/gtest.h>

#include <cmath>

#include "report/pages/report_sections.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

using namespace report_detail;

TEST(StaySection, SaysHowBlocksWereInEachOthersWay) {
  EXPECT_EQ(stay_section(compared(hand_made_results())), "");
  CampaignResults results = hand_made_results();
  results.stay = {3, {0.01, 0.5, 0.3}};
  results.planned_runs = 6;
  for (std::uint32_t run = 0; run < 6; ++run) results.stays.push_back({.run = run});
  const double side = results.blocks[results.runs[2].block].axes.S;
  results.stays[2].moved_later = 0.09 * side;  // its contacts yielded
  results.stays[3].moved_later = 2.5;
  results.stays[4].moved_later = 1.25;
  results.stays[4].blocks_hit = 2;
  results.stays[5].blocks_hit = 1;
  results.stays[5].removed_at = 12.0;
  const Comparison comparison = compared(std::move(results));
  const std::string head = provenance_section(comparison);
  EXPECT_TRUE(contains(head, "2 realisations of 3 blocks"));
  EXPECT_TRUE(contains(head, "but for 1 block that was removed"));
  const std::string html = stay_section(comparison);
  EXPECT_EQ(unbalanced(html), "");
  const std::string all = html.substr(html.find(">all<"));
  for (const char* cell : {">2 (33.3 %)<", ">0.50<", ">1.88<", ">2.50<", ">1 (16.7 %)<"}) {
    EXPECT_TRUE(contains(all, cell)) << cell << " in " << all;
  }
}

TEST(DepositSection, GivesMeansOverRealisationsForEachFile) {
  const Comparison single = compared(hand_made_results());
  EXPECT_EQ(deposit_section(single, realisation_deposits(single)), "");
  CampaignResults results = hand_made_results();
  results.stay = {3, {0.01, 0.5, 0.3}, true};
  results.planned_runs = 6;
  for (std::uint32_t run = 0; run < 6; ++run) results.stays.push_back({.run = run});
  results.runs[5].result.stop_reason = StopReason::kLeftTerrain;
  const Comparison comparison = compared(results, results);
  EXPECT_TRUE(
      contains(provenance_section(comparison), "2 realisations of 3 blocks, released at once"));
  EXPECT_EQ(stay_section(comparison), "");
  RealisationDeposits deposits = realisation_deposits(comparison);
  ASSERT_EQ(deposits.realisations.size(), 4u);
  deposits.realisations[0].thickness = 1.25;
  deposits.realisations[1].thickness = 1.75;
  deposits.realisations[2].thickness = deposits.realisations[3].thickness = NAN;
  const std::string html = deposit_section(comparison, deposits);
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_TRUE(contains(html, "file 2: least"));
  const std::string thickness = html.substr(html.find("largest thickness"));
  for (const char* cell : {">1.25<", ">1.75<", ">-<"}) {
    EXPECT_TRUE(contains(thickness, cell)) << cell << " in " << thickness;
  }
  const std::string lying = html.substr(html.find("blocks that lie there"));
  EXPECT_TRUE(contains(lying.substr(0, lying.find("</tr>")), ">2.0<"));
}

}  // namespace
}  // namespace clast
