// Pictures of meshes, and the parts of a scan's page.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "report/blocks/mesh_picture.hpp"
#include "report/scans/repair_sections.hpp"
#include "report/scans/scan_page.hpp"
#include "report/scans/scan_pictures.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/cut_mesh.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

using namespace report_detail;

constexpr Rgb kWhite{255, 255, 255}, kRed{200, 0, 0}, kGreen{0, 200, 0};

Canvas::Paint all(const Rgb& colour) {
  return [colour](std::uint32_t, const Vec3&, bool) { return colour; };
}

Camera camera_on(const std::vector<Vec3>& points, const Vec3& toward, std::uint32_t width,
                 std::uint32_t height) {
  std::array<Camera, 1> camera = {make_camera(toward)};
  frame(camera, points, width, height);
  return camera[0];
}

std::size_t drawn_pixels(const Canvas& canvas) {
  std::size_t count = 0;
  for (const Rgb& pixel : canvas.picture()) count += pixel != kWhite;
  return count;
}

TEST(MeshPicture, CamerasAreUprightAndRightHanded) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Camera camera = make_camera(random.unit_vector());
    EXPECT_LT((camera.right.cross(camera.up) - camera.toward).norm(), 1e-12);
    EXPECT_NEAR(camera.right.z(), 0.0, 1e-12);
    EXPECT_GE(camera.up.z(), 0.0);
  }
  EXPECT_LT((make_camera(-Vec3::UnitZ()).up - Vec3::UnitY()).norm(), 1e-12);
}

TEST(MeshPicture, AFramedSceneIsInsideEveryPictureAtOneScale) {
  const TriangleMesh rock = rock_mesh(8, {0.7, 0.3, 0.2}, 4);
  std::array<Camera, 3> cameras = {make_camera({1, 0, 0}), make_camera({0.2, -1, 0.5}),
                                   make_camera({0, 0, -1})};
  frame(cameras, rock.vertices, 200, 120);
  double widest = 0.0;
  for (const Camera& camera : cameras) {
    EXPECT_EQ(camera.pixel, cameras[0].pixel);
    Vec2 low(1e9, 1e9), high(-1e9, -1e9);
    for (const Vec3& v : rock.vertices) {
      const Vec2 at = camera.projected(v).head<2>();
      low = low.cwiseMin(at), high = high.cwiseMax(at);
    }
    EXPECT_GT(low.minCoeff(), 0.0);
    EXPECT_LT(high.x(), 200.0);
    EXPECT_LT(high.y(), 120.0);
    EXPECT_NEAR(low.x() + high.x(), 200.0, 1e-6);  // in the middle
    EXPECT_NEAR(low.y() + high.y(), 120.0, 1e-6);
    widest = std::max({widest, (high.x() - low.x()) / 200.0, (high.y() - low.y()) / 120.0});
  }
  EXPECT_NEAR(widest, 0.84, 1e-9) << "the largest view fills its picture but for the margins";
}

TEST(MeshPicture, ABoxCoversItsSilhouette) {
  const TriangleMesh box = box_mesh({2.0, 3.0, 1.0}, 4);
  const Camera camera = camera_on(box.vertices, {0, -1, 0}, 400, 300);
  Canvas canvas(camera);
  canvas.draw(box, all(kRed));
  const double expected = 2.0 * 1.0 / (camera.pixel * camera.pixel);
  const double edge = 2.0 * (2.0 + 1.0) / camera.pixel;  // pixels that a side may touch
  EXPECT_NEAR(static_cast<double>(drawn_pixels(canvas)), expected, edge);
}

TEST(MeshPicture, NearHidesFarInWhateverOrderTheyAreDrawn) {
  const TriangleMesh far_box = box_mesh({1.0, 1.0, 1.0});
  TriangleMesh near_box = far_box;
  for (Vec3& v : near_box.vertices) v = 0.5 * v + Vec3(0.25, -2.0, 0.25);
  for (const bool near_first : {true, false}) {
    Canvas canvas(camera_on(far_box.vertices, {0, -1, 0}, 100, 100));
    canvas.draw(near_first ? near_box : far_box, all(near_first ? kGreen : kRed));
    canvas.draw(near_first ? far_box : near_box, all(near_first ? kRed : kGreen));
    const std::vector<Rgb> picture = canvas.picture();
    const Rgb middle = picture[50 * 100 + 50], corner = picture[12 * 100 + 12];
    EXPECT_EQ(middle[0], 0);
    EXPECT_GT(middle[1], 0);
    EXPECT_GT(corner[0], 0);
    EXPECT_EQ(corner[1], 0);
    EXPECT_EQ(picture[0], kWhite);
  }
}

TEST(MeshPicture, PaintIsAskedForThePlaceAndTheSideThatIsSeen) {
  TriangleMesh box = box_mesh({1.0, 1.0, 1.0});
  const Camera camera = camera_on(box.vertices, {0, -1, 0}, 50, 50);
  std::size_t asked = 0;
  const auto draw = [&](bool expected_behind) {
    Canvas canvas(camera);
    canvas.draw(box, [&](std::uint32_t, const Vec3& place, bool behind) {
      ++asked;
      EXPECT_NEAR(place.y(), 0.0, 1e-9);  // the front face
      EXPECT_EQ(behind, expected_behind);
      EXPECT_GT(place.minCoeff(), -0.02);
      EXPECT_LT(place.maxCoeff(), 1.02);
      return kRed;
    });
  };
  draw(false);
  for (TriangleMesh::Triangle& t : box.triangles) std::swap(t[0], t[1]);
  draw(true);
  EXPECT_GT(asked, 2u * 40 * 40);
}

