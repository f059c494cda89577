// Off a terminal, as in the log of a queue: the standard error of a test is none.
#include "app/progress_bar.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace clast {
namespace {

TEST(ProgressBar, AStepThatTakesLongHasALineWithItsTime) {
  testing::internal::CaptureStderr();
  {
    ProgressBar bar("scans", 1);
    bar.update(0, "reading B017");
    bar.update(0, "COLMAP: matching 36 photos", true);
    bar.update(0, "COLMAP: placing 36 cameras", true);
    bar.update(0, "fitting B017");
  }
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(std::regex_match(text, std::regex("COLMAP: matching 36 photos \\.\\.\\. \\d+ s\n"
                                                "COLMAP: placing 36 cameras \\.\\.\\. \\d+ s\n")))
      << text;
}

TEST(ProgressBar, ALineBegunIsEndedBeforeAnotherIsPrinted) {
  testing::internal::CaptureStderr();
  ProgressBar bar("scans", 2);
  bar.update(0, "COLMAP: matching 36 photos", true);
  bar.clear();
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_EQ(text.back(), '\n') << text;
}

TEST(ProgressBar, NothingIsShownOfWhatIsDoneAtOnce) {
  testing::internal::CaptureStderr();
  {
    ProgressBar bar("runs", 3);
    for (std::size_t done = 0; done <= 3; ++done) bar.update(done);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace clast
