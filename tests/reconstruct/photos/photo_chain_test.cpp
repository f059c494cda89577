/// The program colmap on both sets of photos, from nothing.
#include <gtest/gtest.h>

#include <iostream>

#include "reconstruct/photos/photo_scan.hpp"
#include "tests/reconstruct/photos/synthetic_rock.hpp"
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

TEST(PhotoChain, TheRealBouldersPhotosArePlaced) {
  const ScratchFolder cache;
  const PhotoModel model =
      colmap_cameras(test_data("photos/nlesc_rock/images"), {.cache = cache.path()});
  std::cout << model.photos.size() << " of 47 photos\n";
  EXPECT_GE(model.photos.size(), 45u);
}

}  // namespace
}  // namespace clast