TEST(MeshPicture, WhatLiesBehindIsNotSeen) {
  const TriangleMesh box = box_mesh({1.0, 1.0, 1.0});
  Canvas canvas(camera_on(box.vertices, {0, -1, 0}, 100, 100));
  canvas.draw(box, all(kRed));
  EXPECT_TRUE(canvas.is_visible({0.5, 0.0, 0.5}));
  EXPECT_FALSE(canvas.is_visible({0.5, 1.0, 0.5}));
  EXPECT_FALSE(canvas.is_visible({50.0, 0.0, 0.5})) << "outside the picture";
}

TEST(MeshPicture, LinesAndPointsAreHiddenToo) {
  const TriangleMesh box = box_mesh({1.0, 1.0, 1.0});
  const Camera camera = camera_on(box.vertices, {0, -1, 0}, 100, 100);
  const auto red_pixels = [&](double y) {
    Canvas canvas(camera);
    canvas.draw(box, all({100, 100, 100}));
    const std::array<Vec3, 2> line = {Vec3(0.1, y, 0.5), Vec3(0.9, y, 0.5)};
    const std::vector<std::array<Vec3, 2>> lines = {line};
    canvas.draw(lines, kRed);
    std::size_t red = 0;
    for (const Rgb& pixel : canvas.picture()) red += pixel[0] > pixel[1] + 20;
    return red;
  };
  EXPECT_GE(red_pixels(0.0), 66u);  // 0.8 of 84 pixels
  EXPECT_EQ(red_pixels(0.5), 0u);
  Canvas cloud(camera);
  cloud.draw(box.vertices, kRed);
  EXPECT_EQ(drawn_pixels(cloud) % 4, 0u);
  EXPECT_GE(drawn_pixels(cloud), 16u);  // four corners of two pixels a side
}

TEST(MeshPicture, ThingsWithoutExtentOrPlaceAreNoTrouble) {
  TriangleMesh odd = box_mesh({1.0, 1.0, 1.0});
  odd.triangles.push_back({0, 0, 1});
  odd.vertices.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  odd.vertices.emplace_back(1e300, 1e300, 1e300);
  const auto last = static_cast<std::uint32_t>(odd.vertices.size() - 1);
  odd.triangles.push_back({0, 1, last});
  odd.triangles.push_back({0, 1, last - 1});
  Canvas canvas(camera_on({Vec3::Zero(), Vec3::Ones()}, {0, -1, 0}, 40, 40));
  canvas.draw(odd, all(kRed));
  canvas.draw(odd.vertices, kRed);
  EXPECT_GT(drawn_pixels(canvas), 100u);
  Canvas nothing(camera_on({}, {0, -1, 0}, 10, 10));
  EXPECT_EQ(drawn_pixels(nothing), 0u);
  Canvas point(camera_on({Vec3::Ones()}, {0, -1, 0}, 10, 10));
  EXPECT_EQ(point.camera().pixel, 1.0);
}

TEST(ScanPage, TablesNameEveryDefectAndHoleWithItsPlace) {
  RepairReport report;
  report.defects = {{DefectKind::kSpike, 3, 0.0, 0.25, Vec3(1.0, 2.0, 3.0)},
                    {DefectKind::kIsland, 2, 0.01, 0.0, {}},
                    {DefectKind::kHole, 1, 0.04, 0.1, Vec3(4.0, 5.0, 6.0)}};
  FilledHole hole;
  hole.border_edges = 17;
  hole.perimeter = 0.625;
  hole.radius = 0.1;
  hole.area = 0.03;
  hole.area_fraction = 0.04;
  hole.centre = Vec3(4.0, 5.0, 6.0);
  report.holes = {hole};
  const std::string html = format_repair_section(report);
  for (const char* text : {"spikes, moved back", ">3<", "(1, 2, 3)", "loose scraps", "1.0 %",
                           "holes, filled", ">H1<", ">17<", ">0.625<", "4.0 %", "(4, 5, 6)"}) {
    EXPECT_NE(html.find(text), std::string::npos) << text << " is missing in " << html;
  }
  EXPECT_EQ(unbalanced(html), "");
  const std::vector<PositionMark> marks = find_repair_marks(report);
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(marks[0].label, "1");
  EXPECT_EQ(marks[1].label, "H1");
  RepairReport sound;
  EXPECT_EQ(count_of(format_repair_section(sound), "None except the open side"), 1u);
  sound.as_read.triangles = 4;
  EXPECT_EQ(count_of(format_repair_section(sound), "None: the surface was closed"), 1u);
  EXPECT_EQ(count_of(format_repair_section(sound, true, true), "None except the open side"), 1u);
}

TEST(ScanPage, EveryKindOfDefectHasAName) {
  for (int kind = 0; kind <= static_cast<int>(DefectKind::kTunnel); ++kind) {
    EXPECT_GT(std::string(name_of(static_cast<DefectKind>(kind))).size(), 5u) << kind;
  }
}

TEST(ScanPage, PicturesAreInsideThePageAndWellFormed) {
  const TriangleMesh open = above_level(rock_mesh(8, {0.5, 0.4, 0.3}, 3), -0.15);
  FieldBlock block = extract_field_blocks(open, "open")[0];
  ASSERT_TRUE(block.underside.has_value());
  const std::string html = draw_before_and_after(open, {}, block, {{"1", open.vertices[0]}}) +
                           format_underside_section(*block.underside) +
                           draw_deviation_map(block.scan.mesh, block.scan.mesh, 0.01);
  EXPECT_EQ(unbalanced(make_scan_page("a < b", html)), "");
  EXPECT_EQ(count_of(html, "<image "), 9u);  // as read, closed, deviation: three views each
  expect_self_contained(html);
  EXPECT_GT(count_of(html, ">1</text>"), 0u) << "the mark is drawn where it is seen";
}

}  // namespace
}  // namespace clast
