#pragma once
/// Camera model: photos with camera poses and sparse points, from structure from motion.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/pose.hpp"
#include "reconstruct/photos/lens.hpp"

namespace clast {

struct Photo {
  std::string name;            ///< name in the model
  std::filesystem::path file;  ///< empty until located
  std::size_t lens = 0;        ///< index into `PhotoModel::lenses`
  Pose camera_from_world;

  Vec3 centre() const { return camera_from_world.inverse().translation; }
};

/// Sparse point observed in several photos.
struct SparsePoint {
  Vec3 position = Vec3::Zero();
  std::vector<std::uint32_t> photos;  ///< indices of the photos that show it
};

/// Camera model: cameras and sparse points in one frame.
struct PhotoModel {
  std::vector<CameraIntrinsics> lenses;
  std::vector<Photo> photos;            ///< photos with a camera pose, ordered by name
  std::vector<SparsePoint> points;      ///< may be empty
  std::size_t photos_without_pose = 0;  ///< number of photos without pose in the source
  bool metric = false;                  ///< true if the source states lengths in metres
  std::string source;                   ///< such as "COLMAP text"

  /// Checks intrinsics, indices and poses.
  /// @throws InputError  if a value is invalid; names the problem
  void check() const;
};

/// Projects a point in the frame of the model into a photo. Empty if the point is behind the camera
/// or beyond the range of its lens distortion.
std::optional<Vec2> project_into_photo(const PhotoModel& model, std::size_t photo,
                                       const Vec3& point);

PhotoModel scaled(PhotoModel model, double factor);

/// Locates the file of each photo under `folder`. Files are searched by relative path, then by file
/// name, then by file name without extension.
/// @throws InputError  if photos are missing or ambiguous; names them
PhotoModel locate_photo_files(PhotoModel model, const std::filesystem::path& folder);

/// Lists the photo files in a folder and its subfolders, sorted by path. Hidden files are omitted.
/// @throws InputError  if the folder cannot be searched
std::vector<std::filesystem::path> find_photos(const std::filesystem::path& folder);

}  // namespace clast
