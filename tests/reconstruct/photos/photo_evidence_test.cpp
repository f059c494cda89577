/// What is told of photos: which see what, which were left out, what the scale rests on.
#include "reconstruct/photos/photo_evidence.hpp"

#include <gtest/gtest.h>

#include "tests/support/made_up_markers.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

constexpr double kDegree = kPi / 180.0;

/// Outward cubes of side 1 about the places, of 12 triangles each: -x, +x, -y, +y, -z, +z by twos.
TriangleMesh cubes(const std::vector<Vec3>& places) {
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
Photo camera(const std::string& name, double azimuth, double elevation) {
  const Vec3 eye = 6.0 * Vec3(std::cos(elevation) * std::cos(azimuth),
                              std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const Vec3 ahead = -eye.normalized(), right = ahead.cross(Vec3::UnitZ()).normalized();
  Mat3 turn;
  turn << right.transpose(), ahead.cross(right).transpose(), ahead.transpose();
  return {name, {}, 0, Pose{-turn * eye, Quat(turn)}};
}

PhotoScan scan_of(const std::vector<Photo>& photos) {
  PhotoScan scan;
  scan.model.lenses.push_back(
      {.width = 800, .height = 600, .fx = 900.0, .fy = 900.0, .cx = 399.5, .cy = 299.5});
  scan.model.photos = photos;
  scan.model.source = "COLMAP text";
  return scan;
}

TEST(SurfaceViews, EachSideIsSeenFromItsOwnSideAndWhatLiesBehindIsNot) {
  PhotoScan scan = scan_of({camera("east", 0.0, 0.0), camera("north", 90.0 * kDegree, 0.0),
                            camera("spare", 180.0 * kDegree, 0.0)});
  scan.cloud.pairs = {{0, 1, 1.0}};  // the third was not compared
  // The second cube stands behind the first as seen from the east.
  const TriangleMesh surface = cubes({{0.6, 0.0, 0.0}, {-0.6, 0.0, 0.0}});
  const SurfaceViews views = surface_views(surface, scan, {Vec3::Zero(), Quat::Identity()});
  const auto seen = [&](std::size_t cube, std::size_t side) {
    EXPECT_EQ(views.photos[12 * cube + 2 * side], views.photos[12 * cube + 2 * side + 1]);
    return views.photos[12 * cube + 2 * side];
  };
  for (std::size_t cube = 0; cube < 2; ++cube) {
    EXPECT_EQ(seen(cube, 0), 0) << "-x: from the photo that was not compared alone";
    EXPECT_EQ(seen(cube, 1), cube == 0 ? 1 : 0) << "+x";
    EXPECT_EQ(seen(cube, 2), 0) << "-y";
    EXPECT_EQ(seen(cube, 3), 1) << "+y";
    EXPECT_EQ(seen(cube, 4) + seen(cube, 5), 0) << "at 90 degrees";
  }
  for (const std::uint16_t pairs : views.pairs) EXPECT_EQ(pairs, 0);
  EXPECT_NEAR(share_seen(surface, views.photos, 1), 3.0 / 12.0, 1e-12);
  EXPECT_EQ(share_seen(surface, views.photos, 2), 0.0);
  EXPECT_EQ(share_seen(surface, views.photos, 0), 1.0);
}

TEST(SurfaceViews, PairsCountWhatBothSee) {
  PhotoScan scan = scan_of({camera("a", 30.0 * kDegree, 0.5), camera("b", 50.0 * kDegree, 0.5)});
  scan.cloud.pairs = {{0, 1, 0.3}};
  const TriangleMesh surface = cubes({Vec3::Zero()});
  // In another frame than that of the cameras.
  const Pose block_from_model{{1.0, 2.0, 3.0}, Quat(Eigen::AngleAxisd(0.8, Vec3::UnitX()))};
  const SurfaceViews views =
      surface_views(transformed(surface, block_from_model), scan, block_from_model);
  EXPECT_NEAR(share_seen(surface, views.photos, 2), 0.5, 1e-12);  // +x, +y, +z
  EXPECT_NEAR(share_seen(surface, views.pairs, 1), 0.5, 1e-12);
}

/// Cameras every 10 degrees but for one gap, a blurred photo, a lone one, five markers and a board.
struct Evidence {
  PhotoScan scan;
  FieldBlock block;
  Evidence() {
    std::vector<Photo> photos;
    for (int i = 0; i < 33; ++i) {
      photos.push_back(camera("img_" + std::to_string(i), 10.0 * i * kDegree, 0.4));
    }
    photos.push_back(camera("blur", 5.0 * kDegree, 0.4));
    photos.push_back(camera("<lone>", 15.0 * kDegree, 0.9));
    scan = scan_of(photos);
    for (std::size_t i = 0; i + 1 < 33; ++i) scan.cloud.pairs.push_back({i, i + 1, 0.17});
    scan.cloud.blurred = {33};
    scan.without_camera = {"img_90.jpg"};
    scan.metric = true;
    scan.scale_source = "board";
    for (const int id : {0, 1, 2, 5}) {
      scan.markers.markers.push_back(made_up_marker(id, {0.5 * id, 0.1 * id * id, 0.0}, 0.2));
    }
    scan.markers.missed = {{3, 2}};
    const ScaleBoard board{.dictionary = "4x4_50",
                           .markers = {{0, {0.0, 0.0, 0.0}},
                                       {1, {0.5, 0.1, 0.0}},
                                       {2, {1.0, 0.4, 0.0}},
                                       {3, {0.2, 0.2, 0.0}},
                                       {5, {2.5, 2.9, 0.0}}}};
    scan.scale = scale_from_markers(scan.markers.markers, {.board = board});
    block.scan.mesh = cubes({Vec3::Zero()});
  }
};

TEST(PhotoEvidence, SaysWhatBecameOfEachMarker) {
  const Evidence made;
  const PhotoEvidence evidence = photo_evidence(made.scan, made.block, "z");
  ASSERT_EQ(evidence.markers.size(), 5u);
  const auto of = [&](int id) {
    return *std::find_if(evidence.markers.begin(), evidence.markers.end(),
                         [&](const MarkerUse& one) { return one.id == id; });
  };
  for (const int id : {0, 1, 2}) EXPECT_TRUE(of(id).used) << id;
  EXPECT_FALSE(of(5).used);
  EXPECT_TRUE(contains(of(5).why, "not where the board has it"));
  EXPECT_FALSE(of(3).used);
  EXPECT_TRUE(contains(of(3).why, "too few photos"));
  EXPECT_EQ(evidence.coverage.front().least, 1);
  EXPECT_NEAR(evidence.coverage.front().photos, 5.0 / 6.0, 1e-12) << "all but the underside";
}

TEST(PhotoSection, HoldsRingCoverageMarkersAndScale) {
  const Evidence made;
  const PhotoEvidence evidence = photo_evidence(made.scan, made.block, "z");
  const std::string html = photo_section(made.scan, evidence, made.block.scan.mesh);
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_EQ(count_of(html, "class=\"seat compared\""), 33u);
  EXPECT_EQ(count_of(html, "class=\"seat alone\""), 1u);
  EXPECT_EQ(count_of(html, "class=\"seat blurred\""), 1u);
  EXPECT_EQ(count_of(html, "class=\"gap\""), 1u) << "40 degrees from the last to the first";
  EXPECT_TRUE(contains(html, "40\xC2\xB0 from azimuth -40\xC2\xB0, between img_32 and img_0"));
  EXPECT_TRUE(contains(html, "1 photo without a camera: img_90.jpg"));
  EXPECT_TRUE(contains(html, "1 photo blurred and skipped: blur"));
  EXPECT_TRUE(contains(html, "away: &lt;lone&gt;"));
  EXPECT_TRUE(contains(html, "35 photos with a camera, by COLMAP text; 33 compared, in 32 pairs"));
  EXPECT_TRUE(contains(html, "markers 0 and 2"));
  EXPECT_TRUE(contains(html, "left out: not where the board has it"));
  EXPECT_TRUE(contains(html, "One unit of the cameras&#39; model is"));
}

TEST(PhotoSection, WithoutAScaleItSaysSo) {
  Evidence made;
  made.scan.scale.reset();
  made.scan.metric = false;
  const PhotoEvidence evidence = photo_evidence(made.scan, made.block, "z");
  const std::string html = photo_section(made.scan, evidence, made.block.scan.mesh);
  EXPECT_TRUE(contains(html, "has no mass"));
  EXPECT_TRUE(contains(html, "distance, units"));
  EXPECT_FALSE(contains(html, "side, m<"));
}

}  // namespace
}  // namespace clast
