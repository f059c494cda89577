#pragma once
/// Small projects of two photos, written as each program writes them.
#include <cstring>
#include <string>

#include "core/files/text_file.hpp"
#include "tests/reconstruct/photos/two_views.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

inline std::string colmap_images(const TwoViews& views) {
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

/// Cameras as Metashape exports them, in a chunk turned and scaled against the world.
inline std::string metashape_xml(const TwoViews& views, const std::string& chunk_transform) {
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

inline std::string alicevision_json(const TwoViews& views, const std::string& version,
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

template <class T>
void put_bytes(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

struct ColmapBinary {
  std::string cameras, images, points;

  explicit ColmapBinary(const TwoViews& views) {
    put_bytes<std::uint64_t>(cameras, 1);
    put_bytes<std::uint32_t>(cameras, 3);
    put_bytes<std::int32_t>(cameras, 2);  // SIMPLE_RADIAL
    put_bytes<std::uint64_t>(cameras, 1600);
    put_bytes<std::uint64_t>(cameras, 1200);
    for (const double value : {1500.0, 800.0, 600.0, -0.04}) put_bytes(cameras, value);
    put_bytes<std::uint64_t>(images, 2);
    for (int i = 0; i < 2; ++i) {
      const Quat q(views.rotation[i]);
      const Vec3 t = -(views.rotation[i] * views.centre[i]);
      put_bytes<std::uint32_t>(images, static_cast<std::uint32_t>(7 - i));
      for (const double value : {q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z()}) {
        put_bytes(images, value);
      }
      put_bytes<std::uint32_t>(images, 3);
      images += (i == 0 ? std::string("a.jpg") : std::string("b.jpg")) + '\0';
      put_bytes<std::uint64_t>(images, 1);
      put_bytes(images, 10.0);
      put_bytes(images, 20.0);
      put_bytes<std::int64_t>(images, 4);
    }
    put_bytes<std::uint64_t>(points, 1);
    put_bytes<std::uint64_t>(points, 4);
    for (const double value : {0.1, 0.2, 0.3}) put_bytes(points, value);
    points += "rgb";
    put_bytes(points, 0.5);
    put_bytes<std::uint64_t>(points, 2);
    for (const std::uint32_t photo : {7u, 6u}) {
      put_bytes(points, photo);
      put_bytes<std::uint32_t>(points, 0);
    }
  }
  void write_to(const ScratchFolder& folder) const {
    write_text_file(folder / "cameras.bin", cameras);
    write_text_file(folder / "images.bin", images);
    write_text_file(folder / "points3D.bin", points);
  }
};

}  // namespace clast
