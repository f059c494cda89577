#include "shapes/shp_file.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

ShpShape sample(const std::string& name) {
  ShpShape shape;
  shape.name = name;
  shape.body = sphero_polyhedron(random_rock(7, 1), 0.1 / 3.0);
  shape.volume = 1.0 / 3.0;
  shape.inertia_per_mass = {1.0 / 7.0, 2.0 / 7.0, 3.0 / 7.0};
  shape.box.lengths = {3, 2, 1};
  shape.box.centre = {0.1, 0.2, 0.3};
  Random random(1);
  shape.box.axes = random.rotation().toRotationMatrix();
  shape.source_from_body = {{888600.123456789, 2, 3}, random.rotation()};
  return shape;
}

TEST(ShpFile, HoldsEveryNumberToTheLastBit) {
  const ScratchFolder folder;
  const std::vector<ShpShape> shapes = {sample("SP1A"), sample("SP2A")};
  write_shp(folder / "shapes.shp", shapes);
  std::istringstream in(read_text_file(folder / "shapes.shp"));
  const auto vector = [&] {
    Vec3 v;
    in >> v.x() >> v.y() >> v.z();
    return v;
  };
  for (const ShpShape& expected : shapes) {
    std::string word;
    in >> word;
    ASSERT_EQ(word, "<");
    std::map<std::string, int> seen;
    while (in >> word && word != ">") {
      ++seen[word];
      if (word == "name") {
        in >> word;
        EXPECT_EQ(word, expected.name);
      } else if (word == "radius") {
        double radius = 0;
        in >> radius;
        EXPECT_EQ(radius, expected.body.radius);
      } else if (word == "preCompDone") {
        in >> word;
        EXPECT_EQ(word, "y");
      } else if (word == "nv") {
        std::size_t count = 0;
        in >> count;
        ASSERT_EQ(count, expected.body.vertices.size());
        for (const Vec3& v : expected.body.vertices) EXPECT_EQ(vector(), v);
      } else if (word == "ne") {
        std::size_t count = 0;
        in >> count;
        ASSERT_EQ(count, expected.body.edges.size());
        for (const SpheroPolyhedron::Edge& e : expected.body.edges) {
          SpheroPolyhedron::Edge found{};
          in >> found[0] >> found[1];
          EXPECT_EQ(found, e);
        }
      } else if (word == "nf") {
        std::size_t count = 0;
        in >> count;
        ASSERT_EQ(count, expected.body.faces.size());
        for (const SpheroPolyhedron::Face& f : expected.body.faces) {
          in >> count;
          SpheroPolyhedron::Face found(count);
          for (std::uint32_t& v : found) in >> v;
          EXPECT_EQ(found, f);
        }
      } else if (word == "obb.extent") {
        EXPECT_EQ(vector(), Vec3(1.5, 1.0, 0.5));
      } else if (word == "obb.center") {
        EXPECT_EQ(vector(), expected.box.centre);
      } else if (word == "obb.e1" || word == "obb.e2" || word == "obb.e3") {
        EXPECT_EQ(vector(), Vec3(expected.box.axes.col(word[5] - '1')));
      } else if (word == "volume") {
        double volume = 0;
        in >> volume;
        EXPECT_EQ(volume, expected.volume);
      } else if (word == "I/m") {
        EXPECT_EQ(vector(), expected.inertia_per_mass);
      } else if (word == "position") {
        EXPECT_EQ(vector(), expected.source_from_body.translation);
      } else if (word == "orientation") {
        Quat q;
        in >> q.w() >> q.x() >> q.y() >> q.z();
        EXPECT_EQ(q.coeffs(), expected.source_from_body.rotation.coeffs());
      } else {
        FAIL() << "unknown keyword " << word;
      }
    }
    EXPECT_EQ(seen.size(), 15u);
    for (const auto& [keyword, count] : seen) EXPECT_EQ(count, 1) << keyword;
  }
}

TEST(ShpFile, UnusableNamesAreRefusedAndLeaveNothing) {
  const ScratchFolder folder;
  for (const std::string name : {"", "my block", "a<b", "tab\tname"}) {
    const std::vector<ShpShape> shapes = {sample(name)};
    EXPECT_THROW(write_shp(folder / "a.shp", shapes), InputError);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace clast
