#include <cmath>

#include "mesh/mesh_io.hpp"
#include "terrain/terrain_file.hpp"
#include "terrain/terrain_input.hpp"
#include "tests/app/fuzz/readers.hpp"
#include "tests/support/cloud_bytes.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {

namespace {

double hill(double x, double y) { return 100.0 - 0.4 * x + std::sin(y); }

std::string asc(const std::function<double(double, double)>& value) {
  const ScratchFolder folder;
  write_asc(folder / "a.asc", 12, 12, 0.0, 0.0, 1.0, value);
  return read_text_file(folder / "a.asc");
}

std::string mesh(const std::string& name) {
  const ScratchFolder folder;
  write_mesh(folder / name, squares(10, 1.0, hill));
  return read_text_file(folder / name);
}

std::string geotiff() {
  const ScratchFolder folder;
  write_mesh(folder / "ground.ply", squares(10, 1.0, hill));
  export_terrain(folder / "ground.tif", read_terrain({.surface = {folder / "ground.ply"}}), "z",
                 1.0);
  return read_text_file(folder / "ground.tif");
}

std::string cloud() {
  std::string text;
  for (int i = 0; i < 600; ++i) {
    const double x = 12.0 * std::fmod(0.618 * i, 1.0), y = 0.02 * i;
    text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(hill(x, y)) + "\n";
  }
  return text;
}

std::string las_cloud() {
  std::vector<LasPoint> points;
  for (int i = 0; i < 300; ++i) {
    const double x = 12.0 * std::fmod(0.618 * i, 1.0), y = 0.04 * i;
    LasPoint point;
    point.steps = {static_cast<std::int32_t>(1000 * x), static_cast<std::int32_t>(1000 * y),
                   static_cast<std::int32_t>(1000 * hill(x, y))};
    points.push_back(point);
  }
  return las_file(2, 1, 28, points, Vec3::Constant(0.001), Vec3::Zero());
}

std::string feature(const std::string& type, const std::string& coordinates) {
  return R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"zone":"rock"},)"
         R"("geometry":{"type":")" +
         type + R"(","coordinates":)" + coordinates + "}}]}";
}

void expect_sound(const Terrain& terrain) {
  ASSERT_EQ(terrain.zone.size(), terrain.surface.triangles.size());
  for (const Vec3& v : terrain.surface.vertices) ASSERT_TRUE(v.allFinite());
}

NamedReader surface_reader(const std::string& file, const std::function<std::string()>& bytes) {
  return reader_of(
      file, bytes, [](const auto& path) { expect_sound(read_terrain({.surface = {path}})); },
      "the ground");
}

/// A second file beside a ground that is sound.
NamedReader beside_ground(const std::string& file, const std::string& bytes,
                          const std::function<TerrainOptions(const std::filesystem::path&)>& use) {
  return {file, [=]() -> FuzzedReader {
            return {
                file, file, {{file, bytes}, {"ground.asc", asc(hill)}}, [=](const auto& folder) {
                  TerrainOptions options = use(folder / file);
                  options.surface = {folder / "ground.asc"};
                  expect_sound(read_terrain(options));
                }};
          }};
}

}  // namespace

std::vector<NamedReader> terrain_readers() {
  return {
      surface_reader("ground.asc", [] { return asc(hill); }),
      surface_reader("ground.tif", geotiff),
      surface_reader("ground.ply", [] { return mesh("ground.ply"); }),
      surface_reader("ground.stl", [] { return mesh("ground.stl"); }),
      surface_reader("ground.xyz", cloud),
      surface_reader("ground.las", las_cloud),
      beside_ground("zones.asc", asc([](double x, double) { return x < 6.0 ? 1.0 : 2.0; }),
                    [](const auto& path) { return TerrainOptions{.zones = {path.string()}}; }),
      beside_ground("zones.geojson",
                    feature("Polygon", "[[[-1,-1],[13,-1],[13,13],[-1,13],[-1,-1]]]"),
                    [](const auto& path) { return TerrainOptions{.zones = {path.string()}}; }),
      beside_ground("lines.geojson",
                    feature("LineString", "[[5.2,-1,99],[5.4,6.1,98],[5.1,13,97]]"),
                    [](const auto& path) { return TerrainOptions{.breaklines = {path}}; }),
      {"barriers.geojson",
       []() -> FuzzedReader {
         return {"barriers.geojson",
                 "barriers.geojson",
                 {{"barriers.geojson", feature("LineString", "[[5.2,-1],[5.4,6.1],[5.1,13]]")},
                  {"ground.asc", asc(hill)}},
                 [](const auto& folder) {
                   static const Terrain kGround =
                       read_terrain({.surface = {folder / "ground.asc"}});
                   read_barrier_lines(folder / "barriers.geojson", kGround);
                 }};
       }},
  };
}

}  // namespace clast
