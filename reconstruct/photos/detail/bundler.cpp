#include <map>
#include <sstream>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"
#include "reconstruct/photos/detail/model_readers.hpp"
#include "reconstruct/photos/detail/photo_image.hpp"

namespace clast::photos_detail {

namespace {

/// Numbers separated by blanks, to the end of the file.
class Numbers {
 public:
  explicit Numbers(const std::filesystem::path& file) : file_(file), words_(read_text_file(file)) {
    const std::string text = words_.str();
    if (text.starts_with('#')) {
      std::string heading;
      std::getline(words_, heading);
    }
  }
  double next() {
    std::string word;
    if (!(words_ >> word)) throw InputError(file_.string() + ": cut short; export the model again");
    const std::optional<double> value = number_in(word);
    if (!value) {
      throw InputError(file_.string() + ": \"" + word + "\" is no number; export the model again");
    }
    return *value;
  }
  std::size_t count(std::size_t most) {
    const double value = next();
    if (!(value >= 0.0 && value <= static_cast<double>(most))) {
      throw InputError(file_.string() + ": " + with_digits(value, 9) +
                       " is no count of items; export the model again");
    }
    return static_cast<std::size_t>(value);
  }

 private:
  std::filesystem::path file_;
  std::istringstream words_;
};

std::vector<std::string> names_beside(const std::filesystem::path& file) {
  for (const char* name : {"list.txt", "bundle.out.list.txt"}) {
    const std::filesystem::path list = file.parent_path() / name;
    if (!std::filesystem::exists(list)) continue;
    std::istringstream lines(read_text_file(list));
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string word;
      if (words >> word) names.push_back(word.starts_with("./") ? word.substr(2) : word);
    }
    return names;
  }
  throw InputError(file.string() +
                   ": list.txt, which names the photos, is not beside it; put it there");
}

/// @returns number in `model` of each photo that has a camera
std::map<std::size_t, std::uint32_t> read_bundler_cameras(Numbers& numbers,
                                                          const std::vector<std::string>& names,
                                                          PhotoModel& model) {
  std::map<std::size_t, std::uint32_t> photo_of;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double f = numbers.next(), k1 = numbers.next(), k2 = numbers.next();
    Mat3 rotation;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) rotation(row, column) = numbers.next();
    }
    Vec3 translation;
    for (int axis = 0; axis < 3; ++axis) translation[axis] = numbers.next();
    if (f == 0.0) {
      ++model.unplaced;
      continue;
    }
    // Bundler's camera looks along -z with y up: turned by half a turn about x.
    const Mat3 turn = Vec3(1.0, -1.0, -1.0).asDiagonal();
    Photo photo{names[i], {}, model.lenses.size(), {}};
    photo.camera_from_world = {turn * translation, rotation_from(turn * rotation, names[i])};
    photo_of[i] = static_cast<std::uint32_t>(model.photos.size());
    model.photos.push_back(photo);
    model.lenses.push_back({.fx = f, .fy = f, .radial = {k1, k2, 0.0, 0.0}});
  }
  return photo_of;
}

SparsePoint read_point(Numbers& numbers, std::size_t cameras,
                       const std::map<std::size_t, std::uint32_t>& photo_of) {
  SparsePoint point;
  for (int axis = 0; axis < 3; ++axis) point.place[axis] = numbers.next();
  for (int colour = 0; colour < 3; ++colour) numbers.next();
  for (std::size_t seen = numbers.count(cameras); seen > 0; --seen) {
    const auto photo = photo_of.find(numbers.count(cameras));
    if (photo != photo_of.end()) point.photos.push_back(photo->second);
    for (int skipped = 0; skipped < 3; ++skipped) numbers.next();
  }
  return point;
}

/// Gives every lens the size of its photo, and the middle of it as principal point.
void set_sizes(PhotoModel& model) {
  for (Photo& photo : model.photos) {
    Lens& lens = model.lenses[photo.lens];
    const PhotoSize size = photo_size(photo.file);
    lens.width = size.width;
    lens.height = size.height;
    lens.cx = 0.5 * size.width - 0.5;
    lens.cy = 0.5 * size.height - 0.5;
  }
}

}  // namespace

PhotoModel read_bundler(const std::filesystem::path& file, const std::filesystem::path& photos) {
  PhotoModel model;
  model.source = "Bundler";
  const std::vector<std::string> names = names_beside(file);
  Numbers numbers(file);
  const std::size_t cameras = numbers.count(1000000), points = numbers.count(1000000000);
  if (cameras != names.size()) {
    throw InputError(file.string() + ": " + std::to_string(cameras) +
                     " cameras, but list.txt has " + std::to_string(names.size()) +
                     " photos; give the list that belongs to it");
  }
  const std::map<std::size_t, std::uint32_t> photo_of = read_bundler_cameras(numbers, names, model);
  for (std::size_t i = 0; i < points; ++i) {
    model.points.push_back(read_point(numbers, cameras, photo_of));
  }
  model = with_files(std::move(model), photos.empty() ? file.parent_path() : photos);
  set_sizes(model);
  return model;
}

}  // namespace clast::photos_detail
