/// Summary of photos: views of each point, photos that were left out, source of the scale.
#include "reconstruct/photos/photo_summary.hpp"

#include <gtest/gtest.h>

#include "core/angle.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/photo_evidence_samples.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

TEST(SurfaceViews, EachSideIsSeenFromItsOwnSideAndWhatLiesBehindIsNot) {
  PhotoScan scan =
      scan_of({camera("east", 0.0, 0.0), camera("north", 90.0 * kRadiansPerDegree, 0.0),
               camera("spare", 180.0 * kRadiansPerDegree, 0.0)});
  scan.cloud.pairs = {{0, 1, 1.0}};  // the third was not compared
  // The second cube stands behind the first as seen from the east.
  const TriangleMesh surface = cubes({{0.6, 0.0, 0.0}, {-0.6, 0.0, 0.0}});
  const SurfaceViews views = count_surface_views(surface, scan, {Vec3::Zero(), Quat::Identity()});
  const auto seen = [&](std::size_t cube, std::size_t side) {
    EXPECT_EQ(views.photos[12 * cube + 2 * side], views.photos[12 * cube + 2 * side + 1]);
    return views.photos[12 * cube + 2 * side];
  };
  for (std::size_t cube = 0; cube < 2; ++cube) {
    EXPECT_EQ(seen(cube, 0), 0) << "-x: from the photo that was not compared alone";
    EXPECT_EQ(seen(cube, 1), cube == 0 ? 1 : 0) << "+x";
    EXPECT_EQ(seen(cube, 2), 0) << "-y";
    EXPECT_EQ(seen(cube, 3), 1) << "+y";
    EXPECT_EQ(seen(cube, 4) + seen(cube, 5), 0) << "at 90 degrees";
  }
  for (const std::uint16_t pairs : views.pairs) EXPECT_EQ(pairs, 0);
  EXPECT_NEAR(observed_fraction(surface, views.photos, 1), 3.0 / 12.0, 1e-12);
  EXPECT_EQ(observed_fraction(surface, views.photos, 2), 0.0);
  EXPECT_EQ(observed_fraction(surface, views.photos, 0), 1.0);
}

TEST(SurfaceViews, PairsCountWhatBothSee) {
  PhotoScan scan = scan_of(
      {camera("a", 30.0 * kRadiansPerDegree, 0.5), camera("b", 50.0 * kRadiansPerDegree, 0.5)});
  scan.cloud.pairs = {{0, 1, 0.3}};
  const TriangleMesh surface = cubes({Vec3::Zero()});
  // In another frame than that of the cameras.
  const Pose block_from_model{{1.0, 2.0, 3.0}, Quat(Eigen::AngleAxisd(0.8, Vec3::UnitX()))};
  const SurfaceViews views =
      count_surface_views(transformed(surface, block_from_model), scan, block_from_model);
  EXPECT_NEAR(observed_fraction(surface, views.photos, 2), 0.5, 1e-12);  // +x, +y, +z
  EXPECT_NEAR(observed_fraction(surface, views.pairs, 1), 0.5, 1e-12);
}

TEST(PhotoSummary, SaysWhatBecameOfEachMarker) {
  const EvidenceSample made;
  const PhotoSummary evidence = summarise_photos(made.scan, made.block, "z");
  ASSERT_EQ(evidence.markers.size(), 5u);
  const auto of = [&](int id) {
    return *std::find_if(evidence.markers.begin(), evidence.markers.end(),
                         [&](const MarkerUsage& one) { return one.id == id; });
  };
  for (const int id : {0, 1, 2}) EXPECT_TRUE(of(id).used) << id;
  EXPECT_FALSE(of(5).used);
  EXPECT_TRUE(contains(of(5).reason, "its position differs from that on the board"));
  EXPECT_FALSE(of(3).used);
  EXPECT_TRUE(contains(of(3).reason, "too few photos"));
  EXPECT_EQ(evidence.coverage.front().min_views, 1);
  EXPECT_NEAR(evidence.coverage.front().photos, 5.0 / 6.0, 1e-12) << "all but the underside";
}

}  // namespace
}  // namespace clast
