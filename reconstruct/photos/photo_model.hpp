#pragma once
/// Photographs with their cameras: what structure from motion leaves behind.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/pose.hpp"
#include "reconstruct/photos/lens.hpp"

namespace clast {

/// A photo whose camera is known.
struct Photo {
  std::string name;            ///< as the program that made the model wrote it
  std::filesystem::path file;  ///< empty until it was looked for
  std::size_t lens = 0;        ///< number in `PhotoModel::lenses`
  Pose camera_from_world;

  Vec3 centre() const { return camera_from_world.inverse().translation; }
};

/// A point that was seen in several photos.
struct SparsePoint {
  Vec3 position = Vec3::Zero();
  std::vector<std::uint32_t> photos;  ///< numbers of the photos, ascending
};

/// Cameras and sparse points in one frame.
struct PhotoModel {
  std::vector<CameraIntrinsics> lenses;
  std::vector<Photo> photos;        ///< those with a place, in order of their names
  std::vector<SparsePoint> points;  ///< none where the source has none
  std::size_t photos_without_pose = 0;         ///< photos that the source could not place
  bool metric = false;              ///< the source says that lengths are metres
  std::string source;               ///< "COLMAP text"

  /// Checks lenses, numbers and poses. @throws InputError  naming what is wrong
  void check() const;
};

/// Where a point in the world is seen in a photo. None: `project` gives none.
std::optional<Vec2> project_into_photo(const PhotoModel& model, std::size_t photo, const Vec3& point);

/// Everything enlarged about the origin.
PhotoModel scaled(PhotoModel model, double factor);

/// Finds the file of each photo under `folder`: by the path that its name is, else by file name,
/// else by file name without extension, as some programs write it.
/// @throws InputError  photos that are missing, or several files for one, by name
PhotoModel locate_photo_files(PhotoModel model, const std::filesystem::path& folder);

/// Files of photos in a folder and below, sorted; hidden ones left out.
/// @throws InputError  the folder can't be searched
std::vector<std::filesystem::path> find_photos(const std::filesystem::path& folder);

}  // namespace clast
