#pragma once
/// Photographs of made-up blocks, with what they show.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/angle.hpp"
#include "reconstruct/photos/photo_summary.hpp"
#include "tests/support/made_up_markers.hpp"

namespace clast {

/// Outward cubes of side 1 about the places, of 12 triangles each: -x, +x, -y, +y, -z, +z by twos.
inline TriangleMesh cubes(const std::vector<Vec3>& places) {
  TriangleMesh mesh;
  for (const Vec3& place : places) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < 8; ++i) {
      mesh.vertices.push_back(place +
                              Vec3(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5));
    }
    for (const auto& [a, b, c] : std::vector<std::array<std::uint32_t, 3>>{{0, 4, 6},
                                                                           {0, 6, 2},
                                                                           {1, 3, 7},
                                                                           {1, 7, 5},
                                                                           {0, 1, 5},
                                                                           {0, 5, 4},
                                                                           {2, 6, 7},
                                                                           {2, 7, 3},
                                                                           {0, 2, 3},
                                                                           {0, 3, 1},
                                                                           {4, 5, 7},
                                                                           {4, 7, 6}}) {
      mesh.triangles.push_back({first + a, first + b, first + c});
    }
  }
  return mesh;
}

/// A camera that looks at the middle from an azimuth and a height, 6 m away.
inline Photo camera(const std::string& name, double azimuth, double elevation) {
  const Vec3 eye = 6.0 * Vec3(std::cos(elevation) * std::cos(azimuth),
                              std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const Vec3 ahead = -eye.normalized(), right = ahead.cross(Vec3::UnitZ()).normalized();
  Mat3 turn;
  turn << right.transpose(), ahead.cross(right).transpose(), ahead.transpose();
  return {name, {}, 0, Pose{-turn * eye, Quat(turn)}};
}

inline PhotoScan scan_of(const std::vector<Photo>& photos) {
  PhotoScan scan;
  scan.model.lenses.push_back(
      {.width = 800, .height = 600, .fx = 900.0, .fy = 900.0, .cx = 399.5, .cy = 299.5});
  scan.model.photos = photos;
  scan.model.source = "COLMAP text";
  return scan;
}

/// Cameras every 10 degrees but for one gap, a blurred photo, a lone one, five markers and a board.
struct EvidenceSample {
  PhotoScan scan;
  FieldBlock block;
  EvidenceSample() {
    std::vector<Photo> photos;
    for (int i = 0; i < 33; ++i) {
      photos.push_back(camera("img_" + std::to_string(i), 10.0 * i * kRadiansPerDegree, 0.4));
    }
    photos.push_back(camera("blur", 5.0 * kRadiansPerDegree, 0.4));
    photos.push_back(camera("<lone>", 15.0 * kRadiansPerDegree, 0.9));
    scan = scan_of(photos);
    for (std::size_t i = 0; i + 1 < 33; ++i) scan.cloud.pairs.push_back({i, i + 1, 0.17});
    scan.cloud.blurred = {33};
    scan.photos_without_camera = {"img_90.jpg"};
    scan.metric = true;
    scan.scale_source = "board";
    for (const int id : {0, 1, 2, 5}) {
      scan.markers.markers.push_back(made_up_marker(id, {0.5 * id, 0.1 * id * id, 0.0}, 0.2));
    }
    scan.markers.unlocated = {{3, 2}};
    const ScaleBoard board{.dictionary = "4x4_50",
                           .markers = {{0, {0.0, 0.0, 0.0}},
                                       {1, {0.5, 0.1, 0.0}},
                                       {2, {1.0, 0.4, 0.0}},
                                       {3, {0.2, 0.2, 0.0}},
                                       {5, {2.5, 2.9, 0.0}}}};
    scan.scale = estimate_scale_from_markers(scan.markers.markers, {.board = board});
    block.scan.mesh = cubes({Vec3::Zero()});
  }
};

}  // namespace clast
