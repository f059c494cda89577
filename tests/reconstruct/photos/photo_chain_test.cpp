/// The program colmap on both sets of photos, from nothing.
#include <gtest/gtest.h>

#include <iostream>

#include "reconstruct/field_scan.hpp"
#include "reconstruct/photos/photo_scan.hpp"
#include "shapes/mesh_topology.hpp"
#include "tests/reconstruct/photos/synthetic_rock.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(PhotoChain, EveryPhotoOfTheRenderedRockIsPlacedAndTheMarkersGiveItsScale) {
  const ScratchFolder cache;
  PhotoModel model =
      colmap_cameras(test_data("photos/synthetic_rock/images"), {.cache = cache.path()});
  EXPECT_EQ(model.photos.size(), 36u);
  const double truth = ToTruth(model).scale;
  const PhotoScale scale = scale_from_markers(found_markers(model), {.marker_side = 0.2});
  std::cout << "scale " << 100.0 * (scale.metres_per_unit / truth - 1.0) << " %\n";
  EXPECT_NEAR(scale.metres_per_unit, truth, 0.001 * truth);
}

TEST(PhotoChain, TheRealBouldersPhotosGiveAClosedBlockWithoutAScale) {
  const ScratchFolder cache;
  const std::filesystem::path photos = test_data("photos/nlesc_rock/images");
  const PhotoModel model = colmap_cameras(photos, {.cache = cache.path()});
  std::cout << model.photos.size() << " of 47 photos\n";
  EXPECT_GE(model.photos.size(), 45u);
  // From here on the cameras come from the cache: this program isn't there.
  PhotoScanOptions options;
  options.colmap = {.program = "no-such-colmap", .cache = cache.path()};
  EXPECT_TRUE(contains(refusal([&] { photo_scan(photos, options); }), "masses are not"));
  options.allow_unscaled = true;
  const PhotoScan scan = photo_scan(photos, options);
  EXPECT_FALSE(scan.metric);
  const FieldBlock block = field_blocks(scan.cloud.points, "boulder").front();
  EXPECT_TRUE(inspect(block.scan.mesh).closed());
}

}  // namespace
}  // namespace clast
