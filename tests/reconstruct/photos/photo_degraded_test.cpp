/// Poor copies of the rendered photo set: good points, or a refusal that says what to do.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "mesh/mesh_io.hpp"
#include "mesh/triangle_tree.hpp"
#include "reconstruct/photos/dense_cloud.hpp"
#include "reconstruct/photos/photo_sharpness.hpp"
#include "tests/reconstruct/photos/synthetic_rock.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

/// The model with some of its photos.
PhotoModel with_photos(const PhotoModel& model, const std::vector<std::size_t>& kept) {
  PhotoModel result = model;
  result.photos.clear();
  result.points.clear();
  std::vector<int> number(model.photos.size(), -1);
  for (const std::size_t i : kept) {
    number[i] = static_cast<int>(result.photos.size());
    result.photos.push_back(model.photos[i]);
  }
  for (const SparsePoint& point : model.points) {
    SparsePoint own{point.position, {}};
    for (const std::uint32_t photo : point.photos) {
      if (number[photo] >= 0) own.photos.push_back(static_cast<std::uint32_t>(number[photo]));
    }
    if (own.photos.size() >= 2) result.points.push_back(own);
  }
  return result;
}

std::vector<std::size_t> every(std::size_t step, std::size_t count) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < count; i += step) kept.push_back(i);
  return kept;
}

/// Mean distance of the points of the rock, above its foot, to its true surface, in shares of L.
double mean_error(const DenseCloud& cloud, const ToTruth& to_truth) {
  const TriangleMesh rock = read_mesh(test_data("photos/synthetic_rock/gt_rock.ply"));
  const TriangleTree tree(rock);
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < cloud.points.size(); i += 7) {
    const Vec3 position = to_truth * cloud.points[i];
    const double distance = std::sqrt(tree.closest_point(position).squared_distance);
    if (position.z() < 0.06 || distance > 0.02) continue;
    sum += distance / 0.7294;
    count += 1.0;
  }
  return sum / count;
}

/// Copies of the photos, changed.
PhotoModel changed(const ScratchFolder& folder,
                   const std::function<void(cv::Mat&, std::size_t)>& change, int quality) {
  PhotoModel model = colmap_model();
  for (std::size_t i = 0; i < model.photos.size(); ++i) {
    cv::Mat image = cv::imread(model.photos[i].file.string());
    change(image, i);
    model.photos[i].file = folder / model.photos[i].name;
    cv::imwrite(model.photos[i].file.string(), image, {cv::IMWRITE_JPEG_QUALITY, quality});
  }
  return model;
}

TEST(DegradedPhotos, EverySecondPhotoStillGivesGoodPoints) {
  const PhotoModel all = colmap_model();
  const DenseCloud cloud = compute_dense_cloud(with_photos(all, every(2, all.photos.size())),
                                               {.max_image_side = 800, .min_agreeing_pairs = 2});
  const double error = mean_error(cloud, ToTruth(all));
  std::cout << cloud.pairs.size() << " pairs, " << cloud.points.size() << " points, mean "
            << 100.0 * error << " %\n";
  EXPECT_LT(error, 0.002);
}

TEST(DegradedPhotos, AQuarterOfThemIsRefusedWithTheAngleBetweenThem) {
  const PhotoModel all = colmap_model();
  const std::string text =
      refusal([&] { compute_dense_cloud(with_photos(all, every(4, all.photos.size()))); });
  EXPECT_TRUE(contains(text, "among 9 photos"));
  EXPECT_TRUE(contains(text, "degrees apart"));
  EXPECT_TRUE(contains(text, "every 10-15 degrees"));
}

TEST(DegradedPhotos, SixThatAreFiftyDegreesApartAreRefused) {
  const PhotoModel all = colmap_model();
  const std::string text = refusal([&] {
    compute_dense_cloud(with_photos(all, {0, 4, 8, 12, 16, 20}));
  });
  EXPECT_TRUE(contains(text, "only 0 pairs among 6 photos"));
  EXPECT_TRUE(contains(text, "every 10-15 degrees"));
}

TEST(DegradedPhotos, StrongCompressionCostsLittle) {
  const ScratchFolder folder;
  const PhotoModel model = changed(
      folder, [](cv::Mat&, std::size_t) {}, 30);
  const DenseCloud cloud = compute_dense_cloud(model, {.max_image_side = 800});
  const double error = mean_error(cloud, ToTruth(model));
  std::cout << cloud.points.size() << " points, mean " << 100.0 * error << " %\n";
  EXPECT_TRUE(cloud.blurred.empty());
  EXPECT_LT(error, 0.002);
}

TEST(DegradedPhotos, BlurredOnesAreNamed) {
  const ScratchFolder folder;
  const PhotoModel model = changed(
      folder,
      [](cv::Mat& image, std::size_t i) {
        if (i == 4) cv::GaussianBlur(image, image, {}, 3.0);
        if (i == 17) cv::blur(image, image, {9, 1});  // a hand that moved
      },
      82);
  const std::vector<Sharpness> sharpness = measure_sharpness(model, find_photo_region(model));
  for (std::size_t i = 0; i < sharpness.size(); ++i) {
    EXPECT_EQ(sharpness[i].blurred, i == 4 || i == 17)
        << model.photos[i].name << " " << sharpness[i].relative;
  }
}

}  // namespace
}  // namespace clast
