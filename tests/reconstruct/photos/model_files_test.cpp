/// One small project of each format, written here as its program writes it. Expected pixels come
/// from that program's own published formula, written out in the test.
#include "reconstruct/photos/model_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "core/text_file.hpp"
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

std::string colmap_images(const TwoViews& views) {
  std::string images = "# comment\n";
  for (int i = 0; i < 2; ++i) {
    const Quat q(views.rotation[i]);
    const Vec3 t = -(views.rotation[i] * views.centre[i]);
    // The second photo comes first: numbers in the file are not the order of names.
    images += std::to_string(7 - i) + " " + text(q.w()) + " " + text(q.x()) + " " + text(q.y()) +
              " " + text(q.z()) + " " + text(t.x()) + " " + text(t.y()) + " " + text(t.z()) +
              " 3 b " + std::to_string(i) + ".jpg\n" + (i == 0 ? "\n" : "10 20 4 30 40 -1\n");
  }
  return images;
}

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
  EXPECT_EQ(model.points[0].place, Vec3(0.1, 0.2, 0.3));
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

/// Cameras as Metashape exports them, in a chunk turned and scaled against the world.
std::string metashape_xml(const TwoViews& views, const std::string& chunk_transform) {
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<document version=\"2.0.0\"><chunk>\n"
      "<sensors next_id=\"1\"><sensor id=\"0\" label=\"phone\" type=\"frame\">"
      "<resolution width=\"1600\" height=\"1200\"/>"
      "<calibration type=\"frame\" class=\"initial\"><f>1</f></calibration>"
      "<calibration type=\"frame\" class=\"adjusted\"><resolution width=\"1600\" height=\"1200\"/>"
      "<f>1490</f><cx>3.5</cx><cy>-4.25</cy><b1>1.5</b1><b2>-0.75</b2><k1>-0.04</k1><k2>0.02</k2>"
      "<k3>-0.003</k3><p1>0.001</p1><p2>-0.002</p2></calibration></sensor></sensors>\n<cameras>\n";
  xml += "<camera id=\"9\" sensor_id=\"0\" label=\"lost\"/>\n<group id=\"0\">";
  for (int i = 0; i < 2; ++i) {
    xml += "<camera id=\"" + std::to_string(i) + "\" sensor_id=\"0\" label=\"p" +
           std::to_string(i) + "\"><transform>";
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        xml += text(views.rotation[i](column, row)) + " ";  // world from camera
      }
      xml += text(views.centre[i][row]) + " ";
    }
    xml += "0 0 0 1</transform></camera>\n";
  }
  return xml + "</group></cameras>" + chunk_transform + "</chunk></document>\n";
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
  EXPECT_EQ(model.unplaced, 1u);
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

std::string alicevision_json(const TwoViews& views, const std::string& version,
                             const std::string& focal, const std::string& principal) {
  std::string json = "{\"version\": [" + version + "], \"views\": [";
  for (int i = 0; i < 2; ++i) {
    json += "{\"viewId\": \"" + std::to_string(70 - i) + "\", \"poseId\": \"" +
            std::to_string(70 - i) + "\", \"intrinsicId\": \"5\", \"path\": \"/far/away/p" +
            std::to_string(i) + ".jpg\", \"width\": \"1600\", \"height\": \"1200\"},";
  }
  json +=
      "{\"viewId\": \"1\", \"poseId\": \"1\", \"intrinsicId\": \"5\", \"path\": \"lost.jpg\"}],"
      "\"intrinsics\": [{\"intrinsicId\": \"5\", \"width\": \"1600\", \"height\": \"1200\", " +
      focal + ", \"type\": \"radial3\", \"principalPoint\": [" + principal +
      "], \"distortionParams\": [\"-0.04\", \"0.02\", \"-0.003\"]}], \"poses\": [";
  for (int i = 0; i < 2; ++i) {
    json += std::string(i > 0 ? "," : "") + "{\"poseId\": \"" + std::to_string(70 - i) +
            "\", \"pose\": {\"transform\": {\"rotation\": [";
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        json += std::string(row + column > 0 ? "," : "") + "\"" +
                text(views.rotation[i](row, column)) + "\"";
      }
    }
    json += "], \"center\": [";
    for (int axis = 0; axis < 3; ++axis) {
      json += std::string(axis > 0 ? "," : "") + "\"" + text(views.centre[i][axis]) + "\"";
    }
    json += "]}, \"locked\": \"0\"}}";
  }
  return json +
         "], \"structure\": [{\"landmarkId\": \"1\", \"X\": [\"0.1\", \"0.2\", \"0.3\"], "
         "\"observations\": [{\"observationId\": \"70\"}, {\"observationId\": \"69\"}]}]}";
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
    EXPECT_EQ(model.unplaced, 1u);
    ASSERT_EQ(model.points.size(), 1u);
    EXPECT_EQ(model.points[0].photos, (std::vector<std::uint32_t>{0, 1}));
    expect_pixels(model, 0.0, expected);
  }
}

