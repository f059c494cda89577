#include "reconstruct/photos/dense_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <unordered_map>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "reconstruct/photos/detail/free_space_carving.hpp"
#include "reconstruct/photos/detail/photo_image.hpp"
#include "reconstruct/photos/detail/rectified_pair.hpp"
#include "reconstruct/photos/photo_masks.hpp"
#include "reconstruct/photos/photo_sharpness.hpp"

namespace clast {

namespace {

using photos_detail::DisparityMap;
using photos_detail::kDisparityScale;
using photos_detail::kNoDisparity;
using View = photos_detail::PairProjection;

/// Pairs that look in directions farther apart see different sides.
constexpr double kSameSide = 0.5;  ///< cosine
/// A pair that has seen something this many pixels behind a point has looked through it.
constexpr double kSeeThroughTolerance = 3.0;  ///< times the tolerance
constexpr std::size_t kMinDensePoints = 2000;
constexpr std::size_t kAtATime = 8;  ///< pairs that are fused before their points are added

struct Fused {
  Vec3 position;
  cv::Vec3b colour;
};

/// Points of one pair that others agree with, and where in its picture they are.
std::vector<Fused> fused(const std::vector<View>& views, std::size_t own,
                         const DenseOptions& options, cv::Mat& agreed) {
  const View& view = views[own];
  std::vector<const View*> others;
  for (std::size_t j = 0; j < views.size(); ++j) {
    if (j != own && views[j].direction.dot(view.direction) > kSameSide) others.push_back(&views[j]);
  }
  const photos_detail::Rectification& r = view.depths->view;
  const double through = kSeeThroughTolerance * options.tolerance;
  std::vector<Fused> points;
  agreed = cv::Mat::zeros(r.height, r.width, CV_8U);
  for (int v = 0; v < r.height; ++v) {
    const auto* row = view.depths->disparity.ptr<short>(v);
    for (int u = 0; u < r.width; ++u) {
      if (row[u] == kNoDisparity) continue;
      const Vec3 position = r.back_projected(u, v, row[u] / kDisparityScale);
      Vec3 sum = position;
      std::size_t agree = 1, against = 0;
      for (const View* other : others) {
        const Vec3 q = other->matrix * (position - other->left);
        if (!(q.z() > 0.0)) continue;
        const double inverse = 1.0 / q.z();
        const int x = static_cast<int>(q.x() * inverse + 0.5);
        const int y = static_cast<int>(q.y() * inverse + 0.5);
        const cv::Mat& disparity = other->depths->disparity;
        if (x < 0 || y < 0 || x >= disparity.cols || y >= disparity.rows) continue;
        const short known = disparity.at<short>(y, x);
        if (known == kNoDisparity) continue;
        const double expected = other->focal_baseline * inverse - other->offset;
        const double nearer = expected - known / kDisparityScale;
        if (std::abs(nearer) <= options.tolerance) {
          sum += other->depths->view.back_projected(q.x() * inverse, q.y() * inverse,
                                                    known / kDisparityScale);
          ++agree;
        } else if (nearer > through) {
          ++against;
        }
      }
      if (agree < options.min_agreeing_pairs || against >= agree) continue;
      agreed.at<std::uint8_t>(v, u) = 1;
      points.push_back({sum / static_cast<double>(agree), view.depths->colour.at<cv::Vec3b>(v, u)});
    }
  }
  return points;
}

/// Means of points and colours in cubes.
class Cells {
 public:
  Cells(const Vec3& origin, double side) : origin_(origin), side_(side) {}

  void add(const Fused& point) {
    const Vec3 at = (point.position - origin_) / side_;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto step = static_cast<std::int64_t>(std::floor(at[axis])) + kHalf;
      key = (key << kBits) | (static_cast<std::uint64_t>(step) & (2 * kHalf - 1));
    }
    Cell& cell = cells_[key];
    cell.position += point.position;
    for (int c = 0; c < 3; ++c) cell.colour[c] += point.colour[c];
    ++cell.count;
  }

  void pass_on_points(DenseCloud& cloud) const {
    std::vector<std::uint64_t> keys;
    for (const auto& [key, cell] : cells_) keys.push_back(key);
    std::sort(keys.begin(), keys.end());
    for (const std::uint64_t key : keys) {
      const Cell& cell = cells_.at(key);
      cloud.points.push_back(cell.position / static_cast<double>(cell.count));
      std::array<std::uint8_t, 3> colour{};
      for (std::size_t c = 0; c < 3; ++c) {
        colour[c] = static_cast<std::uint8_t>(cell.colour[2 - c] / cell.count);
      }
      cloud.colours.push_back(colour);
    }
  }

