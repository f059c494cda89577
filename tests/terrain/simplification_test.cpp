// Fewer triangles for the same ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/random.hpp"
#include "terrain/terrain_file.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

double hills(double x, double y) { return 2.0 * std::sin(x / 4.0) * std::cos(y / 5.0) + 0.3 * x; }

class Simplification : public testing::Test {
 protected:
  Terrain read(const TriangleMesh& mesh, std::optional<double> tolerance = {}) {
    write_mesh(folder_ / "ground.ply", mesh);
    return read_terrain({.surface = {folder_ / "ground.ply"}, .tolerance = tolerance});
  }
  const ScratchFolder folder_;
};

// Two triangles would do; every vertex of the border stays.
TEST_F(Simplification, APlaneKeepsItsBorderOnly) {
  const auto plane = [](double x, double y) { return 3.0 + 0.7 * x - 0.2 * y; };
  const Terrain thin = read(squares(20, 1.0, plane), 1e-6);
  EXPECT_EQ(thin.surface.vertices.size(), 80u);
  EXPECT_EQ(thin.surface.triangles.size(), 78u);  // n - 2 triangles of a polygon with n corners
  EXPECT_EQ(facing_down(thin), 0u);
  double area = 0.0;
  for (std::size_t t = 0; t < thin.surface.triangles.size(); ++t) {
    area += normal_of(thin, t).z() / 2.0;
  }
  EXPECT_NEAR(area, 400.0, 1e-9);
}

TEST_F(Simplification, KeepsWithinTheToleranceAndTurnsNoFaceOver) {
  const TriangleMesh mesh = squares(40, 1.0, hills);
  const Terrain whole = read(mesh);
  const TerrainSurface before = make_terrain_surface(whole);
  std::size_t last = whole.surface.triangles.size();
  for (const double tolerance : {0.01, 0.05, 0.2}) {
    const Terrain thin = read(mesh, tolerance);
    EXPECT_LT(thin.surface.triangles.size(), last);
    last = thin.surface.triangles.size();
    EXPECT_EQ(facing_down(thin), 0u);
    const TerrainSurface after = make_terrain_surface(thin);
    double worst = 0.0;
    for (int j = 0; j <= 80; ++j) {
      for (int i = 0; i <= 80; ++i) {  // vertices, and midpoints of all edges
        const double x = 0.5 * i, y = 0.5 * j;
        worst =
            std::max(worst, std::abs(*after.height_at(x, y, 0.0) - *before.height_at(x, y, 0.0)));
      }
    }
    EXPECT_LE(worst, tolerance * (1.0 + 1e-9));
  }
  EXPECT_LT(last, 3200u / 4);
}

/// Largest difference in height anywhere, by another way: within the overlay of one old and one new
/// triangle, cut out of each other, the difference is linear, so its extremes are at the corners.
double largest_difference(const TriangleMesh& before, const TriangleMesh& after) {
  double largest = 0.0;
  for (const TriangleMesh::Triangle& t : after.triangles) {
    for (const TriangleMesh::Triangle& s : before.triangles) {
      std::vector<Vec2> ring;
      for (const std::uint32_t v : s) ring.push_back(before.vertices[v].head<2>());
      for (std::size_t k = 0; k < 3 && !ring.empty(); ++k) {
        const Vec2 a = after.vertices[t[k]].head<2>(), b = after.vertices[t[(k + 1) % 3]].head<2>();
        const auto side = [&](const Vec2& p) {
          return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
        };
        std::vector<Vec2> inside;
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Vec2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
          if (side(p) >= 0.0) inside.push_back(p);
          if (side(p) * side(q) < 0.0)
            inside.push_back(p + side(p) / (side(p) - side(q)) * (q - p));
        }
        ring = inside;
      }
      const auto height = [](const TriangleMesh& mesh, const TriangleMesh::Triangle& corners,
                             const Vec2& at) {
        const Vec3& a = mesh.vertices[corners[0]];
        const Vec3 normal = (mesh.vertices[corners[1]] - a).cross(mesh.vertices[corners[2]] - a);
        return a.z() - normal.head<2>().dot(at - a.head<2>()) / normal.z();
      };
      for (const Vec2& p : ring) {
        largest = std::max(largest, std::abs(height(before, s, p) - height(after, t, p)));
      }
    }
  }
  return largest;
}

TEST_F(Simplification, TheLargestDifferenceAnywhereIsWithinTheToleranceAndSaid) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    TriangleMesh mesh = squares(14, 1.0, hills);
    for (Vec3& v : mesh.vertices) {
      const bool border = v.x() == 0.0 || v.y() == 0.0 || v.x() == 14.0 || v.y() == 14.0;
      if (!border) v += 0.2 * random.unit_vector();
    }
    const Terrain whole = read(mesh);
    const double tolerance = 0.03 * static_cast<double>(seed);
    const Terrain thin = read(mesh, tolerance);
    EXPECT_LT(thin.surface.triangles.size(), whole.surface.triangles.size());
    const double largest = largest_difference(whole.surface, thin.surface);
    EXPECT_LE(largest, tolerance * (1.0 + 1e-9));
    const std::string note = thin.report.notes.back();
    const std::size_t said = note.find("nowhere more than ");
    ASSERT_NE(said, std::string::npos) << note;
    EXPECT_NEAR(std::stod(note.substr(said + 18)), largest, 1e-3 * largest) << note;
  }
}

