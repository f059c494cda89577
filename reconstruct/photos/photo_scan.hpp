#pragma once
/// Reconstruction of metric points from a folder of photos.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "reconstruct/photos/colmap_run.hpp"
#include "reconstruct/photos/dense_cloud.hpp"
#include "reconstruct/photos/photo_scale.hpp"

namespace clast {

struct PhotoScanOptions {
  /// Path of the camera model (`read_photo_model`). If empty, a model in the photo folder is used;
  /// without one, COLMAP is run.
  std::filesystem::path model = {};
  ColmapOptions colmap = {};
  MarkerOptions markers = {};
  ScaleOptions scale = {};  ///< from markers or a board
  /// Known scale of the model, m per model unit. Empty if it is estimated or stated by the model.
  std::optional<double> metres_per_unit = {};
  bool allow_unscaled = false;  ///< true: an unknown scale is accepted
  DenseOptions dense = {};

  void check() const;  ///< throws what its members throw
};

template <class Visit>
void visit_fields(const PhotoScanOptions& options, Visit&& visit) {
  const auto& [model, colmap, markers, scale, metres_per_unit, allow_unscaled, dense] = options;
  visit("model", model);
  visit("colmap", colmap);
  visit("markers", markers);
  visit("scale", scale);
  visit("metres_per_unit", metres_per_unit);
  visit("allow_unscaled", allow_unscaled);
  visit("dense", dense);
}

/// Result of a photo scan: camera model, markers, scale and dense points.
struct PhotoScan {
  PhotoModel model;                  ///< in metres if `metric`
  MarkerSearchResult markers;        ///< positions in the frame of `model`
  std::vector<BoardCorner> corners;  ///< corners of a ChArUco board, in the frame of `model`
  std::optional<PhotoScale> scale;   ///< scale from markers or a board
  std::vector<std::string> photos_without_camera;  ///< names of photos without camera, sorted
  bool metric = false;
  DenseCloud cloud;          ///< in the frame of `model`
  std::string scale_source;  ///< source of the scale, such as "markers' distances" or "none"
  std::vector<std::string> notes;
};

/// Reconstructs cameras, scale and points. A scale from markers has priority over that of the
/// model. If both exist, they are compared.
/// @param folder  folder of photos, or folder that contains a folder `images`
/// @param stage  called with the current step
/// @throws InputError  if a step fails, or if there is no scale and `allow_unscaled` is false
PhotoScan reconstruct_from_photos(const std::filesystem::path& folder,
                                  const PhotoScanOptions& options = {},
                                  const std::function<void(const std::string&)>& stage = {});

/// True if a folder, or `images` in it, contains photos.
bool is_photo_folder(const std::filesystem::path& folder);

}  // namespace clast
