/// The part of a block's page that is about its photographs.
#include "report/scans/photo_section.hpp"

#include <gtest/gtest.h>

#include "tests/support/markup.hpp"
#include "tests/support/photo_evidence_samples.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

TEST(PhotoSection, HoldsRingCoverageMarkersAndScale) {
  const EvidenceSample made;
  const PhotoSummary evidence = summarise_photos(made.scan, made.block, "z");
  const std::string html = format_photo_section(made.scan, evidence, made.block.scan.mesh);
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_EQ(count_of(html, "class=\"seat compared\""), 33u);
  EXPECT_EQ(count_of(html, "class=\"seat alone\""), 1u);
  EXPECT_EQ(count_of(html, "class=\"seat blurred\""), 1u);
  EXPECT_EQ(count_of(html, "class=\"gap\""), 1u) << "40 degrees from the last to the first";
  EXPECT_TRUE(contains(html, "40\xC2\xB0 from azimuth -40\xC2\xB0, between img_32 and img_0"));
  EXPECT_TRUE(contains(html, "1 photo without a camera: img_90.jpg"));
  EXPECT_TRUE(contains(html, "1 photo blurred and skipped: blur"));
  EXPECT_TRUE(contains(html, "away: &lt;lone&gt;"));
  EXPECT_TRUE(
      contains(html, "35 photos with a camera position from COLMAP text; 33 matched, in 32 pairs"));
  EXPECT_TRUE(contains(html, "markers 0 and 2"));
  EXPECT_TRUE(contains(html, "left out: its position differs from that on the board"));
  EXPECT_TRUE(contains(html, "One unit of the cameras&#39; model is"));
}

TEST(PhotoSection, WithoutAScaleItSaysSo) {
  EvidenceSample made;
  made.scan.scale.reset();
  made.scan.metric = false;
  const PhotoSummary evidence = summarise_photos(made.scan, made.block, "z");
  const std::string html = format_photo_section(made.scan, evidence, made.block.scan.mesh);
  EXPECT_TRUE(contains(html, "has no mass"));
  EXPECT_TRUE(contains(html, "distance, units"));
  EXPECT_FALSE(contains(html, "side, m<"));
}

}  // namespace
}  // namespace clast
