// The section on blocks that stay.
#include <gtest/gtest.h>

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
  const std::string head = head_section(comparison);
  EXPECT_TRUE(contains(head, "2 realisations of 3 blocks"));
  EXPECT_TRUE(contains(head, "but for 1 block that was removed"));
  const std::string html = stay_section(comparison);
  EXPECT_EQ(unbalanced(html), "");
  const std::string all = html.substr(html.find(">all<"));
  for (const char* cell : {">2 (33.3 %)<", ">0.50<", ">1.88<", ">2.50<", ">1 (16.7 %)<"}) {
    EXPECT_TRUE(contains(all, cell)) << cell << " in " << all;
  }
}

}  // namespace
}  // namespace clast
