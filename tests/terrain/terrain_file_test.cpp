// Terrain files and exports: what is written is what is read.
#include <gtest/gtest.h>

#include <cmath>

#include "core/files/hdf5_file.hpp"
#include "core/files/text_file.hpp"
#include "terrain/terrain_file.hpp"
#include "tests/support/flipped_bits.hpp"
#include "tests/support/without_checksums.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {
namespace {

double file_dome(double x, double y) { return 120.0 - 0.05 * (x * x + y * y); }

class TerrainFile : public testing::Test {
 protected:
  /// Two zones at large map coordinates.
  Terrain sample() {
    std::vector<std::filesystem::path> files;
    for (int k = 0; k < 2; ++k) {
      TriangleMesh mesh =
          squares(8, 0.5, [&](double x, double y) { return file_dome(x + 4 * k, y); });
      for (Vec3& v : mesh.vertices) v += Vec3(652000.0 + 4.0 * k, 5203000.0, 0.0);
      files.push_back(folder_ / ("zone" + std::to_string(k) + ".ply"));
      write_mesh(files.back(), mesh);
    }
    Terrain terrain = read_terrain({.surface = files, .zones = {"rock", "éboulis"}});
    terrain.frame.crs = "EPSG:2154";
    terrain.report.notes = {"a note"};
    return terrain;
  }
  std::string damaged(const std::function<void(Hdf5Group&)>& damage) {
    write_terrain(folder_ / "t.h5", sample());
    {
      Hdf5File file = Hdf5File::open(folder_ / "t.h5", "clast terrain", 1, true);
      Hdf5Group root = file.root();
      damage(root);
      file.flush();
    }
    return refusal<Error>([&] { read_terrain_file(folder_ / "t.h5"); });
  }
  const ScratchFolder folder_;
};

void expect_same(const Terrain& a, const Terrain& b) {
  EXPECT_EQ(a.surface.vertices, b.surface.vertices);
  EXPECT_EQ(a.surface.triangles, b.surface.triangles);
  EXPECT_EQ(a.zone, b.zone);
  EXPECT_EQ(a.zone_names, b.zone_names);
  EXPECT_EQ(a.frame.origin, b.frame.origin);
  EXPECT_EQ(a.frame.crs, b.frame.crs);
  EXPECT_EQ(a.report.notes, b.report.notes);
  EXPECT_EQ(a.report.triangles_read, b.report.triangles_read);
  EXPECT_EQ(a.report.welded_vertices, b.report.welded_vertices);
  EXPECT_EQ(a.report.boundary_edges, b.report.boundary_edges);
  EXPECT_EQ(a.report.components, b.report.components);
}

TEST_F(TerrainFile, ComesBackToTheBit) {
  const Terrain terrain = sample();
  write_terrain(folder_ / "t.h5", terrain);
  const Terrain back = read_terrain_file(folder_ / "t.h5");
  expect_same(back, terrain);
  EXPECT_EQ(back.sources, terrain.sources);
}

TEST_F(TerrainFile, IsAGroundWithItsOwnZones) {
  const Terrain terrain = sample();
  write_terrain(folder_ / "t.h5", terrain);
  const Terrain back = read_terrain({.surface = {folder_ / "t.h5"}});
  expect_same(back, terrain);
  ASSERT_EQ(back.sources.size(), 3u);
  EXPECT_TRUE(contains(back.sources[0], "t.h5 "));
  EXPECT_TRUE(contains(refusal(TerrainOptions{.surface = {folder_ / "t.h5"}, .zones = {"x"}}),
                       "already has zones"));
}

TEST_F(TerrainFile, DamageIsRefused) {
  const auto replace = [](Hdf5Group& root, const std::string& name, const auto& values,
                          const std::vector<std::size_t>& shape = {}) {
    using T = typename std::decay_t<decltype(values)>::value_type;
    root.remove(name);
    root.write<T>(name, values, shape);
  };
  EXPECT_EQ(damaged([](Hdf5Group&) {}), "");
  EXPECT_TRUE(contains(damaged([](Hdf5Group& root) { root.remove("zone"); }), "zone"));
  EXPECT_TRUE(contains(damaged([&](Hdf5Group& root) {
                         replace(root, "triangles", std::vector<std::uint32_t>{0, 1, 9999}, {1, 3});
                       }),
                       "refers to vertex 9999"));
  EXPECT_TRUE(contains(damaged([&](Hdf5Group& root) {
                         replace(root, "zone", std::vector<std::uint16_t>{0, 1});
                       }),
                       "2 zone numbers for 256 triangles"));
  EXPECT_TRUE(contains(
      damaged([&](Hdf5Group& root) { replace(root, "zone", std::vector<std::uint16_t>(256, 7)); }),
      "zone number 7 has no name"));
  EXPECT_TRUE(contains(damaged([&](Hdf5Group& root) {
                         replace(root, "vertices", std::vector<double>(6, NAN), {2, 3});
                       }),
                       "vertex 0 is not finite"));
  EXPECT_TRUE(contains(damaged([&](Hdf5Group& root) {
                         replace(root, "vertices", std::vector<double>(6, 0.0), {3, 2});
                       }),
                       "must have 3 columns"));
  EXPECT_TRUE(
      contains(damaged([&](Hdf5Group& root) { replace(root, "origin", std::vector<double>{1.0}); }),
               "\"origin\" must be three numbers"));
  EXPECT_TRUE(contains(damaged([&](Hdf5Group& root) {
                         replace(root, "triangles", std::vector<std::uint32_t>{}, {0, 3});
                       }),
                       "holds no triangles"));
  write_text_file(folder_ / "u.h5", "not HDF5");
  EXPECT_TRUE(contains(refusal<Error>([&] { read_terrain_file(folder_ / "u.h5"); }), "u.h5"));
}

TEST_F(TerrainFile, NoFlippedBitIsReadAsAnotherNumber) {
  write_terrain(folder_ / "t.h5", sample());
  expect_no_flip_unnoticed(folder_ / "t.h5", 500, [&](const std::filesystem::path& file) {
    write_terrain(folder_ / "again.h5", read_terrain_file(file));
    return read_text_file(folder_ / "again.h5");
  });
}

TEST_F(TerrainFile, OfVersionsWithoutChecksumsIsRead) {
  write_terrain(folder_ / "t.h5", sample());
  const std::string whole = read_text_file(folder_ / "t.h5");
  remove_checksums(folder_ / "t.h5");
  EXPECT_NE(read_text_file(folder_ / "t.h5"), whole);
  write_terrain(folder_ / "again.h5", read_terrain_file(folder_ / "t.h5"));
  EXPECT_EQ(read_text_file(folder_ / "again.h5"), whole);
}

TEST_F(TerrainFile, IsNotWrittenOverResultsOrALibrary) {
  for (const char* format : {"clast results", "clast block library"}) {
    Hdf5File::create(folder_ / "other.h5", format, 1);
    const std::string before = read_text_file(folder_ / "other.h5");
    EXPECT_TRUE(contains(refusal<Error>([&] { write_terrain(folder_ / "other.h5", sample()); }),
                         std::string("other.h5: already exists and holds \"") + format + "\""));
    EXPECT_EQ(read_text_file(folder_ / "other.h5"), before);
  }
}

TEST_F(TerrainFile, MeshExportsAreOnTheMap) {
  const Terrain terrain = sample();
  for (const std::string name : {"t.ply", "t.obj"}) {
    export_terrain(folder_ / name, terrain, "z");
    const TriangleMesh mesh = read_mesh(folder_ / name);
    ASSERT_EQ(mesh.triangles, terrain.surface.triangles) << name;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      EXPECT_EQ(mesh.vertices[i], terrain.frame.to_map(terrain.surface.vertices[i])) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / (name + ".origin.txt")));
  }
  // Back to y up, and read as such, nothing has changed.
  export_terrain(folder_ / "y.ply", terrain, "y");
  const Terrain back = read_terrain({.surface = {folder_ / "y.ply"}, .up = "y"});
  EXPECT_EQ(back.surface.vertices, terrain.surface.vertices);
}

