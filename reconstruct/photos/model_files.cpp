#include "reconstruct/photos/model_files.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/files/input_file.hpp"
#include "core/files/text_file.hpp"
#include "reconstruct/photos/detail/model_readers.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path& path) {
  std::error_code code;
  return fs::is_regular_file(path, code);
}

bool holds_colmap(const fs::path& folder, const std::string& extension) {
  return is_file(folder / ("cameras" + extension)) && is_file(folder / ("images" + extension));
}

/// The file, or the folder of COLMAP's files, that `path` stands for; empty where there is none.
fs::path model_at(const fs::path& path) {
  if (is_file(path)) return path;
  for (const char* inner : {"", "sparse/0", "sparse", "colmap"}) {
    const fs::path folder = *inner == '\0' ? path : path / inner;
    if (holds_colmap(folder, ".txt") || holds_colmap(folder, ".bin")) return folder;
  }
  for (const char* name : {"cameras.xml", "cameras.sfm", "sfm.json"}) {
    if (is_file(path / name)) return path / name;
  }
  return {};
}

PhotoModel read_at(const fs::path& path) {
  if (holds_colmap(path, ".txt")) return photos_detail::read_colmap_text(path);
  if (holds_colmap(path, ".bin")) return photos_detail::read_colmap_binary(path);
  const std::string extension = lower_case_extension(path);
  if (extension == ".xml") return photos_detail::read_metashape(path);
  if (extension == ".sfm" || extension == ".json") return photos_detail::read_alicevision(path);
  throw InputError(
      path.string() +
      ": not a camera model; known are folders of COLMAP (cameras, images and "
      "points3D as .txt or .bin), .xml of Metashape, and .sfm and .json of AliceVision");
}

}  // namespace

bool contains_photo_model(const fs::path& folder) { return !model_at(folder).empty(); }

PhotoModel read_photo_model(const fs::path& path) {
  std::error_code code;
  if (!fs::exists(path, code)) {
    throw InputError(path.string() + ": no such file or folder; check the path");
  }
  const fs::path found = model_at(path);
  if (found.empty()) {
    throw InputError(path.string() +
                     ": no camera model in this folder; COLMAP's has cameras.txt "
                     "or cameras.bin, Metashape's is cameras.xml");
  }
  if (!fs::is_directory(found, code)) check_input_file(found);
  try {
    PhotoModel model = photos_detail::photos_sorted_by_name(read_at(found));
    model.check();
    return model;
  } catch (const InputError& error) {
    const std::string what = error.what();
    if (what.find(found.string()) != std::string::npos) throw;
    throw InputError(found.string() + ": " + what +
                     "; export the model again from the program that made it");
  }
}

namespace photos_detail {

PhotoModel photos_sorted_by_name(PhotoModel model) {
  std::vector<std::uint32_t> order(model.photos.size()), new_index(model.photos.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return model.photos[a].name < model.photos[b].name;
  });
  std::vector<Photo> photos;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    new_index[order[i]] = i;
    photos.push_back(std::move(model.photos[order[i]]));
    if (i > 0 && photos[i].name == photos[i - 1].name) {
      throw InputError("photo " + photos[i].name + " is in the model twice");
    }
  }
  model.photos = std::move(photos);
  for (SparsePoint& point : model.points) {
    for (std::uint32_t& photo : point.photos) {
      if (photo >= new_index.size())
        throw InputError("a point refers to a photo that does not exist");
      photo = new_index[photo];
    }
    std::sort(point.photos.begin(), point.photos.end());
    point.photos.erase(std::unique(point.photos.begin(), point.photos.end()), point.photos.end());
  }
  return model;
}

Quat rotation_from_matrix(const Mat3& matrix, const std::string& what) {
  if (!matrix.allFinite() || (matrix * matrix.transpose() - Mat3::Identity()).norm() > 1e-3 ||
      matrix.determinant() < 0.0) {
    throw InputError(what + ": its rotation is invalid");
  }
  return Quat(matrix).normalized();
}

}  // namespace photos_detail

}  // namespace clast
