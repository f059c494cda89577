#include "reconstruct/photos/photo_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/error.hpp"
#include "core/files/text_file.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kToldNames = 5;

/// "a, b, c and 4 more".
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kToldNames); ++i) {
    text += (i > 0 ? ", " : "") + names[i];
  }
  if (names.size() > kToldNames) {
    text += " and " + std::to_string(names.size() - kToldNames) + " more";
  }
  return text;
}

/// The file name in a path that may be of Windows.
std::string file_name(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }

}  // namespace

void PhotoModel::check() const {
  for (const CameraIntrinsics& lens : lenses) lens.check();
  for (const Photo& photo : photos) {
    if (photo.lens >= lenses.size()) {
      throw InputError("photo " + photo.name +
                       " refers to a camera that the model doesn't contain");
    }
    const Pose& pose = photo.camera_from_world;
    const bool fine = pose.translation.allFinite() && pose.rotation.coeffs().allFinite() &&
                      std::abs(pose.rotation.norm() - 1.0) < 1e-6;
    if (!fine)
      throw InputError("photo " + photo.name + ": its pose is not a rotation and a position");
  }
  for (const SparsePoint& point : points) {
    const bool known = std::all_of(point.photos.begin(), point.photos.end(),
                                   [&](std::uint32_t photo) { return photo < photos.size(); });
    if (!point.position.allFinite() || !known) {
      throw InputError(
          "a sparse point has no finite position, or refers to a photo that does not exist");
    }
  }
}

std::optional<Vec2> project_into_photo(const PhotoModel& model, std::size_t photo,
                                       const Vec3& point) {
  const Photo& p = model.photos[photo];
  return project(model.lenses[p.lens], p.camera_from_world * point);
}

PhotoModel scaled(PhotoModel model, double factor) {
  for (Photo& photo : model.photos) photo.camera_from_world.translation *= factor;
  for (SparsePoint& point : model.points) point.position *= factor;
  return model;
}

std::vector<fs::path> find_photos(const fs::path& folder) {
  static const std::set<std::string> kPhotos = {".jpg", ".jpeg", ".png", ".tif", ".tiff", ".bmp"};
  std::vector<fs::path> found;
  std::error_code code;
  for (fs::recursive_directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    std::error_code ignored;
    const bool hidden = entry->path().filename().string().starts_with(".");
    if (hidden && entry->is_directory(ignored)) entry.disable_recursion_pending();
    if (!hidden && entry->is_regular_file(ignored) &&
        kPhotos.contains(lower_case_extension(entry->path()))) {
      found.push_back(entry->path());
    }
  }
  if (code) throw InputError(folder.string() + ": can't be searched (" + code.message() + ")");
  std::sort(found.begin(), found.end());
  return found;
}

PhotoModel locate_photo_files(PhotoModel model, const fs::path& folder) {
  std::multimap<std::string, fs::path> by_name, by_stem;
  for (const fs::path& file : find_photos(folder)) {
    by_name.emplace(file.filename().string(), file);
    by_stem.emplace(file.stem().string(), file);
  }
  std::vector<std::string> missing;
  for (Photo& photo : model.photos) {
    std::error_code code;
    if (fs::is_regular_file(folder / photo.name, code)) {
      photo.file = folder / photo.name;
      continue;
    }
    const std::string name = file_name(photo.name);
    const bool known = by_name.contains(name);
    const auto& files = known ? by_name : by_stem;
    const std::string key = known ? name : fs::path(name).stem().string();
    const std::size_t count = files.count(key) > 0 ? files.count(key) : by_stem.count(name);
    const auto file = files.count(key) > 0 ? files.find(key) : by_stem.find(name);
    if (count > 1) {
      throw InputError("photo " + photo.name + ": " + std::to_string(count) + " files in " +
                       folder.string() + " have this name");
    }
    if (count == 0) {
      missing.push_back(photo.name);
      continue;
    }
    photo.file = file->second;
  }
  if (!missing.empty()) {
    throw InputError(folder.string() + ": " + std::to_string(missing.size()) + " of the " +
                     std::to_string(model.photos.size()) +
                     " photos of the camera model are missing: " + listed(missing));
  }
  return model;
}

}  // namespace clast
