#include <map>
#include <sstream>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "reconstruct/photos/detail/model_readers.hpp"

namespace clast::photos_detail {

namespace {

/// Words of a file's lines; comments are skipped.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& path) : path_(path), text_(read_text_file(path)) {}

  /// False at the end of the file.
  bool next(bool skip_empty) {
    while (at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      line_ = std::string_view(text_).substr(at_, end - at_);
      if (line_.ends_with('\r')) line_.remove_suffix(1);
      at_ = end + 1;
      ++number_;
      rest_ = line_;
      const bool empty = line_.find_first_not_of(" \t") == std::string_view::npos;
      if (line_.starts_with('#') || (empty && skip_empty)) continue;
      return true;
    }
    return false;
  }

  std::string_view word() {
    const std::size_t first = rest_.find_first_not_of(" \t");
    if (first == std::string_view::npos) refuse("ends too early");
    const std::size_t end = std::min(rest_.find_first_of(" \t", first), rest_.size());
    const std::string_view found = rest_.substr(first, end - first);
    rest_.remove_prefix(end);
    return found;
  }
  bool has_more() const { return rest_.find_first_not_of(" \t") != std::string_view::npos; }

  double number() {
    const std::string_view found = word();
    const std::optional<double> value = parse_number(found);
    if (!value) refuse("\"" + std::string(found) + "\" is not a number");
    return *value;
  }
  long id() {
    const double value = number();
    if (!(value >= -1.0 && value < 9e15 &&
          value == static_cast<double>(static_cast<long>(value)))) {
      refuse(format_significant(value, 9) + " is not the number of an item");
    }
    return static_cast<long>(value);
  }
  /// Returns the rest of the line, because names may contain blanks.
  std::string rest() {
    const std::size_t first = rest_.find_first_not_of(" \t");
    if (first == std::string_view::npos) refuse("has no name");
    return std::string(rest_.substr(first));
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(path_.string() + ":" + std::to_string(number_) + ": " + what);
  }

 private:
  std::filesystem::path path_;
  std::string text_;
  std::string_view line_, rest_;
  std::size_t at_ = 0, number_ = 0;
};

}  // namespace

PhotoModel read_colmap_text(const std::filesystem::path& folder) {
  PhotoModel model;
  model.source = "COLMAP text";
  std::map<long, std::size_t> lens_of;
  for (Lines lines(folder / "cameras.txt"); lines.next(true);) {
    const long id = lines.id();
    const std::string kind(lines.word());
    const long width = lines.id(), height = lines.id();
    std::vector<double> parameters;
    while (lines.has_more()) parameters.push_back(lines.number());
    lens_of[id] = model.lenses.size();
    model.lenses.push_back(make_colmap_intrinsics(kind, static_cast<int>(width),
                                                  static_cast<int>(height), parameters));
  }
  std::map<long, std::uint32_t> photo_of;
  for (Lines lines(folder / "images.txt"); lines.next(true);) {
    const long id = lines.id();
    const double w = lines.number(), x = lines.number(), y = lines.number(), z = lines.number();
    Photo photo;
    for (int i = 0; i < 3; ++i) photo.camera_from_world.translation[i] = lines.number();
    photo.camera_from_world.rotation = Quat(w, x, y, z).normalized();
    const long camera = lines.id();
    if (!lens_of.contains(camera)) {
      lines.refuse("camera " + std::to_string(camera) + " is not in cameras.txt");
    }
    photo.lens = lens_of[camera];
    photo.name = lines.rest();
    photo_of[id] = static_cast<std::uint32_t>(model.photos.size());
    model.photos.push_back(photo);
    // Its features follow on a line of their own, which may be empty.
    lines.next(false);
  }
  if (!std::filesystem::exists(folder / "points3D.txt")) return model;
  for (Lines lines(folder / "points3D.txt"); lines.next(true);) {
    lines.id();
    SparsePoint point;
    for (int i = 0; i < 3; ++i) point.position[i] = lines.number();
    for (int i = 0; i < 4; ++i) lines.number();  // colour and error
    while (lines.has_more()) {
      const long photo = lines.id();
      lines.id();
      if (!photo_of.contains(photo)) {
        lines.refuse("image " + std::to_string(photo) + " is not in images.txt");
      }
      point.photos.push_back(photo_of[photo]);
    }
    model.points.push_back(std::move(point));
  }
  return model;
}

}  // namespace clast::photos_detail
