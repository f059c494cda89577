/// COLMAP's binary project: read, cut short at every place, with a count that can't be.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/reconstruct/photos/model_texts.hpp"
#include "tests/reconstruct/photos/two_views.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(ColmapBinaryFiles, AreRead) {
  const TwoViews views;
  const ScratchFolder folder;
  ColmapBinary(views).write_to(folder);
  const PhotoModel model = read_photo_model(folder.path());
  ASSERT_EQ(model.points.size(), 1u);
  EXPECT_EQ(model.points[0].photos, (std::vector<std::uint32_t>{0, 1}));
  expect_pixels(model, 0.5, [&](int i, const Vec3& p) {
    const Vec3 c = views.in_camera(i, p);
    const double x = c.x() / c.z(), y = c.y() / c.z(), g = 1.0 - 0.04 * (x * x + y * y);
    return Vec2(1500.0 * g * x + 800.0, 1500.0 * g * y + 600.0);
  });
}

TEST(ColmapBinaryFiles, CutShortAnywhereAreRefused) {
  const ColmapBinary whole{TwoViews()};
  for (int file = 0; file < 3; ++file) {
    const std::size_t size =
        std::array{whole.cameras, whole.images, whole.points}[static_cast<std::size_t>(file)]
            .size();
    const ScratchFolder folder;
    for (std::size_t keep = 0; keep < size; keep += 5) {
      ColmapBinary cut = whole;
      (file == 0 ? cut.cameras : file == 1 ? cut.images : cut.points).resize(keep);
      cut.write_to(folder);
      EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder.path()); }), ".bin"))
          << file << " " << keep;
    }
  }
}

TEST(ColmapBinaryFiles, WithAnEnormousCountAreRefused) {
  ColmapBinary model{TwoViews()};
  const std::uint64_t many = ~std::uint64_t{0} / 2;
  std::memcpy(model.points.data(), &many, sizeof many);
  const ScratchFolder folder;
  model.write_to(folder);
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder.path()); }), "damaged"));
}

}  // namespace
}  // namespace clast