std::string openmvg_json(const TwoViews& views) {
  std::string json = "{\"sfm_data_version\": \"0.3\", \"root_path\": \"/far\", \"views\": [";
  for (int i = 0; i < 2; ++i) {
    json += std::string(i > 0 ? "," : "") + "{\"key\": " + std::to_string(i) +
            ", \"value\": {\"polymorphic_id\": 1073741824, \"ptr_wrapper\": {\"id\": 1, \"data\": "
            "{\"local_path\": \"\", \"filename\": \"p" +
            std::to_string(i) +
            ".jpg\", \"width\": 1600, \"height\": 1200, \"id_view\": " + std::to_string(i) +
            ", \"id_intrinsic\": 0, \"id_pose\": " + std::to_string(i) + "}}}}";
  }
  json +=
      "], \"intrinsics\": [{\"key\": 0, \"value\": {\"polymorphic_id\": 2147483649, "
      "\"polymorphic_name\": \"pinhole_brown_t2\", \"ptr_wrapper\": {\"id\": 2147483660, \"data\": "
      "{\"value0\": {\"width\": 1600, \"height\": 1200, \"focal_length\": 1500.0, "
      "\"principal_point\": [810.0, 595.0]}, \"disto_t2\": [-0.04, 0.02, -0.003, 0.001, -0.002]}}}"
      "}], \"extrinsics\": [";
  for (int i = 0; i < 2; ++i) {
    json += std::string(i > 0 ? "," : "") + "{\"key\": " + std::to_string(i) +
            ", \"value\": {\"rotation\": [";
    for (int row = 0; row < 3; ++row) {
      json += std::string(row > 0 ? "," : "") + "[" + text(views.rotation[i](row, 0)) + "," +
              text(views.rotation[i](row, 1)) + "," + text(views.rotation[i](row, 2)) + "]";
    }
    json += "], \"center\": [" + text(views.centre[i].x()) + "," + text(views.centre[i].y()) + "," +
            text(views.centre[i].z()) + "]}}";
  }
  return json +
         "], \"structure\": [{\"key\": 0, \"value\": {\"X\": [0.1, 0.2, 0.3], \"observations\": "
         "[{\"key\": 0, \"value\": {\"id_feat\": 1, \"x\": [1, 2]}}]}}]}";
}

TEST(ModelFiles, OpenMvgIsRead) {
  const TwoViews views;
  const ScratchFolder folder;
  write(folder / "sfm_data.json", openmvg_json(views));
  const PhotoModel model = read_photo_model(folder.path());
  EXPECT_EQ(model.source, "OpenMVG");
  ASSERT_EQ(model.points.size(), 1u);
  expect_pixels(model, 0.0, [&](int i, const Vec3& p) {
    const Vec3 c = views.in_camera(i, p);
    const double x = c.x() / c.z(), y = c.y() / c.z(), r2 = x * x + y * y;
    const double g = Radial{-0.04, 0.02, -0.003}.at(r2), t1 = 0.001, t2 = -0.002;
    return Vec2(1500.0 * (x * g + t2 * (r2 + 2.0 * x * x) + 2.0 * t1 * x * y) + 810.0,
                1500.0 * (y * g + t1 * (r2 + 2.0 * y * y) + 2.0 * t2 * x * y) + 595.0);
  });
}

TEST(ModelFiles, BundlerIsReadWithItsAxesAndTheSizesOfItsPhotos) {
  const TwoViews views;
  const ScratchFolder folder;
  std::string bundle = "# Bundle file v0.3\n3 1\n";
  for (int i = 0; i < 2; ++i) {
    // x right, y up, looking along -z.
    const Mat3 turn = Vec3(1.0, -1.0, -1.0).asDiagonal();
    const Mat3 rotation = turn * views.rotation[i];
    const Vec3 t = -(rotation * views.centre[i]);
    bundle += "150 -0.04 0.02\n";
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) bundle += text(rotation(row, column)) + " ";
      bundle += "\n";
    }
    bundle += text(t.x()) + " " + text(t.y()) + " " + text(t.z()) + "\n";
  }
  bundle += "0 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n0.1 0.2 0.3\n1 2 3\n2 0 5 1.5 2.5 1 6 1.5 2.5\n";
  write(folder / "bundle.out", bundle);
  write(folder / "list.txt", "./p0.png 0 150\n./p1.png\nlost.png\n");
  for (const char* name : {"p0.png", "p1.png"}) {
    cv::imwrite((folder / name).string(), cv::Mat(120, 160, CV_8UC1, cv::Scalar(90)));
  }
  const PhotoModel model = read_photo_model(folder.path());
  EXPECT_EQ(model.unplaced, 1u);
  ASSERT_EQ(model.points.size(), 1u);
  EXPECT_EQ(model.points[0].photos, (std::vector<std::uint32_t>{0, 1}));
  expect_pixels(model, 0.5, [&](int i, const Vec3& p) {
    const Vec3 c = views.in_camera(i, p);
    const Vec2 q(c.x() / c.z(), -c.y() / c.z());  // Bundler's -P / P.z
    const double g = 1.0 - 0.04 * q.squaredNorm() + 0.02 * q.squaredNorm() * q.squaredNorm();
    return Vec2(80.0 + 150.0 * g * q.x(), 60.0 - 150.0 * g * q.y());
  });
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
  const PhotoModel found = with_files(model, folder.path());
  EXPECT_EQ(found.photos[0].file, folder / "in/a.jpg");
  EXPECT_EQ(found.photos[1].file, folder / "b.JPG");
  EXPECT_EQ(found.photos[2].file, folder / "c.png");
  model.photos.push_back({"d.jpg", {}, 0, {}});
  EXPECT_TRUE(contains(refusal([&] { with_files(model, folder.path()); }),
                       "1 of the 4 photos of the camera model are not there: d.jpg"));
  write(folder / "a.jpg", "x");
  EXPECT_TRUE(contains(refusal([&] { with_files(model, folder.path()); }), "2 files"));
}

}  // namespace
}  // namespace clast
