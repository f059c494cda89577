#pragma once
/// The whole way from a folder of photos to points in metres.
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
  /// Cameras of another program, as `read_photo_model` takes them. Empty: a model in the folder of
  /// the photos, else colmap is run.
  std::filesystem::path model = {};
  ColmapOptions colmap = {};
  MarkerOptions markers = {};
  ScaleOptions scale = {};
  /// Metres per unit of the cameras' model where it is known some other way.
  std::optional<double> metres_per_unit = {};
  bool allow_unscaled = false;  ///< go on without any scale
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

/// A photographed block as points, with what a report tells of it.
struct PhotoScan {
  PhotoModel model;                         ///< in metres where `metric`
  MarkerSearchResult markers;                     ///< places in the frame of `model`
  std::vector<BoardCorner> corners;         ///< of a ChArUco board, in the frame of `model`
  std::optional<PhotoScale> scale;          ///< from markers or a board
  std::vector<std::string> without_camera;  ///< names of files beside the photos, sorted
  bool metric = false;
  DenseCloud cloud;          ///< in the frame of `model`
  std::string scale_source;  ///< "markers' distances", "none", ...
  std::vector<std::string> notes;
};

/// Cameras, scale, points. A scale of markers goes before the one that the model's program gives,
/// and what both say is compared.
/// @param folder  of photos, or one that holds them in `images`
/// @param stage   called with what is being done
/// @throws InputError  what the steps throw; no scale, where that isn't allowed
PhotoScan reconstruct_from_photos(const std::filesystem::path& folder, const PhotoScanOptions& options = {},
                     const std::function<void(const std::string&)>& stage = {});

/// Whether a folder is one block's photos: it, or `images` in it, holds some.
bool is_photo_folder(const std::filesystem::path& folder);

}  // namespace clast
