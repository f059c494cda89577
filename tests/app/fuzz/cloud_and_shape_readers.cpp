#include "core/number_text.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/ply_properties.hpp"
#include "mesh/point_cloud.hpp"
#include "shapes/shp_file.hpp"
#include "tests/app/fuzz/readers.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/cloud_bytes.hpp"

namespace clast {

namespace {

void read_points_of(const std::filesystem::path& path) {
  for (const Vec3& p : read_cloud(path)) ASSERT_TRUE(p.allFinite());
}

std::string text_cloud(const std::string& heading, const std::string& separator) {
  Random random(3);
  std::string text = heading;
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 3; ++k) {
      text += format_significant(random.uniform(-5.0, 5.0), 7) + (k < 2 ? separator : "\n");
    }
  }
  return text;
}

std::string las(int minor, std::uint8_t format, std::size_t record_size) {
  std::vector<LasPoint> points;
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    LasPoint point;
    for (std::int32_t& step : point.steps)
      step = static_cast<std::int32_t>(random.uniform_index(100000));
    points.push_back(point);
  }
  return las_file(minor, format, record_size, points, Vec3::Constant(0.001), Vec3(6e5, 5e6, 100));
}

std::string shp() {
  const ScratchFolder folder;
  ShpShape shape;
  shape.name = "rock";
  shape.body = make_sphero_polyhedron(random_rock(7, 1), 0.05);
  shape.volume = 1.0 / 3.0;
  shape.inertia_per_mass = {0.2, 0.3, 0.4};
  shape.box.lengths = {3, 2, 1};
  write_shp(folder / "rock.shp", std::vector{shape});
  return read_text_file(folder / "rock.shp");
}

}  // namespace

std::vector<NamedReader> cloud_and_shape_readers() {
  return {
      reader_of(
          "points.xyz", [] { return text_cloud("", " "); }, read_points_of),
      reader_of(
          "points.csv", [] { return text_cloud("x;y;z\n", ";"); }, read_points_of),
      reader_of(
          "points.txt", [] { return text_cloud("//X Y Z\n", "\t"); }, read_points_of),
      reader_of(
          "points.pts", [] { return text_cloud("60\n", " "); }, read_points_of),
      reader_of(
          "points.asc", [] { return text_cloud("", ","); }, read_points_of),
      reader_of(
          "format1.las", [] { return las(2, 1, 28); }, read_points_of),
      reader_of(
          "format6.las", [] { return las(4, 6, 30); }, read_points_of),
      reader_of(
          "text.pcd", [] { return kPcdHeader + "DATA ascii\n1 2 3.1 7\n4 5 6 7\nnan nan 0 7\n"; },
          read_points_of),
      reader_of(
          "binary.pcd", [] { return kPcdHeader + "DATA binary\n" + pcd_points(false); },
          read_points_of),
      reader_of(
          "packed.pcd", [] { return packed_pcd(); }, read_points_of),
      reader_of(
          "points.ply",
          [] {
            return "ply\nformat ascii 1.0\nelement vertex 60\nproperty double x\n"
                   "property double y\nproperty double z\nend_header\n" +
                   text_cloud("", " ");
          },
          read_points_of),
      reader_of(
          "labels.ply",
          [] {
            return "ply\nformat ascii 1.0\nelement vertex 60\nproperty double x\n"
                   "property double block\nproperty double z\nend_header\n" +
                   text_cloud("", " ");
          },
          [](const auto& path) {
            read_ply_vertex_properties(path, {"x", "block"});
          }),
      reader_of("rock.shp", shp,
                [](const auto& path) {
                  for (const ShpShape& shape : read_shp(path)) {
                    for (const Vec3& v : shape.body.vertices) ASSERT_TRUE(v.allFinite());
                  }
                }),
  };
}

}  // namespace clast