// glTF 2.0 has y up: viewers show the ground level, and it comes back as it was.
TEST_F(TerrainFile, GlbExportsAreYUpAndReadSo) {
  Terrain terrain = sample();
  terrain.frame.origin = Vec3::Zero();
  export_terrain(folder_ / "t.glb", terrain, "auto");
  const TriangleMesh mesh = read_mesh(folder_ / "t.glb");
  const Terrain back = read_terrain({.surface = {folder_ / "t.glb"}});
  ASSERT_EQ(mesh.vertices.size(), terrain.surface.vertices.size());
  ASSERT_EQ(back.surface.vertices.size(), terrain.surface.vertices.size());
  const Vec3 map_origin = back.frame.origin;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& z_up = terrain.surface.vertices[i];
    EXPECT_LT((mesh.vertices[i] - Vec3(z_up.x(), z_up.z(), -z_up.y())).norm(), 1e-5);
    EXPECT_LT((back.surface.vertices[i] + map_origin - z_up).norm(), 1e-5);
  }
}

TEST_F(TerrainFile, FloatExportsAreNearTheOriginAndSayWhere) {
  const Terrain terrain = sample();
  export_terrain(folder_ / "t.stl", terrain, "z");
  const Bounds box = bounds(read_mesh(folder_ / "t.stl"));
  EXPECT_LT(box.high.head<2>().maxCoeff(), 10.0);
  EXPECT_TRUE(contains(read_text_file(folder_ / "t.stl.origin.txt"),
                       "origin x 652004.000, y 5203002.000, z 0.000"));
}

