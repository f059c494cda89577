#include "reconstruct/photos/model_files.hpp"
#include "reconstruct/photos/photo_masks.hpp"
#include "tests/app/fuzz/readers.hpp"
#include "tests/reconstruct/photos/model_texts.hpp"
#include "tests/support/plain_photo.hpp"

namespace clast {

namespace {

using Files = std::map<std::string, std::string>;

void read_model(const std::filesystem::path& folder) {
  const PhotoModel model = read_photo_model(folder);
  for (const SparsePoint& point : model.points) ASSERT_TRUE(point.position.allFinite());
}

NamedReader model_reader(const std::string& file, const std::function<Files()>& files) {
  return {file, [=]() -> FuzzedReader { return {file, file, files(), read_model}; }};
}

Files colmap_text() {
  return {{"cameras.txt", "3 OPENCV 1600 1200 1500 1490 803 597 -0.04 0.02 0.001 -0.002\n"},
          {"images.txt", colmap_images(TwoViews())},
          {"points3D.txt", "4 0.1 0.2 0.3 1 2 3 0.5 6 0 7 1\n9 0.3 0.1 0 1 2 3 0.5 6 1\n"}};
}

Files colmap_binary() {
  const ColmapBinary model{TwoViews()};
  return {
      {"cameras.bin", model.cameras}, {"images.bin", model.images}, {"points3D.bin", model.points}};
}

std::string bmp() {
  const ScratchFolder folder;
  write_plain_photo(folder / "a.bmp", 40, 30, 1);
  return read_text_file(folder / "a.bmp");
}

NamedReader mask_reader() {
  return {"mask.bmp", []() -> FuzzedReader {
            return {
                "mask.bmp",
                "masks/photo.bmp",
                {{"masks/photo.bmp", bmp()}, {"photo.bmp", bmp()}},
                [](const auto& folder) { find_masks({folder / "photo.bmp"}, folder / "masks"); }};
          }};
}

}  // namespace

std::vector<NamedReader> photo_readers() {
  std::vector<NamedReader> readers;
  for (const char* file : {"cameras.txt", "images.txt", "points3D.txt"}) {
    readers.push_back(model_reader(file, colmap_text));
  }
  for (const char* file : {"cameras.bin", "images.bin", "points3D.bin"}) {
    readers.push_back(model_reader(file, colmap_binary));
  }
  readers.push_back(model_reader("cameras.xml", [] {
    return Files{{"cameras.xml", metashape_xml(TwoViews(), "")}};
  }));
  readers.push_back(model_reader("cameras.sfm", [] {
    return Files{
        {"cameras.sfm", alicevision_json(TwoViews(), "\"1\", \"2\", \"6\"",
                                         "\"focalLength\": \"33.75\", \"sensorWidth\": \"36\"",
                                         "\"10\", \"-5\"")}};
  }));
  readers.push_back(mask_reader());
  return readers;
}

}  // namespace clast
