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
  /// Camera model (`read_photo_model`). Empty: a model in the photo folder, otherwise COLMAP is
  /// run.
  std::filesystem::path model = {};  ///< in metres if `metric`
  ColmapOptions colmap = {};
  MarkerOptions markers = {};  ///< in the frame of `model`
  ScaleOptions scale = {};     ///< from markers or a board
  /// Metres per model unit, if known otherwise.
  std::optional<double> metres_per_unit = {};
  bool allow_unscaled = false;  ///< accept an unknown scale
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

/// Photo scan: model, markers, scale and points.
struct PhotoScan {
  PhotoModel model;                         ///< in metres where `metric`
  MarkerSearchResult markers;               ///< places in the frame of `model`
  std::vector<BoardCorner> corners;         ///< of a ChArUco board, in the frame of `model`
  std::optional<PhotoScale> scale;          ///< from markers or a board
  std::vector<std::string> without_camera;  ///< names of photos without camera, sorted
  bool metric = false;
  DenseCloud cloud;          ///< in the frame of `model`
  std::string scale_source;  ///< "markers' distances", "none", ...
  std::vector<std::string> notes;
};

/// Reconstructs cameras, scale and points. A marker scale has priority over the model's own scale,
/// and both are compared.
/// @param folder  of photos, or one with a folder `images`
/// @param stage  called with the current step
/// @throws InputError  as the steps; if there is no scale and none is allowed
PhotoScan reconstruct_from_photos(const std::filesystem::path& folder,
                                  const PhotoScanOptions& options = {},
                                  const std::function<void(const std::string&)>& stage = {});

/// True if a folder, or `images` in it, contains photos.
bool is_photo_folder(const std::filesystem::path& folder);

}  // namespace clast
