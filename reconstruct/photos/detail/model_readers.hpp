#pragma once
/// Readers of camera model formats. They order photos by name.
#include <filesystem>
#include <string>
#include <vector>

#include "reconstruct/photos/photo_model.hpp"

namespace clast::photos_detail {

PhotoModel read_colmap_text(const std::filesystem::path& folder);
PhotoModel read_colmap_binary(const std::filesystem::path& folder);
PhotoModel read_metashape(const std::filesystem::path& file);
PhotoModel read_alicevision(const std::filesystem::path& file);

/// Makes the intrinsics of a COLMAP camera model, such as "SIMPLE_RADIAL". The principal point is
/// shifted by half a pixel to the convention of `CameraIntrinsics`.
/// @throws InputError  if the model is unknown or the number of parameters wrong
CameraIntrinsics make_colmap_intrinsics(const std::string& model, int width, int height,
                                        const std::vector<double>& p);

/// Returns the model with photos sorted by name and their indices updated.
PhotoModel photos_sorted_by_name(PhotoModel model);

/// Converts a rotation matrix to a quaternion.
/// @throws InputError  if it is not a rotation; the message starts with `what`
Quat rotation_from_matrix(const Mat3& matrix, const std::string& what);

}  // namespace clast::photos_detail
