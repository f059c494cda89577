#pragma once
/// One reader for each format of camera models. Each returns photos in order of their names.
#include <filesystem>
#include <string>
#include <vector>

#include "reconstruct/photos/photo_model.hpp"

namespace clast::photos_detail {

PhotoModel read_colmap_text(const std::filesystem::path& folder);
PhotoModel read_colmap_binary(const std::filesystem::path& folder);
PhotoModel read_metashape(const std::filesystem::path& file);
PhotoModel read_alicevision(const std::filesystem::path& file);

/// Lens of COLMAP's camera `model` ("SIMPLE_RADIAL"); pixels are moved by half a pixel.
/// @throws InputError  a model that isn't known, or a wrong number of parameters
CameraIntrinsics make_colmap_lens(const std::string& model, int width, int height, const std::vector<double>& p);

/// Sorts photos by name and renumbers what names them.
PhotoModel sorted_by_name(PhotoModel model);

/// A rotation from a matrix; @throws InputError with `what` where it is none.
Quat rotation_from_matrix(const Mat3& matrix, const std::string& what);

}  // namespace clast::photos_detail
