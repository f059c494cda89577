/// Stored COLMAP models: every point is seen where COLMAP says.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "core/files/text_file.hpp"
#include "reconstruct/photos/model_files.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {
namespace {

/// Observations of images.txt by image number: its name and the pixel of each feature.
struct Image {
  std::string name;
  std::vector<Vec2> pixels;
};

std::map<int, Image> observed(const std::filesystem::path& folder) {
  std::map<int, Image> images;
  std::istringstream lines(read_text_file(folder / "images.txt"));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream head(line);
    int id = 0;
    double skipped = 0.0;
    head >> id;
    for (int i = 0; i < 8; ++i) head >> skipped;
    head >> images[id].name;
    std::getline(lines, line);
    std::istringstream features(line);
    for (double x, y, point; features >> x >> y >> point;) images[id].pixels.push_back({x, y});
  }
  return images;
}

class StoredModel : public testing::TestWithParam<const char*> {};

// COLMAP writes the mean error of each point over its photos, so the reader and the lens must give
// the same number, point by point.
TEST_P(StoredModel, EveryPointHasTheReprojectionErrorThatColmapWrote) {
  const auto folder = test_data(std::string("photos/") + GetParam() + "/colmap_txt");
  const PhotoModel model = read_photo_model(folder);
  const std::map<int, Image> images = observed(folder);
  ASSERT_EQ(images.size(), model.photos.size());
  std::map<std::string, std::size_t> number;
  for (std::size_t i = 0; i < model.photos.size(); ++i) number[model.photos[i].name] = i;
  std::istringstream lines(read_text_file(folder / "points3D.txt"));
  std::size_t points = 0;
  double worst = 0.0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream words(line);
    double id, x, y, z, colour, error;
    words >> id >> x >> y >> z >> colour >> colour >> colour >> error;
    double sum = 0.0;
    int count = 0;
    for (int image, feature; words >> image >> feature; ++count) {
      const Image& seen = images.at(image);
      const std::optional<Vec2> position =
          project_into_photo(model, number.at(seen.name), {x, y, z});
      ASSERT_TRUE(position.has_value());
      sum +=
          (*position + Vec2(0.5, 0.5) - seen.pixels.at(static_cast<std::size_t>(feature))).norm();
    }
    worst = std::max(worst, std::abs(sum / count - error));
    ++points;
  }
  EXPECT_EQ(points, model.points.size());
  EXPECT_GT(points, 5000u);
  std::cout << GetParam() << ": at most " << worst << " px off over " << points << " points\n";
  EXPECT_LT(worst, 0.1);
}
INSTANTIATE_TEST_SUITE_P(Photos, StoredModel, testing::Values("synthetic_rock", "nlesc_rock"));

}  // namespace
}  // namespace clast
