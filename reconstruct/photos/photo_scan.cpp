#include "reconstruct/photos/photo_scan.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "reconstruct/photos/model_files.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMinPhotos = 3;
constexpr double kToldDifference = 0.005;  ///< between markers and the model's own metres

std::size_t photos_directly_in(const fs::path& folder) {
  std::size_t count = 0;
  std::error_code code;
  if (!fs::is_directory(folder, code)) return 0;
  for (const fs::path& file : find_photos(folder)) count += file.parent_path() == folder ? 1 : 0;
  return count;
}

fs::path folder_of_photos(const fs::path& folder) {
  const bool inside = photos_directly_in(folder) < kMinPhotos &&
                      photos_directly_in(folder / "images") >= kMinPhotos;
  return inside ? folder / "images" : folder;
}

/// Photos in the folders of those that have a camera, which have none themselves.
std::vector<std::string> names_without_camera(const PhotoModel& model, const fs::path& photos) {
  std::set<fs::path> placed, folders;
  for (const Photo& photo : model.photos) {
    placed.insert(photo.file);
    folders.insert(photo.file.parent_path());
  }
  std::vector<std::string> names;
  for (const fs::path& file : find_photos(photos)) {
    if (folders.contains(file.parent_path()) && !placed.contains(file)) {
      names.push_back(file.filename().string());
    }
  }
  return names;
}

/// "scale by board: 6 of 6 lengths agree, to 0.0033 %".
std::string scale_words(const PhotoScale& scale, const std::string& source) {
  const auto used = std::count_if(scale.measures.begin(), scale.measures.end(),
                                  [](const ComparedLength& one) { return one.used; });
  std::string text = "scale by " + source + ": " + std::to_string(used) + " of " +
                     std::to_string(scale.measures.size()) + " lengths agree";
  if (used > 1) text += ", to " + format_significant(100.0 * scale.spread, 2) + " %";
  return text;
}

PhotoModel find_cameras(const fs::path& folder, const fs::path& photos,
                        const PhotoScanOptions& options,
                        const std::function<void(const std::string&)>& stage) {
  for (const fs::path& position : {options.model, folder}) {
    if (position.empty() || (position == folder && !contains_photo_model(folder))) continue;
    PhotoModel model = read_photo_model(position);
    if (model.photos.empty()) {
      throw InputError(position.string() + ": none of its photos has a camera; align them first");
    }
    return locate_photo_files(std::move(model), photos);
  }
  ColmapOptions colmap = options.colmap;
  colmap.masks = options.dense.masks;
  return run_colmap(photos, colmap, stage);
}

/// Searches the photos for markers and board, and gives `scan` the scale by them.
void set_scale_by_markers(PhotoScan& scan, const PhotoScanOptions& options) {
  const ScaleOptions& sizes = options.scale;
  const bool charuco = sizes.board && sizes.board->charuco;
  MarkerOptions markers = options.markers;
  if (sizes.board && !charuco) markers.dictionary = sizes.board->dictionary;
  if (!charuco || sizes.marker_side || !sizes.bars.empty()) {
    scan.markers = search_markers(scan.model, markers);
  }
  if (charuco) scan.corners = find_board_corners(scan.model, *sizes.board->charuco, markers);
  scan.scale = estimate_scale_from_markers(scan.markers.markers, sizes, scan.corners);
  scan.scale_source = charuco                 ? "ChArUco board"
                      : sizes.board           ? "board"
                      : scan.scale->from_bars ? "distances of markers"
                                              : "sides of markers";
  scan.notes.push_back(scale_words(*scan.scale, scan.scale_source));
  scan.notes.insert(scan.notes.end(), scan.scale->notes.begin(), scan.scale->notes.end());
  const double factor = scan.scale->metres_per_unit;
  if (scan.model.metric && std::abs(factor - 1.0) > kToldDifference) {
    scan.notes.push_back("according to the markers, lengths are " + format_significant(factor, 4) +
                         " times those of " + scan.model.source + "; the markers were used");
  }
  scan.metric = true;
}

/// Without markers: the scale that was given, or that of the cameras.
/// @returns metres per unit
double scale_without_markers(PhotoScan& scan, const PhotoScanOptions& options) {
  scan.metric = options.metres_per_unit || scan.model.metric;
  if (options.metres_per_unit) {
    scan.scale_source = "given factor";
    return *options.metres_per_unit;
  }
  if (!scan.metric && !options.allow_unscaled) {
    throw InputError(
        "no scale: the units of the cameras are arbitrary. Give the distance between two markers "
        "with `bars`, a board with `board`, the side of markers with `marker_side`, or a measured "
        "length with `metres_per_unit`; `allow_unscaled` continues without a scale: then shapes "
        "are usable, but masses are unknown");
  }
  scan.scale_source = scan.metric ? scan.model.source : "none";
  return 1.0;
}

}  // namespace

void PhotoScanOptions::check() const {
  colmap.check();
  markers.check();
  scale.check();
  dense.check();
  if (metres_per_unit && !(*metres_per_unit > 0.0)) {
    throw InputError("metres_per_unit = " + format_significant(*metres_per_unit, 6) +
                     " must be positive");
  }
}

bool is_photo_folder(const fs::path& folder) {
  return photos_directly_in(folder) >= kMinPhotos ||
         photos_directly_in(folder / "images") >= kMinPhotos;
}

PhotoScan reconstruct_from_photos(const fs::path& folder, const PhotoScanOptions& options,
                                  const std::function<void(const std::string&)>& stage) {
  options.check();
  const auto begin = [&](const std::string& what) {
    if (stage) stage(what);
  };
  PhotoScan scan;
  scan.model = find_cameras(folder, folder_of_photos(folder), options, stage);
  scan.photos_without_camera = names_without_camera(scan.model, folder_of_photos(folder));
  const std::size_t all = scan.model.photos.size() + scan.model.photos_without_pose;
  scan.notes.push_back("cameras of " + std::to_string(scan.model.photos.size()) + " of " +
                       std::to_string(all) + " photos, by " + scan.model.source);
  const ScaleOptions& sizes = options.scale;
  double factor = 1.0;
  if (sizes.marker_side || sizes.board || !sizes.bars.empty()) {
    begin("finding markers");
    set_scale_by_markers(scan, options);
    factor = scan.scale->metres_per_unit;
  } else {
    factor = scale_without_markers(scan, options);
  }
  scan.model = scaled(std::move(scan.model), factor);
  for (LocatedMarker& marker : scan.markers.markers) {
    for (Vec3& corner : marker.corners) corner *= factor;
  }
  for (BoardCorner& corner : scan.corners) corner.position *= factor;
  begin("comparing photos");
  scan.cloud = compute_dense_cloud(scan.model, options.dense);
  scan.notes.insert(scan.notes.end(), scan.cloud.notes.begin(), scan.cloud.notes.end());
  return scan;
}

}  // namespace clast
