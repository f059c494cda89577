/// Masks by name, and those that can't be meant.
#include "reconstruct/photos/photo_masks.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "tests/support/plain_photo.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

class PhotoMasks : public testing::Test {
 protected:
  PhotoMasks() {
    std::filesystem::create_directories(folder_ / "masks");
    for (const char* name : {"a.bmp", "b.bmp", "c.bmp"}) {
      write_plain_photo(folder_ / name, 16, 12, 1);
      photos_.push_back(folder_ / name);
    }
  }
  void draw(const std::string& name, int brightness, int width = 16) {
    cv::Mat mask = cv::Mat::zeros(12, width, CV_8U);
    mask.at<unsigned char>(5, 5) = static_cast<unsigned char>(brightness);
    cv::imwrite((folder_ / "masks" / name).string(), mask);
  }
  std::vector<std::filesystem::path> masks() const {
    return find_masks(photos_, folder_ / "masks");
  }

  ScratchFolder folder_;
  std::vector<std::filesystem::path> photos_;
};

TEST_F(PhotoMasks, AreFoundByTheThreeNamesInUse) {
  draw("a.png", 255);
  draw("b.bmp.png", 128);
  draw("c_mask.png", 200);
  const std::vector<std::filesystem::path> found = masks();
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].filename(), "a.png");
  EXPECT_EQ(found[1].filename(), "b.bmp.png");
  EXPECT_EQ(found[2].filename(), "c_mask.png");
}

TEST_F(PhotoMasks, AMissingOneIsNamedWithWhatWasLookedFor) {
  draw("a.png", 255);
  draw("c.png", 255);
  const std::string text = refusal([&] { masks(); });
  EXPECT_TRUE(contains(text, "no mask for photo b.bmp"));
  EXPECT_TRUE(contains(text, "b.bmp.png"));
}

TEST_F(PhotoMasks, OneOfAnotherSizeIsNamedWithBoth) {
  for (const char* name : {"a.png", "b.png"}) draw(name, 255);
  draw("c.png", 255, 20);
  const std::string text = refusal([&] { masks(); });
  EXPECT_TRUE(contains(text, "c.png has 20 x 12 pixels and its photo c.bmp 16 x 12"));
}

// Labels written as 0 and 1 look black, and are.
TEST_F(PhotoMasks, ABlackOneIsNamedWithItsBrightestPixel) {
  for (const char* name : {"a.png", "c.png"}) draw(name, 255);
  draw("b.png", 1);
  const std::string text = refusal([&] { masks(); });
  EXPECT_TRUE(contains(text, "b.png is all black (its brightest pixel is 1"));
}

}  // namespace
}  // namespace clast
