// Everything that would be refused, listed.
#include "study/simulate/campaign_check.hpp"

#include <gtest/gtest.h>

#include "study/campaign/campaign_keys.hpp"
#include "tests/study/campaign_run.hpp"

namespace clast {
namespace {

class CampaignChecks : public CampaignRun {
 protected:
  static CampaignCheck check(const std::string& text) {
    write_text_file(*folder_ / "campaign.toml", text);
    return check_campaign(*folder_ / "campaign.toml");
  }
  static bool any(const CampaignCheck& found, const std::string& words) {
    for (const std::string& finding : found.findings) {
      if (contains(finding, words)) return true;
    }
    return false;
  }
};

TEST_F(CampaignChecks, AGoodOneIsPreparedAsForItsRuns) {
  const CampaignCheck found = check(campaign_text());
  EXPECT_TRUE(found.findings.empty());
  ASSERT_TRUE(found.prepared);
  EXPECT_EQ(found.prepared->runs.size(), prepared().runs.size());
}

// Every single finding is the refusal that `simulate` gives.
TEST_F(CampaignChecks, OneMistakeIsTheRefusalOfARun) {
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"friction = 0.4", "friction = -1"},
           {"\"slope.stl\", \"flat.stl\"", "\"gone.stl\", \"flat.stl\""},
           {"[ground.flat]", "[ground.flats]"},
           {"[-12, -3, 9.5]", "[-120, -3, 9.5]"},
           {"[-12, -3, 9.5]", "[-12, -3, 6.5]"},
           {"from = [0, -20]", "from = [0, 20]"},
           {"max_time_s = 6", "max_time = 6"}}) {
    const std::string text = with(from, to);
    const CampaignCheck found = check(text);
    ASSERT_EQ(found.findings.size(), 1u) << to << testing::PrintToString(found.findings);
    EXPECT_FALSE(found.prepared);
    EXPECT_EQ(found.findings[0], clast::refusal<Error>([&] { prepare_campaign(campaign(text)); }));
  }
}

// Paths start from the folder that the text could be in.
TEST_F(CampaignChecks, ATextInNoFileIsJudgedAsInOne) {
  const std::filesystem::path place = *folder_ / "none.toml";
  const CampaignCheck good = check_campaign_text(campaign_text(), place);
  EXPECT_TRUE(good.findings.empty()) << testing::PrintToString(good.findings);
  const Campaign parsed = parse_campaign(campaign_text(), place);
  EXPECT_EQ(parsed.sha256, check(campaign_text()).prepared->campaign.sha256);
  EXPECT_EQ(parsed.text, campaign_text());
  EXPECT_FALSE(std::filesystem::exists(place));

  const std::string bad = with("friction = 0.4", "friction = -1");
  const CampaignCheck found = check_campaign_text(bad, place);
  ASSERT_EQ(found.findings.size(), 1u);
  EXPECT_TRUE(contains(found.findings[0], "none.toml:"));
  EXPECT_EQ(found.findings[0], clast::refusal([&] { parse_campaign(bad, place); }));
}

TEST_F(CampaignChecks, EveryKeyOfTheTablesIsKnown) {
  for (const KeyTable& table : campaign_key_tables()) {
    const std::string title = table.name == "ground" ? "ground.slope" : table.name;
    for (const std::string& key : table.key_names()) {
      const CampaignCheck found = check("[" + title + "]\n" + key + " = 1979-05-27\n");
      EXPECT_FALSE(any(found, "unknown")) << title << " " << key;
    }
  }
  for (const char* title : {"blocks", "terrain", "ground.slope", "run", "contact"}) {
    EXPECT_TRUE(any(check("[" + std::string(title) + "]\nmoss = 1\n"), "unknown key")) << title;
  }
}

TEST_F(CampaignChecks, FindsAMistakeInEveryTable) {
  std::string text = campaign_text();
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"library = \"blocks.h5\"", "library = \"blocks.h5\"\nselect = [\"cubes\"]"},
           {"friction = 0.4", "friction = \"high\""},
           {"orientations = \"turns.txt\"", "orientations = \"gone.txt\""},
           {"name = \"foot\"", "name = \"foot\"\nwidth = 3"},
           {"max_time_s = 6", "max_time_s = -6"}}) {
    text = replaced_once(text, from, to);
  }
  text += "[contact]\nlaw = \"newton\"\n[barrier_2]\nname = \"x\"\n";
  const CampaignCheck found = check(text);
  EXPECT_EQ(found.findings.size(), 7u) << testing::PrintToString(found.findings);
  for (const char* words :
       {"cubes", "friction", "gone.txt", "width", "max_time_s", "newton", "barrier_2"}) {
    EXPECT_TRUE(any(found, words)) << words << testing::PrintToString(found.findings);
  }
}

TEST_F(CampaignChecks, ADamagedTerrainDoesNotHideAMissingBlock) {
  write_text_file(*folder_ / "bad.stl", "solid nothing\nendsolid\n");
  std::string text = with("\"slope.stl\"", "\"bad.stl\"");
  text = replaced_once(text, "[terrain]", "select = [\"cubes\"]\n[terrain]");
  const CampaignCheck found = check(text);
  EXPECT_EQ(found.findings.size(), 2u) << testing::PrintToString(found.findings);
  EXPECT_TRUE(any(found, "cubes") && any(found, "bad.stl"));
}

TEST_F(CampaignChecks, WhatIsNoCampaignAtAllIsOneFinding) {
  EXPECT_EQ(check("friction = = 3\n").findings.size(), 1u);
  EXPECT_EQ(check_campaign(*folder_ / "gone.toml").findings.size(), 1u);
  EXPECT_EQ(check_campaign(folder_->path()).findings.size(), 1u);
  EXPECT_FALSE(check("").findings.empty());
}

}  // namespace
}  // namespace clast
