#pragma once
/// Readers of camera model formats; photos are ordered by name.
#include <filesystem>
#include <string>
#include <vector>

#include "reconstruct/photos/photo_model.hpp"

namespace clast::photos_detail {

PhotoModel read_colmap_text(const std::filesystem::path& folder);
PhotoModel read_colmap_binary(const std::filesystem::path& folder);
PhotoModel read_metashape(const std::filesystem::path& file);
PhotoModel read_alicevision(const std::filesystem::path& file);

/// Makes the intrinsics of a COLMAP camera model ("SIMPLE_RADIAL"); pixel coordinates are shifted
/// by half a pixel.
/// @throws InputError  if the model is unknown or the number of parameters wrong
CameraIntrinsics make_colmap_lens(const std::string& model, int width, int height,
                                  const std::vector<double>& p);

/// Sorts photos by name and updates the indices.
PhotoModel sorted_by_name(PhotoModel model);

/// Converts a rotation matrix.
/// @throws InputError  starting with `what`, if it is not a rotation
Quat rotation_from_matrix(const Mat3& matrix, const std::string& what);

}  // namespace clast::photos_detail
