/// The program colmap on both sets of photos, from nothing.
#include <gtest/gtest.h>

#include <iostream>

#include "mesh/mesh_topology.hpp"
#include "tests/reconstruct/photos/rock_block.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(PhotoChain, TheRenderedRockIsPlacedScaledAndMeasured) {
  const ScratchFolder cache;
  PhotoScanOptions options;
  options.colmap.cache = cache.path();
  options.scale.marker_side = 0.2;
  const PhotoScan scan =
      reconstruct_from_photos(test_data("photos/synthetic_rock/images"), options);
  EXPECT_EQ(scan.model.photos.size(), 36u);
  const double scale = 1.0 / ToTruth(scan.model).scale;
  std::cout << "scale " << 100.0 * (scale - 1.0) << " %\n";
  EXPECT_NEAR(scale, 1.0, 0.001);
  const RockBlock rock(scan);
  EXPECT_TRUE(inspect_mesh(rock.block.scan.mesh).is_closed());
  for (const int axis : {0, 2}) EXPECT_LT(std::abs(rock.extents[axis]), 0.005) << axis;
  const Underside& underside = *rock.block.underside;
  EXPECT_LE(underside.lower_volume, rock.true_volume);
  EXPECT_GE(underside.upper_volume.value(), rock.true_volume);
}

TEST(PhotoChain, TheRealBouldersPhotosGiveAClosedBlockWithoutAScale) {
  const ScratchFolder cache;
  const std::filesystem::path photos = test_data("photos/nlesc_rock/images");
  const PhotoModel model = run_colmap(photos, {.cache = cache.path()});
  std::cout << model.photos.size() << " of 47 photos\n";
  EXPECT_GE(model.photos.size(), 45u);
  // From here on the cameras come from the cache: this program isn't there.
  PhotoScanOptions options;
  options.colmap = {.program = "no-such-colmap", .cache = cache.path()};
  EXPECT_TRUE(
      contains(refusal([&] { reconstruct_from_photos(photos, options); }), "masses are unknown"));
  options.allow_unscaled = true;
  const PhotoScan scan = reconstruct_from_photos(photos, options);
  EXPECT_FALSE(scan.metric);
  const FieldBlock block = extract_field_blocks(scan.cloud.points, "boulder").front();
  EXPECT_TRUE(inspect_mesh(block.scan.mesh).is_closed());
}

}  // namespace
}  // namespace clast
