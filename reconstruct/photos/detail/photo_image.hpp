#pragma once
/// Reading of photos with OpenCV.
#include <filesystem>
#include <opencv2/core.hpp>

namespace clast::photos_detail {

struct PhotoSize {
  int width = 0;
  int height = 0;
};

/// Reads the pixels of a photo as stored. The EXIF orientation is ignored, as in structure from
/// motion.
/// @throws InputError  if the file is missing or not an image
cv::Mat read_colour_photo(const std::filesystem::path& file);
cv::Mat read_grey_photo(const std::filesystem::path& file);
PhotoSize photo_size(const std::filesystem::path& file);

inline constexpr int kMaskThreshold = 128;  ///< darker pixels of a mask are not used

/// Converts a mask to black and white and writes it as PNG.
/// @throws InputError  if it cannot be read or written
void write_binary_mask(const std::filesystem::path& mask, const std::filesystem::path& target);

/// Restricts OpenCV to one thread during its lifetime. Photos are processed in parallel instead, so
/// that results do not depend on the machine.
class SingleThreadedOpenCv {
 public:
  SingleThreadedOpenCv();
  ~SingleThreadedOpenCv();
  SingleThreadedOpenCv(const SingleThreadedOpenCv&) = delete;
  SingleThreadedOpenCv& operator=(const SingleThreadedOpenCv&) = delete;

 private:
  int before_;
};

}  // namespace clast::photos_detail