TEST_F(Simplification, OverhangsStayTriangleForTriangle) {
  TriangleMesh mesh = squares(30, 1.0, hills);
  // The ground folds over along x = 15: vertices beyond are drawn back under their neighbours.
  for (Vec3& v : mesh.vertices) {
    if (v.x() > 15.5 && v.x() < 16.5) v += Vec3(-1.6, 0.0, -3.0);
    if (v.x() > 16.5) v.z() -= 6.0;
  }
  const Terrain whole = read(mesh), thin = read(mesh, 0.1);
  EXPECT_GT(facing_down(whole), 20u);
  EXPECT_EQ(facing_down(thin), facing_down(whole));
  EXPECT_LT(thin.surface.triangles.size(), whole.surface.triangles.size() / 2);
  EXPECT_EQ(thin.report.components, 1u);
  // Watertight: the border is the same, and nothing else is open.
  const auto border = [](const Terrain& terrain) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
    for (const TriangleMesh::Triangle& t : terrain.surface.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        ++count[std::minmax(t[k], t[(k + 1) % 3])];
      }
    }
    std::size_t open = 0;
    for (const auto& [edge, triangles] : count) open += triangles == 1;
    return open;
  };
  EXPECT_EQ(border(thin), border(whole));
}

TEST_F(Simplification, ZonesOfFilesKeepTheirAreas) {
  TriangleMesh left = squares(10, 1.0, hills);
  TriangleMesh right = squares(10, 1.0, [](double x, double y) { return hills(x + 10.0, y); });
  for (Vec3& v : right.vertices) v.x() += 10.0;
  write_mesh(folder_ / "left.ply", left);
  write_mesh(folder_ / "right.ply", right);
  const Terrain thin = read_terrain({.surface = {folder_ / "left.ply", folder_ / "right.ply"},
                                     .zones = {"rock", "grass"},
                                     .tolerance = 0.2});
  EXPECT_LT(thin.surface.triangles.size(), 300u);
  std::vector<double> area(2, 0.0);
  for (std::size_t t = 0; t < thin.zone.size(); ++t)
    area[thin.zone[t]] += normal_of(thin, t).z() / 2.0;
  EXPECT_NEAR(area[0], 100.0, 1e-9);
  EXPECT_NEAR(area[1], 100.0, 1e-9);
}

TEST_F(Simplification, RastersAndHolesToo) {
  write_asc(folder_ / "dem.asc", 40, 40, 652000.0, 5203000.0, 0.5, [](double x, double y) {
    const bool pond = std::hypot(x - 652010.0, y - 5203010.0) < 3.0;
    return pond ? -9999.0 : 0.25 * (x - 652000.0) + 1500.0;
  });
  const Terrain whole = read_terrain({.surface = {folder_ / "dem.asc"}});
  const Terrain thin = read_terrain({.surface = {folder_ / "dem.asc"}, .tolerance = 0.02});
  EXPECT_LT(thin.surface.triangles.size(), whole.surface.triangles.size() / 4);
  const auto area = [](const Terrain& terrain) {
    double sum = 0.0;
    for (std::size_t t = 0; t < terrain.surface.triangles.size(); ++t) {
      sum += normal_of(terrain, t).z() / 2.0;
    }
    return sum;
  };
  EXPECT_NEAR(area(thin), area(whole), 1e-6);
  EXPECT_EQ(facing_down(thin), 0u);
}

TEST_F(Simplification, TheSameBitsEveryTime) {
  const TriangleMesh mesh = squares(25, 1.0, hills);
  const Terrain one = read(mesh, 0.05), two = read(mesh, 0.05);
  EXPECT_EQ(one.surface.triangles, two.surface.triangles);
  ASSERT_EQ(one.surface.vertices.size(), two.surface.vertices.size());
  for (std::size_t v = 0; v < one.surface.vertices.size(); ++v) {
    EXPECT_EQ(one.surface.vertices[v], two.surface.vertices[v]);
  }
}

TEST_F(Simplification, OptionsThatMakeNoSenseAreRefused) {
  write_mesh(folder_ / "ground.ply", squares(4, 1.0, hills));
  EXPECT_EQ(refusal(TerrainOptions{.surface = {folder_ / "ground.ply"}, .tolerance = 0.0}),
            "tolerance = 0: must be from 1e-09 to 1000 m");
  write_terrain(folder_ / "ground.h5", read(squares(4, 1.0, hills)));
  EXPECT_TRUE(
      contains(refusal(TerrainOptions{.surface = {folder_ / "ground.h5"}, .tolerance = 0.1}),
               "ground.h5: a terrain file is already checked and repaired"));
}

}  // namespace
}  // namespace clast
