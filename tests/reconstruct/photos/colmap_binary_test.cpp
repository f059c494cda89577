/// COLMAP's binary project: read, cut short at every place, with a count that can't be.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/reconstruct/photos/two_views.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

struct ColmapBinary {
  std::string cameras, images, points;

  explicit ColmapBinary(const TwoViews& views) {
    put<std::uint64_t>(cameras, 1);
    put<std::uint32_t>(cameras, 3);
    put<std::int32_t>(cameras, 2);  // SIMPLE_RADIAL
    put<std::uint64_t>(cameras, 1600);
    put<std::uint64_t>(cameras, 1200);
    for (const double value : {1500.0, 800.0, 600.0, -0.04}) put(cameras, value);
    put<std::uint64_t>(images, 2);
    for (int i = 0; i < 2; ++i) {
      const Quat q(views.rotation[i]);
      const Vec3 t = -(views.rotation[i] * views.centre[i]);
      put<std::uint32_t>(images, static_cast<std::uint32_t>(7 - i));
      for (const double value : {q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z()}) {
        put(images, value);
      }
      put<std::uint32_t>(images, 3);
      images += (i == 0 ? std::string("a.jpg") : std::string("b.jpg")) + '\0';
      put<std::uint64_t>(images, 1);
      put(images, 10.0);
      put(images, 20.0);
      put<std::int64_t>(images, 4);
    }
    put<std::uint64_t>(points, 1);
    put<std::uint64_t>(points, 4);
    for (const double value : {0.1, 0.2, 0.3}) put(points, value);
    points += "rgb";
    put(points, 0.5);
    put<std::uint64_t>(points, 2);
    for (const std::uint32_t photo : {7u, 6u}) {
      put(points, photo);
      put<std::uint32_t>(points, 0);
    }
  }
  void write_to(const ScratchFolder& folder) const {
    write_text_file(folder / "cameras.bin", cameras);
    write_text_file(folder / "images.bin", images);
    write_text_file(folder / "points3D.bin", points);
  }
};

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
