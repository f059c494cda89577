#include "reconstruct/photos/photo_masks.hpp"

#include <map>
#include <string>

#include "core/error.hpp"
#include "reconstruct/photos/detail/photo_image.hpp"
#include "reconstruct/photos/photo_model.hpp"

namespace clast {

namespace fs = std::filesystem;

namespace {

std::string pixels(const cv::Mat& image) {
  return std::to_string(image.cols) + " x " + std::to_string(image.rows) + " pixels";
}

void check_mask(const fs::path& file, const fs::path& photo) {
  const cv::Mat mask = photos_detail::read_grey_photo(file),
                image = photos_detail::read_grey_photo(photo);
  if (mask.size() != image.size()) {
    throw InputError("mask " + file.string() + " has " + pixels(mask) + " and its photo " +
                     photo.filename().string() + " " + pixels(image) +
                     "; masks must have the size of their photos");
  }
  double darkest = 0.0, brightest = 0.0;
  cv::minMaxLoc(mask, &darkest, &brightest);
  if (brightest >= photos_detail::kMaskThreshold) return;
  throw InputError("mask " + file.string() + " is all black (its brightest pixel is " +
                   std::to_string(static_cast<int>(brightest)) + ", and " +
                   std::to_string(photos_detail::kMaskThreshold) +
                   " to 255 count as white), so nothing of its photo would be used. Draw the mask "
                   "again, or remove the photo");
}

}  // namespace

std::vector<fs::path> find_masks(const std::vector<fs::path>& photos, const fs::path& folder) {
  std::map<std::string, fs::path> by_stem;
  for (const fs::path& file : find_photos(folder)) by_stem[file.stem().string()] = file;
  std::vector<fs::path> masks;
  for (const fs::path& photo : photos) {
    fs::path found;
    const std::string stem = photo.stem().string();
    for (const std::string& name : {stem, photo.filename().string(), stem + "_mask"}) {
      if (found.empty() && by_stem.contains(name)) found = by_stem[name];
    }
    if (found.empty()) {
      throw InputError(folder.string() + ": no mask for photo " + photo.filename().string() +
                       "; looked for " + stem + ".png, " + photo.filename().string() + ".png and " +
                       stem + "_mask.png");
    }
    check_mask(found, photo);
    masks.push_back(found);
  }
  return masks;
}

}  // namespace clast
