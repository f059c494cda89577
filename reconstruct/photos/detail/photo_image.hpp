#pragma once
/// Pixels of photos, by OpenCV.
#include <filesystem>
#include <opencv2/core.hpp>

namespace clast::photos_detail {

struct PhotoSize {
  int width = 0;
  int height = 0;
};

/// The pixels as the camera wrote them: a note of the file on how to turn it is not obeyed, as
/// structure from motion does not either.
/// @throws InputError  missing or no photo, by name
cv::Mat read_colour_photo(const std::filesystem::path& file);
cv::Mat read_grey_photo(const std::filesystem::path& file);
PhotoSize photo_size(const std::filesystem::path& file);

inline constexpr int kMaskThreshold = 128;  ///< of a mask; darker pixels of the photo are not used

/// Writes a mask in black and white alone, as a PNG.
/// @throws InputError  it can't be read or written
void write_binary_mask(const std::filesystem::path& mask, const std::filesystem::path& target);

/// OpenCV works in one thread while this lives: photos are worked on in parallel instead, and its
/// results are the same on any machine.
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
