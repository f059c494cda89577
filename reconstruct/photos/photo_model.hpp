#pragma once
/// Photos with cameras and sparse points, from structure from motion.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/pose.hpp"
#include "reconstruct/photos/lens.hpp"

namespace clast {

struct Photo {
  std::string name;            ///< as in the model
  std::filesystem::path file;  ///< empty until located
  std::size_t lens = 0;        ///< index into `PhotoModel::lenses`
  Pose camera_from_world;

  Vec3 centre() const { return camera_from_world.inverse().translation; }
};

/// Sparse point observed in several photos.
struct SparsePoint {
  Vec3 position = Vec3::Zero();
  std::vector<std::uint32_t> photos;  ///< with a pose, ordered by name
};

/// Camera model: cameras and sparse points in one frame.
struct PhotoModel {
  std::vector<CameraIntrinsics> lenses;
  std::vector<Photo> photos;            ///< those with a place, in order of their names
  std::vector<SparsePoint> points;      ///< may be empty
  std::size_t photos_without_pose = 0;  ///< number of photos without pose in the source
  bool metric = false;                  ///< the source states lengths in metres
  std::string source;                   ///< such as "COLMAP text"

  /// Checks intrinsics, indices and poses.
  /// @throws InputError  naming the problem
  void check() const;
};

/// Projects a world point into a photo; empty as `project`.
std::optional<Vec2> project_into_photo(const PhotoModel& model, std::size_t photo,
                                       const Vec3& point);

PhotoModel scaled(PhotoModel model, double factor);

/// Locates the file of each photo under `folder`: by its relative path, otherwise by file name,
/// otherwise by file name without extension.
/// @throws InputError  naming missing or ambiguous photos
PhotoModel locate_photo_files(PhotoModel model, const std::filesystem::path& folder);

/// Lists photo files in a folder recursively, sorted, without hidden ones.
/// @throws InputError  if the folder cannot be searched
std::vector<std::filesystem::path> find_photos(const std::filesystem::path& folder);

}  // namespace clast
