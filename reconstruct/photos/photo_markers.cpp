#include "reconstruct/photos/photo_markers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "reconstruct/photos/detail/marker_corners.hpp"
#include "reconstruct/photos/detail/photo_image.hpp"
#include "reconstruct/photos/detail/triangulation.hpp"

namespace clast {

namespace {

/// Photos that "auto" tries every dictionary on.
constexpr std::size_t kTriedPhotos = 8;
/// Fewer sightings in those are chance: what looks like a marker on a rock.
constexpr std::size_t kMinSightings = 3;

using photos_detail::DetectedMarker;

CameraIntrinsics lens_for(const PhotoModel& model, std::size_t photo, const cv::Mat& image) {
  const Photo& p = model.photos[photo];
  return with_error_context("photo " + p.name, [&] {
    return resized_intrinsics(model.lenses[p.lens], image.cols, image.rows);
  });
}

/// The dictionary with the most markers on some photos; empty when none has enough.
std::string likely_dictionary(const PhotoModel& model, unsigned threads) {
  const std::size_t tried = std::min(kTriedPhotos, model.photos.size());
  const std::vector<std::string>& names = photos_detail::common_dictionary_names();
  std::vector<std::vector<std::size_t>> counts(tried, std::vector<std::size_t>(names.size()));
  parallel_for(tried, threads, [&](std::size_t i) {
    const cv::Mat grey =
        photos_detail::read_grey_photo(model.photos[i * model.photos.size() / tried].file);
    for (std::size_t k = 0; k < names.size(); ++k) {
      counts[i][k] = photos_detail::detect_markers(grey, names[k]).size();
    }
  });
  std::string best;
  std::size_t most = kMinSightings - 1;
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < tried; ++i) sum += counts[i][k];
    if (sum > most) {
      most = sum;
      best = names[k];
    }
  }
  return best;
}

/// The marker where the photos that agree see it; none where too few do.
/// @param seen  by photo
std::optional<LocatedMarker> placed(const PhotoModel& model,
                                    const std::vector<std::vector<DetectedMarker>>& detected,
                                    int id, const MarkerOptions& options) {
  LocatedMarker marker{id, {}, model.photos.size(), 0.0};
  double squares = 0.0, count = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<photos_detail::ImageObservation> observations;
    for (std::size_t i = 0; i < detected.size(); ++i) {
      for (const DetectedMarker& one : detected[i]) {
        if (one.id == id) observations.push_back({i, one.corners[k]});
      }
    }
    const auto corner =
        photos_detail::triangulate(model, observations, options.max_reprojection_error);
    if (!corner || corner->inlier_count < options.min_photos) return std::nullopt;
    marker.corners[k] = corner->position;
    marker.photos = std::min(marker.photos, corner->inlier_count);
    squares += corner->squared_error;
    count += static_cast<double>(corner->inlier_count);
  }
  marker.error = std::sqrt(squares / count);
  return marker;
}

}  // namespace

void MarkerOptions::check() const {
  if (dictionary != "auto" && dictionary != "none") photos_detail::opencv_dictionary(dictionary);
  if (min_photos < 2) throw InputError("fewest_photos must be at least 2");
  if (!(max_reprojection_error > 0.0 && max_reprojection_error < 100.0)) {
    throw InputError("largest_error = " + format_significant(max_reprojection_error, 4) +
                     " px is out of range");
  }
}

Vec3 LocatedMarker::centre() const {
  return 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
}

double LocatedMarker::side() const {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) sum += (corners[k] - corners[(k + 1) % 4]).norm();
  return 0.25 * sum;
}

std::vector<std::string> marker_dictionary_names() {
  return photos_detail::common_dictionary_names();
}

MarkerSearchResult search_markers(const PhotoModel& model, const MarkerOptions& options) {
  options.check();
  MarkerSearchResult search;
  if (options.dictionary == "none" || model.photos.empty()) return search;
  const photos_detail::SingleThreadedOpenCv guard;
  const std::string dictionary =
      options.dictionary == "auto" ? likely_dictionary(model, options.threads) : options.dictionary;
  if (dictionary.empty()) return search;
  search.dictionary = dictionary;
  std::vector<std::vector<DetectedMarker>> detected(model.photos.size());
  parallel_for(model.photos.size(), options.threads, [&](std::size_t i) {
    const cv::Mat grey = photos_detail::read_grey_photo(model.photos[i].file);
    const CameraIntrinsics lens = lens_for(model, i, grey);
    const CameraIntrinsics& original = model.lenses[model.photos[i].lens];
    const double to_original = static_cast<double>(original.width) / lens.width;
    for (const DetectedMarker& raw : photos_detail::detect_markers(grey, dictionary)) {
      std::optional<DetectedMarker> fine = photos_detail::refine_marker_corners(raw, grey, lens);
      if (!fine) continue;
      for (Vec2& corner : fine->corners) {
        corner = to_original * (corner + Vec2(0.5, 0.5)) - Vec2(0.5, 0.5);
      }
      detected[i].push_back(*fine);
    }
  });
  std::map<int, std::size_t> photos_of;
  for (const auto& markers : detected) {
    for (const DetectedMarker& marker : markers) ++photos_of[marker.id];
  }
  for (const auto& [id, photos] : photos_of) {
    if (std::optional<LocatedMarker> marker = placed(model, detected, id, options)) {
      search.markers.push_back(*marker);
    } else {
      search.unlocated.push_back({id, photos});
    }
  }
  return search;
}

}  // namespace clast
