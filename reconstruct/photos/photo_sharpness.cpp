#include "reconstruct/photos/photo_sharpness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/parallel.hpp"
#include "reconstruct/photos/detail/photo_image.hpp"

namespace clast {

namespace {

constexpr int kWidth = 1600;    ///< px; larger photos hold noise at the finest scale
constexpr double kSigma = 1.5;  ///< px, of the smoothing

/// Part of the photo about the block; all of it where the block isn't inside.
cv::Rect about_block(const PhotoModel& model, std::size_t i, const PhotoRegion& region,
                     const cv::Mat& image) {
  const cv::Rect all(0, 0, image.cols, image.rows);
  const std::optional<Vec2> projection = project_into_photo(model, i, region.centre);
  if (!projection) return all;
  const CameraIntrinsics& lens = model.lenses[model.photos[i].lens];
  const double factor = static_cast<double>(image.cols) / lens.width;
  const double depth = (model.photos[i].camera_from_world * region.centre).z();
  const int half = static_cast<int>(0.6 * factor * lens.fx * region.radius / depth);
  const cv::Rect part(static_cast<int>(projection->x() * factor) - half,
                      static_cast<int>(projection->y() * factor) - half, 2 * half, 2 * half);
  const cv::Rect inside = part & all;
  return inside.area() > 1000 ? inside : all;
}

/// Energy of the changes along four directions.
std::array<double, 4> energies(const cv::Mat& image) {
  cv::Mat dx, dy;
  cv::Sobel(image, dx, CV_32F, 1, 0);
  cv::Sobel(image, dy, CV_32F, 0, 1);
  const double xx = dx.dot(dx), yy = dy.dot(dy), xy = dx.dot(dy);
  return {xx, yy, 0.5 * (xx + yy) + xy, 0.5 * (xx + yy) - xy};
}

/// Energy that smoothing takes away over what it leaves, along the direction where that is least: a
/// photo may be blurred along one, by a hand that moved.
double detail_of(const cv::Mat& grey) {
  cv::Mat smooth;
  cv::GaussianBlur(grey, smooth, {}, kSigma);
  const std::array<double, 4> fine = energies(grey), coarse = energies(smooth);
  double least = 1e300;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (coarse[i] > 0.0) least = std::min(least, std::max(0.0, fine[i] / coarse[i] - 1.0));
  }
  return least < 1e300 ? least : 0.0;
}

}  // namespace

std::vector<Sharpness> measure_sharpness(const PhotoModel& model, const PhotoRegion& region,
                                         unsigned threads) {
  const photos_detail::SingleThreadedOpenCv guard;
  std::vector<double> kept(model.photos.size());
  parallel_for(model.photos.size(), threads, [&](std::size_t i) {
    cv::Mat grey = photos_detail::read_grey_photo(model.photos[i].file);
    grey = grey(about_block(model, i, region, grey)).clone();
    if (grey.cols > kWidth) {
      cv::resize(grey, grey, {}, static_cast<double>(kWidth) / grey.cols,
                 static_cast<double>(kWidth) / grey.cols, cv::INTER_AREA);
    }
    kept[i] = detail_of(grey);
  });
  std::vector<double> sorted = kept;
  std::sort(sorted.begin(), sorted.end());
  const double middle = sorted.empty() ? 0.0 : sorted[sorted.size() / 2];
  std::vector<Sharpness> result;
  for (const double value : kept) {
    const double relative = middle > 0.0 ? value / middle : 1.0;
    result.push_back({relative, relative < kBlurredSharpness});
  }
  return result;
}

}  // namespace clast