 private:
  static constexpr int kBits = 21;
  static constexpr std::int64_t kHalf = std::int64_t{1} << (kBits - 1);
  struct Cell {
    Vec3 position = Vec3::Zero();
    std::uint32_t colour[3] = {0, 0, 0};
    std::uint32_t count = 0;
  };
  Vec3 origin_;
  double side_;
  std::unordered_map<std::uint64_t, Cell> cells_;
};

std::vector<std::filesystem::path> chosen_masks(const PhotoModel& model,
                                                const std::filesystem::path& folder) {
  if (folder.empty()) return {};
  std::vector<std::filesystem::path> files;
  for (const Photo& photo : model.photos) files.push_back(photo.file);
  return find_masks(files, folder);
}

void skip_blurred(const PhotoModel& model, const DenseOptions& options, DenseCloud& cloud) {
  const std::vector<Sharpness> sharpness = measure_sharpness(model, cloud.region, options.threads);
  std::string names;
  for (std::size_t i = 0; i < sharpness.size(); ++i) {
    if (!sharpness[i].blurred) continue;
    cloud.blurred.push_back(i);
    names += (names.empty() ? "" : ", ") + model.photos[i].name + " (sharpness " +
             format_significant(sharpness[i].relative, 2) + " of the median)";
  }
  if (!names.empty()) cloud.notes.push_back("blurred photos were skipped: " + names);
}

}  // namespace

void DenseOptions::check() const {
  pairs.check();
  const auto require = [](bool fine, const char* name, double value, const char* range) {
    if (fine) return;
    throw InputError(std::string(name) + " = " + format_significant(value, 5) + "; must be " +
                     range);
  };
  require(max_image_side >= 100 && max_image_side <= 10000, "most_pixels", max_image_side,
          "from 100 to 10000");
  require(min_agreeing_pairs >= 1 && min_agreeing_pairs <= 20, "agreeing",
          static_cast<double>(min_agreeing_pairs), "from 1 to 20");
  require(tolerance > 0.0 && tolerance <= 10.0, "tolerance", tolerance, "above 0 and at most 10");
  require(cell > 0.0 && cell <= 100.0, "cell", cell, "above 0 and at most 100");
}

DenseCloud compute_dense_cloud(const PhotoModel& model, const DenseOptions& options,
                               const std::function<void(std::size_t, std::size_t)>& progress) {
  options.check();
  const photos_detail::SingleThreadedOpenCv guard;
  DenseCloud cloud;
  cloud.region = find_photo_region(model);
  const std::vector<std::filesystem::path> masks = chosen_masks(model, options.masks);
  if (options.skip_blurred) skip_blurred(model, options, cloud);
  cloud.pairs = choose_stereo_pairs(model, cloud.region, cloud.blurred, options.pairs);

  const std::size_t count = cloud.pairs.size();
  std::vector<DisparityMap> depths(count);
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(count, options.threads, [&](std::size_t i) {
    depths[i] = photos_detail::match_stereo_pair(model, cloud.pairs[i], cloud.region,
                                                 options.max_image_side, masks);
    const std::lock_guard lock(mutex);
    if (progress) progress(++done, count + count / 4);
  });
  std::vector<View> views;
  std::vector<double> widths;  // of a pixel on the block
  for (const DisparityMap& pair : depths) {
    views.emplace_back(pair);
    widths.push_back((cloud.region.centre - pair.view.left).norm() / pair.view.f);
  }
  std::sort(widths.begin(), widths.end());
  cloud.cell = options.cell * widths[widths.size() / 2];
  Cells cells(cloud.region.centre, cloud.cell);
  std::vector<cv::Mat> agreed(count);
  for (std::size_t first = 0; first < count; first += kAtATime) {
    std::vector<std::vector<Fused>> points(std::min(kAtATime, count - first));
    parallel_for(points.size(), options.threads, [&](std::size_t i) {
      points[i] = fused(views, first + i, options, agreed[first + i]);
    });
    for (const auto& of_pair : points) {
      for (const Fused& point : of_pair) cells.add(point);
    }
    if (progress) progress(count + (first + points.size()) / 4, count + count / 4);
  }
  cells.pass_on_points(cloud);
  cloud.free_space = photos_detail::carve_free_space(views, agreed, cloud.region, options.tolerance,
                                                     options.threads);
  if (cloud.points.size() < kMinDensePoints) {
    throw InputError("the photos have only " + std::to_string(cloud.points.size()) +
                     " points in common, from " + std::to_string(count) +
                     " pairs: too few for a surface. They are blurred, without texture, or too "
                     "far apart: take one every 10-15 degrees, in even light");
  }
  return cloud;
}

}  // namespace clast
