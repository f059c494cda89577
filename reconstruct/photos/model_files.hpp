#pragma once
/// Camera models of other programs.
#include <filesystem>

#include "reconstruct/photos/photo_model.hpp"

namespace clast {

/// Reads cameras and sparse points:
/// - COLMAP: a folder with cameras, images and points3D as .txt or .bin
/// - Metashape: the .xml that "Export cameras" writes; a scale of the chunk makes it metric
/// - AliceVision or Meshroom: .sfm or .json with "views" and "poses"
///
/// A folder may also hold one of these files, or a model in `sparse/0`, `sparse` or `colmap`.
/// Photos without a pose are counted and omitted.
/// @throws InputError  if there is no model, a file is damaged, or a lens model is unknown
PhotoModel read_photo_model(const std::filesystem::path& path);

/// True if a folder contains a model that `read_photo_model` can read.
bool contains_photo_model(const std::filesystem::path& folder);

}  // namespace clast