// Against the formula of the ground, of which triangles of half a metre miss at most
// 0.05 * 0.5^2 / 4 per axis; heights at 120 m as float are good to 1e-5 m.
TEST_F(TerrainFile, RasterExportHasTheHeightsAtCellCentres) {
  const Terrain terrain = sample();
  export_terrain(folder_ / "t.tif", terrain, "z", 0.25);
  const Terrain back = read_terrain({.surface = {folder_ / "t.tif"}});
  EXPECT_EQ(back.frame.crs, "EPSG:2154");
  EXPECT_EQ(back.surface.vertices.size(), 32u * 16u);
  double worst = 0.0;
  for (const Vec3& local : back.surface.vertices) {
    const Vec3 v = back.frame.to_map(local);
    worst = std::max(worst, std::abs(v.z() - file_dome(v.x() - 652000.0, v.y() - 5203000.0)));
  }
  EXPECT_LT(worst, 2.0 * 0.05 * 0.25 / 4.0 + 1e-4);
}

TEST_F(TerrainFile, ExportsThatMakeNoSenseAreRefused) {
  const Terrain terrain = sample();
  const auto refused = [&](const std::string& name, const std::string& up, double cell) {
    return refusal<Error>([&] { export_terrain(folder_ / name, terrain, up, cell); });
  };
  EXPECT_TRUE(contains(refused("t.doc", "z", 0.5), "t.doc"));
  EXPECT_TRUE(contains(refused("t.stl", "x", 0.5), "up = \"x\""));
  EXPECT_TRUE(contains(refused("t.tif", "y", 0.5), "z up"));
  EXPECT_TRUE(contains(refused("t.tif", "z", 0.0), "cell = 0"));
  EXPECT_TRUE(contains(refused("t.tif", "z", 1e-7), "too many"));
  for (const char* name : {"t.doc", "t.stl", "t.tif"}) {
    EXPECT_FALSE(std::filesystem::exists(folder_ / name)) << name;
  }
}

// The highest surface counts where the ground lies over itself.
TEST_F(TerrainFile, RasterExportTakesTheHighestSurface) {
  TriangleMesh low = squares(4, 1.0, [](double, double) { return 1.0; });
  TriangleMesh high = squares(2, 1.0, [](double, double) { return 3.0; });
  Terrain two;
  two.surface = merged(high, low);
  two.zone_names = {"ground"};
  two.zone.assign(two.surface.triangles.size(), 0);
  export_terrain(folder_ / "t.tif", two, "z", 1.0);
  const Terrain back = read_terrain({.surface = {folder_ / "t.tif"}});
  ASSERT_EQ(back.surface.vertices.size(), 16u);
  for (const Vec3& v : back.surface.vertices) {
    EXPECT_EQ(v.z(), v.x() < 2.0 && v.y() < 2.0 ? 3.0 : 1.0);
  }
}

}  // namespace
}  // namespace clast
