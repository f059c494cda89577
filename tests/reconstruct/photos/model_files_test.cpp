/// One small project of each format, written here as its program writes it. Expected pixels come
/// from that program's own published formula, written out in the test.
#include "reconstruct/photos/model_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/files/text_file.hpp"
#include "tests/reconstruct/photos/model_texts.hpp"
#include "tests/reconstruct/photos/two_views.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

void write(const std::filesystem::path& path, const std::string& content) {
  write_text_file(path, content);
}

struct Radial {
  double k1, k2, k3;
  double at(double r2) const { return 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3)); }
};

TEST(ModelFiles, ColmapTextIsReadWithItsHalfPixelAndDistortion) {
  const TwoViews views;
  const ScratchFolder folder;
  write(folder / "cameras.txt", "3 OPENCV 1600 1200 1500 1490 803 597 -0.04 0.02 0.001 -0.002\n");
  write(folder / "images.txt", colmap_images(views));
  write(folder / "points3D.txt", "4 0.1 0.2 0.3 1 2 3 0.5 6 0 7 1\n9 0.3 0.1 0 1 2 3 0.5 6 1\n");
  const PhotoModel model = read_photo_model(folder.path());
  EXPECT_EQ(model.source, "COLMAP text");
  EXPECT_FALSE(model.metric);
  ASSERT_EQ(model.points.size(), 2u);
  EXPECT_EQ(model.points[0].position, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(model.points[0].photos, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(model.points[1].photos, (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(model.photos[0].name, "b 0.jpg");
  EXPECT_NEAR((model.photos[1].centre() - views.centre[1]).norm(), 0.0, 1e-12);
  expect_pixels(model, 0.5, [&](int i, const Vec3& p) {
    const Vec3 c = views.in_camera(i, p);
    const double x = c.x() / c.z(), y = c.y() / c.z(), r2 = x * x + y * y;
    const double g = 1.0 - 0.04 * r2 + 0.02 * r2 * r2;
    const double u = x * g + 2.0 * 0.001 * x * y - 0.002 * (r2 + 2.0 * x * x);
    const double v = y * g + 0.001 * (r2 + 2.0 * y * y) - 2.0 * 0.002 * x * y;
    return Vec2(1500.0 * u + 803.0, 1490.0 * v + 597.0);
  });
}

Vec2 metashape_pixel(const Vec3& c) {
  const double x = c.x() / c.z(), y = c.y() / c.z(), r2 = x * x + y * y;
  const double g = Radial{-0.04, 0.02, -0.003}.at(r2), p1 = 0.001, p2 = -0.002;
  const double u = x * g + p1 * (r2 + 2.0 * x * x) + 2.0 * p2 * x * y;
  const double v = y * g + p2 * (r2 + 2.0 * y * y) + 2.0 * p1 * x * y;
  return {800.0 + 3.5 + u * 1490.0 + u * 1.5 + v * -0.75, 600.0 - 4.25 + v * 1490.0};
}

TEST(ModelFiles, MetashapeIsReadWithItsOwnOrderOfTangentialTerms) {
  const TwoViews views;
  const ScratchFolder folder;
  write(folder / "cameras.xml", metashape_xml(views, ""));
  const PhotoModel model = read_photo_model(folder.path());
  EXPECT_FALSE(model.metric);
  EXPECT_EQ(model.photos_without_pose, 1u);
  expect_pixels(model, 0.5,
                [&](int i, const Vec3& p) { return metashape_pixel(views.in_camera(i, p)); });
}

TEST(ModelFiles, MetashapesChunkTransformMakesItMetric) {
  const TwoViews views;
  const ScratchFolder folder;
  const Mat3 turn = Random(4).rotation().toRotationMatrix();
  std::string transform = "<transform><rotation>";
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) transform += text(turn(row, column)) + " ";
  }
  transform +=
      "</rotation><translation>4200000 170000 4780000</translation><scale>0.375</scale>"
      "</transform>";
  write(folder / "cameras.xml", metashape_xml(views, transform));
  const PhotoModel model = read_photo_model(folder.path());
  EXPECT_TRUE(model.metric);
  EXPECT_NEAR((model.photos[0].centre() - model.photos[1].centre()).norm(),
              0.375 * (views.centre[0] - views.centre[1]).norm(), 1e-12);
  expect_pixels(model, 0.5, [&](int i, const Vec3& p) {
    return metashape_pixel(views.in_camera(i, turn.transpose() * p / 0.375));
  });
}

TEST(ModelFiles, AliceVisionIsReadInEveryLayoutOfItsFocalLength) {
  const TwoViews views;
  const auto expected = [&](int i, const Vec3& p) {
    const Vec3 c = views.in_camera(i, p);
    const double x = c.x() / c.z(), y = c.y() / c.z();
    const double g = Radial{-0.04, 0.02, -0.003}.at(x * x + y * y);
    return Vec2(1500.0 * x * g + 810.0, 1500.0 * y * g + 595.0);
  };
  const std::vector<std::array<std::string, 3>> layouts = {
      {"\"1\", \"0\", \"0\"", "\"pxFocalLength\": \"1500\"", "\"810\", \"595\""},
      {"\"1\", \"2\", \"0\"", "\"pxFocalLength\": [\"1500\", \"1500\"]", "\"810\", \"595\""},
      {"\"1\", \"2\", \"1\"", "\"pxFocalLength\": [\"1500\", \"1500\"]", "\"10\", \"-5\""},
      {"\"1\", \"2\", \"6\"", "\"focalLength\": \"33.75\", \"sensorWidth\": \"36\"",
       "\"10\", \"-5\""}};
  for (const auto& [version, focal, principal] : layouts) {
    const ScratchFolder folder;
    write(folder / "cameras.sfm", alicevision_json(views, version, focal, principal));
    const PhotoModel model = read_photo_model(folder.path());
    EXPECT_EQ(model.photos_without_pose, 1u);
    ASSERT_EQ(model.points.size(), 1u);
    EXPECT_EQ(model.points[0].photos, (std::vector<std::uint32_t>{0, 1}));
    expect_pixels(model, 0.0, expected);
  }
}

TEST(ModelFiles, WhatIsNoModelIsRefusedInWords) {
  const ScratchFolder folder;
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder / "gone"); }), "no such file"));
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder.path()); }), "no camera model"));
  write(folder / "a.xml", "<document><chunk>");
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder / "a.xml"); }), "not XML"));
  write(folder / "b.xml", "<document><chunk/></document>");
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder / "b.xml"); }), "Export Cameras"));
  write(folder / "a.sfm", "{\"views\": [");
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder / "a.sfm"); }), "a.sfm"));
  write(folder / "b.sfm", "{\"views\": 3, \"poses\": {}, \"intrinsics\": []}");
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder / "b.sfm"); }), "b.sfm"));
  write(folder / "a.obj", "v 0 0 0\n");
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder / "a.obj"); }), "not a camera model"));
}

