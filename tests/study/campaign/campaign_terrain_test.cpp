// Keys of [terrain] that say how a survey is gridded, checked and mended.
#include "tests/study/campaign_file.hpp"

namespace clast {
namespace {

std::string with_terrain(const std::string& lines) {
  std::string text = kCampaign;
  const std::string place = "resolution_m = 0.5\n";
  return text.replace(text.find(place), place.size(), lines);
}

TEST_F(CampaignFile, TerrainChecksAreRead) {
  write_text_file(folder_ / "edges.geojson", "stand-in");
  const Campaign campaign = read(with_terrain(
      "percentile = 20\noutliers_m = 3.5\nfill_m = 4\ncrack_m = 0.02\nspike_steepness = 0\n"
      "smoothing = 2\ntolerance_m = 0.1\nbreaklines = \"edges.geojson\"\ncut_zones = true\n"
      "border_distance_m = 12\n"));
  EXPECT_EQ(campaign.terrain.percentile, 20.0);
  EXPECT_EQ(campaign.terrain.outliers, 3.5);
  EXPECT_EQ(campaign.terrain.fill, 4.0);
  EXPECT_EQ(campaign.terrain.crack, 0.02);
  EXPECT_EQ(campaign.terrain.spike_steepness, 0.0);
  EXPECT_EQ(campaign.terrain.smoothing, 2);
  EXPECT_EQ(campaign.terrain.tolerance, 0.1);
  ASSERT_EQ(campaign.terrain.breaklines.size(), 1u);
  EXPECT_EQ(campaign.terrain.breaklines[0], folder_ / "edges.geojson");
  EXPECT_TRUE(campaign.terrain.cut_zones);
  EXPECT_EQ(campaign.border_distance, 12.0);
  EXPECT_EQ(read(kCampaign).terrain.spike_steepness, TerrainOptions{}.spike_steepness);
}

TEST_F(CampaignFile, TerrainChecksOutOfRangeAreRefused) {
  EXPECT_EQ(refusal(with_terrain("percentile = 120\n")),
            "campaign.toml:10: [terrain] percentile = 120: must be 0 (the lowest point), or from "
            "1e-06 to 100");
  EXPECT_EQ(refusal(with_terrain("cut_zones = 1\n")),
            "campaign.toml:10: [terrain] cut_zones = 1: must be true or false");
  EXPECT_NE(refusal(with_terrain("tolerance_m = 0\n")), "");
  EXPECT_NE(refusal(with_terrain("breaklines = \"none.geojson\"\n")), "");
}

TEST_F(CampaignFile, ZoneRulesAreAccepted) {
  std::string text = kCampaign;
  const std::string names = "zones = [\"blue\", \"gray\"]";
  text.replace(text.find(names), names.size(),
               "zones = [\"blue=slope>60\", \"gray=height<1450&slope>=30\", \"gray=else\"]");
  EXPECT_EQ(read(text).terrain.zones.size(), 3u);
}

}  // namespace
}  // namespace clast
