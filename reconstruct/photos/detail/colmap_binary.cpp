#include <array>
#include <bit>
#include <cstring>
#include <map>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "reconstruct/photos/detail/model_readers.hpp"

namespace clast::photos_detail {

namespace {

static_assert(std::endian::native == std::endian::little, "COLMAP's files are little-endian");

/// Numbers of a binary file, one after the other.
class Bytes {
 public:
  explicit Bytes(const std::filesystem::path& path) : path_(path), text_(read_text_file(path)) {}

  template <class T>
  T next() {
    need(sizeof(T));
    T value;
    std::memcpy(&value, text_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  std::string name() {
    const std::size_t end = text_.find('\0', at_);
    if (end == std::string::npos) refuse();
    std::string found = text_.substr(at_, end - at_);
    at_ = end + 1;
    return found;
  }
  /// A count of items of at least so many bytes, which must fit into what is left.
  std::uint64_t count(std::size_t bytes_each) {
    const auto found = next<std::uint64_t>();
    if (found > (text_.size() - at_) / bytes_each) refuse();
    return found;
  }
  void skip(std::uint64_t bytes) {
    need(bytes);
    at_ += bytes;
  }

 private:
  void need(std::uint64_t bytes) const {
    if (bytes > text_.size() - at_) refuse();
  }
  [[noreturn]] void refuse() const {
    throw InputError(path_.string() + ": cut short or damaged at byte " + std::to_string(at_) +
                     "; export the model again");
  }

  std::filesystem::path path_;
  std::string text_;
  std::size_t at_ = 0;
};

struct KnownModel {
  const char* name;
  std::size_t parameters;
};
/// Camera models by COLMAP's numbers.
constexpr std::array<KnownModel, 11> kModels = {{{"SIMPLE_PINHOLE", 3},
                                                 {"PINHOLE", 4},
                                                 {"SIMPLE_RADIAL", 4},
                                                 {"RADIAL", 5},
                                                 {"OPENCV", 8},
                                                 {"OPENCV_FISHEYE", 8},
                                                 {"FULL_OPENCV", 12},
                                                 {"FOV", 5},
                                                 {"SIMPLE_RADIAL_FISHEYE", 4},
                                                 {"RADIAL_FISHEYE", 5},
                                                 {"THIN_PRISM_FISHEYE", 12}}};

/// @returns number in `model` of each lens, by COLMAP's id
std::map<std::uint32_t, std::size_t> read_colmap_cameras(const std::filesystem::path& file,
                                                         PhotoModel& model) {
  std::map<std::uint32_t, std::size_t> lens_of;
  Bytes cameras(file);
  for (std::uint64_t n = cameras.count(24); n > 0; --n) {
    const auto id = cameras.next<std::uint32_t>();
    const auto kind = cameras.next<std::int32_t>();
    const auto width = cameras.next<std::uint64_t>(), height = cameras.next<std::uint64_t>();
    if (kind < 0 || kind >= static_cast<std::int32_t>(kModels.size())) {
      throw InputError("cameras.bin: camera model number " + std::to_string(kind) + " isn't known");
    }
    const KnownModel& known = kModels[static_cast<std::size_t>(kind)];
    std::vector<double> parameters(known.parameters);
    for (double& p : parameters) p = cameras.next<double>();
    lens_of[id] = model.lenses.size();
    model.lenses.push_back(
        make_colmap_intrinsics(known.name, static_cast<int>(std::min(width, 1000000ul)),
                               static_cast<int>(std::min(height, 1000000ul)), parameters));
  }
  return lens_of;
}

/// @returns number in `model` of each photo, by COLMAP's id
std::map<std::uint32_t, std::uint32_t> read_images(
    const std::filesystem::path& file, const std::map<std::uint32_t, std::size_t>& lens_of,
    PhotoModel& model) {
  std::map<std::uint32_t, std::uint32_t> photo_of;
  Bytes images(file);
  for (std::uint64_t n = images.count(73); n > 0; --n) {
    const auto id = images.next<std::uint32_t>();
    std::array<double, 4> q{};
    for (double& value : q) value = images.next<double>();
    Photo photo;
    for (int i = 0; i < 3; ++i) photo.camera_from_world.translation[i] = images.next<double>();
    photo.camera_from_world.rotation = Quat(q[0], q[1], q[2], q[3]).normalized();
    const auto camera = images.next<std::uint32_t>();
    photo.name = images.name();
    const auto lens = lens_of.find(camera);
    if (lens == lens_of.end()) {
      throw InputError("images.bin: camera " + std::to_string(camera) + " is not in cameras.bin");
    }
    photo.lens = lens->second;
    images.skip(24 * images.count(24));
    photo_of[id] = static_cast<std::uint32_t>(model.photos.size());
    model.photos.push_back(photo);
  }
  return photo_of;
}

void read_points(const std::filesystem::path& file,
                 const std::map<std::uint32_t, std::uint32_t>& photo_of, PhotoModel& model) {
  Bytes points(file);
  for (std::uint64_t n = points.count(51); n > 0; --n) {
    points.skip(8);
    SparsePoint point;
    for (int i = 0; i < 3; ++i) point.position[i] = points.next<double>();
    points.skip(11);  // colour and error
    for (std::uint64_t m = points.count(8); m > 0; --m) {
      const auto image = points.next<std::uint32_t>();
      points.skip(4);
      const auto photo = photo_of.find(image);
      if (photo == photo_of.end()) {
        throw InputError("points3D.bin: image " + std::to_string(image) + " is not in images.bin");
      }
      point.photos.push_back(photo->second);
    }
    model.points.push_back(std::move(point));
  }
}

}  // namespace

PhotoModel read_colmap_binary(const std::filesystem::path& folder) {
  PhotoModel model;
  model.source = "COLMAP binary";
  const auto lens_of = read_colmap_cameras(folder / "cameras.bin", model);
  const auto photo_of = read_images(folder / "images.bin", lens_of, model);
  if (std::filesystem::exists(folder / "points3D.bin")) {
    read_points(folder / "points3D.bin", photo_of, model);
  }
  return model;
}

}  // namespace clast::photos_detail
