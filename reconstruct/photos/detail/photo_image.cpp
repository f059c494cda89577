#include "reconstruct/photos/detail/photo_image.hpp"

#include <opencv2/imgcodecs.hpp>

#include "core/error.hpp"

namespace clast::photos_detail {

namespace {

cv::Mat read_photo(const std::filesystem::path& file, int mode) {
  cv::Mat image;
  std::string reason;
  try {
    image = cv::imread(file.string(), mode | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception& error) {
    reason = std::string(" (") + error.what() + ")";
  }
  if (image.empty()) {
    throw InputError("photo " + file.string() + ": missing, damaged or not a photo" + reason);
  }
  return image;
}

}  // namespace

cv::Mat read_colour_photo(const std::filesystem::path& file) {
  return read_photo(file, cv::IMREAD_COLOR);
}

cv::Mat read_grey_photo(const std::filesystem::path& file) {
  return read_photo(file, cv::IMREAD_GRAYSCALE);
}

PhotoSize photo_size(const std::filesystem::path& file) {
  const cv::Mat image = read_grey_photo(file);
  return {image.cols, image.rows};
}

void write_binary_mask(const std::filesystem::path& mask, const std::filesystem::path& target) {
  const cv::Mat white = read_grey_photo(mask) >= kMaskThreshold;
  if (!cv::imwrite(target.string(), white)) {
    throw InputError(target.string() + ": can't be written; is the disk full?");
  }
}

SingleThreadedOpenCv::SingleThreadedOpenCv() : before_(cv::getNumThreads()) {
  cv::setNumThreads(1);
}
SingleThreadedOpenCv::~SingleThreadedOpenCv() { cv::setNumThreads(before_); }

}  // namespace clast::photos_detail