TEST(ModelFiles, LensesThatArentKnownAreNamed) {
  const TwoViews views;
  const ScratchFolder folder;
  write(folder / "images.txt", colmap_images(views));
  write(folder / "cameras.txt", "3 FOV 1600 1200 1500 1490 803 597 0.9\n");
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder.path()); }), "FOV"));
  write(folder / "cameras.txt", "3 OPENCV 1600 1200 1500 1490 803\n");
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder.path()); }), "3 parameters"));
  write(folder / "cameras.txt", "4 PINHOLE 1600 1200 1500 1490 803 597\n");
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder.path()); }), "images.txt:2"));
  write(folder / "cameras.txt", "3 PINHOLE 1600 1200 nan 1490 803 597\n");
  EXPECT_TRUE(contains(refusal([&] { read_photo_model(folder.path()); }), "focal length"));
}

TEST(ModelFiles, PhotosAreFoundByNameWithOrWithoutFolderAndExtension) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder / "in");
  for (const char* name : {"in/a.jpg", "b.JPG", "c.png"}) write(folder / name, "x");
  PhotoModel model;
  for (const char* name : {"/far/away/a.jpg", "C:\\photos\\b.JPG", "c"}) {
    model.photos.push_back({name, {}, 0, {}});
  }
  const PhotoModel found = locate_photo_files(model, folder.path());
  EXPECT_EQ(found.photos[0].file, folder / "in/a.jpg");
  EXPECT_EQ(found.photos[1].file, folder / "b.JPG");
  EXPECT_EQ(found.photos[2].file, folder / "c.png");
  model.photos.push_back({"d.jpg", {}, 0, {}});
  EXPECT_TRUE(contains(refusal([&] { locate_photo_files(model, folder.path()); }),
                       "1 of the 4 photos of the camera model are missing: d.jpg"));
  write(folder / "a.jpg", "x");
  EXPECT_TRUE(contains(refusal([&] { locate_photo_files(model, folder.path()); }), "2 files"));
}

}  // namespace
}  // namespace clast
