// Lines with heights in the surface of a grid.
#include <gtest/gtest.h>

#include <cmath>

#include "core/files/text_file.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

std::string line_feature(const std::vector<Vec3>& points, bool heights = true) {
  std::string corners;
  for (const Vec3& p : points) {
    corners += (corners.empty() ? "[" : ",[") + std::to_string(p.x()) + "," + std::to_string(p.y());
    corners += heights ? "," + std::to_string(p.z()) + "]" : "]";
  }
  return R"({"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[)" +
         corners + "]}}";
}

class Breaklines : public testing::Test {
 protected:
  std::filesystem::path lines(const std::string& features) {
    write_text_file(folder_ / "lines.geojson",
                    R"({"type":"FeatureCollection","features":[)" + features + "]}");
    return folder_ / "lines.geojson";
  }
  std::filesystem::path dem() {
    // A bench that ends at x = 10.6 in a drop of 4 m over 0.8 m: a grid of 1 m blurs it.
    write_asc(folder_ / "dem.asc", 20, 20, 0.0, 0.0, 1.0,
              [](double x, double) { return x < 10.6 ? 6.0 : 2.0; });
    return folder_ / "dem.asc";
  }
  std::string refused(const std::string& features) {
    return refusal(TerrainOptions{.surface = {dem()}, .breaklines = {lines(features)}});
  }
  const ScratchFolder folder_;
};

TEST_F(Breaklines, AreEdgesAtTheirOwnHeights) {
  const std::vector<Vec3> top = {{10.6, -1.0, 6.0}, {10.6, 21.0, 6.0}};
  const std::vector<Vec3> foot = {{11.4, -1.0, 2.0}, {11.4, 21.0, 2.0}};
  const Terrain terrain = read_terrain(
      {.surface = {dem()}, .breaklines = {lines(line_feature(top) + "," + line_feature(foot))}});
  EXPECT_EQ(facing_down(terrain), 0u);
  EXPECT_EQ(terrain.report.components, 1u);
  const TerrainSurface surface = make_terrain_surface(terrain);
  for (double y = 0.6; y < 19.4; y += 0.23) {
    for (const double x : {5.0, 9.7, 10.59, 10.6})
      EXPECT_NEAR(*surface.height_at(x, y, 0.0), 6.0, 1e-4);
    for (const double x : {11.4, 11.41, 12.2, 16.0}) {
      EXPECT_NEAR(*surface.height_at(x, y, 0.0), 2.0, 1e-4);
    }
    EXPECT_NEAR(*surface.height_at(11.0, y, 0.0), 4.0, 1e-4);
  }
  bool noted = false;
  for (const std::string& note : terrain.report.notes) {
    noted = noted || contains(note, "2 breaklines run along edges");
  }
  EXPECT_TRUE(noted);
}

TEST_F(Breaklines, OnAPlaneChangeNothing) {
  const auto plane = [](double x, double y) { return 16.0 - 0.5 * x + 0.25 * y; };
  write_asc(folder_ / "plane.asc", 20, 20, 0.0, 0.0, 1.0, plane);
  std::vector<Vec3> zigzag;
  for (int k = 0; k <= 6; ++k) {
    const double x = 2.3 + 2.4 * k, y = k % 2 == 0 ? 3.1 : 15.7;
    zigzag.emplace_back(x, y, plane(x, y));
  }
  const Terrain terrain = read_terrain(
      {.surface = {folder_ / "plane.asc"}, .breaklines = {lines(line_feature(zigzag))}});
  EXPECT_EQ(facing_down(terrain), 0u);
  for (const Vec3& v : terrain.surface.vertices) EXPECT_NEAR(v.z(), plane(v.x(), v.y()), 2e-6);
  double area = 0.0;
  for (std::size_t t = 0; t < terrain.surface.triangles.size(); ++t) {
    area += normal_of(terrain, t).z() / 2.0;
  }
  EXPECT_NEAR(area, 361.0, 1e-9);
}

TEST_F(Breaklines, ThatDoNotFitAreRefused) {
  const std::vector<Vec3> one = {{3.0, 3.0, 6.0}, {9.0, 9.0, 6.0}};
  const std::vector<Vec3> across = {{3.0, 9.0, 8.0}, {9.0, 3.0, 8.0}};
  EXPECT_TRUE(contains(refused(line_feature(one, false)), "a breakline needs heights"));
  EXPECT_TRUE(contains(refused(line_feature(one) + "," + line_feature(across)),
                       "breaklines meet at x 6.000, y 6.000"));
  EXPECT_TRUE(contains(refused(line_feature({{300, 3, 6}, {309, 9, 6}})),
                       "no breakline lies over the ground"));
  EXPECT_TRUE(contains(refused(R"({"type":"Feature","properties":{},"geometry":{"type":"Point",)"
                               R"("coordinates":[1,1,1]}})"),
                       "is a POINT; a line is needed"));
  write_mesh(folder_ / "tin.ply", squares(3, 1.0, [](double, double) { return 0.0; }));
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "tin.ply"},
                                              .breaklines = {lines(line_feature(one))}}),
                       "breaklines apply only to rasters and clouds"));
}

}  // namespace
}  // namespace clast
