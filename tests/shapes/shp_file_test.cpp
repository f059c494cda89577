#include "shapes/shp_file.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "shapes/detail/shp_reader.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

ShpShape sample(const std::string& name) {
  ShpShape shape;
  shape.name = name;
  shape.body = make_sphero_polyhedron(random_rock(7, 1), 0.1 / 3.0);
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

TEST(ShpFile, WhatWasWrittenIsReadBackToTheLastBit) {
  const ScratchFolder folder;
  const std::vector<ShpShape> shapes = {sample("SP1A"), sample("SP2A")};
  write_shp(folder / "shapes.shp", shapes);
  const std::vector<ShpShape> back = read_shp(folder / "shapes.shp");
  ASSERT_EQ(back.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const ShpShape &is = back[i], &was = shapes[i];
    EXPECT_EQ(is.name, was.name);
    EXPECT_EQ(is.body.radius, was.body.radius);
    EXPECT_EQ(is.body.vertices, was.body.vertices);
    EXPECT_EQ(is.body.edges, was.body.edges);
    EXPECT_EQ(is.body.faces, was.body.faces);
    EXPECT_EQ(is.volume, was.volume);
    EXPECT_EQ(is.inertia_per_mass, was.inertia_per_mass);
    EXPECT_EQ(is.box.lengths, was.box.lengths);
    EXPECT_EQ(is.box.centre, was.box.centre);
    EXPECT_EQ(is.box.axes, was.box.axes);
    EXPECT_EQ(is.source_from_body.translation, was.source_from_body.translation);
    EXPECT_EQ(is.source_from_body.rotation.coeffs(), was.source_from_body.rotation.coeffs());
    EXPECT_FALSE(is.is_surface);
    EXPECT_TRUE(is.notes.empty());
  }
}

/// Reads `text` as a .shp file.
std::vector<ShpShape> shapes_in(const std::string& text) {
  const ScratchFolder folder;
  write_text_file(folder / "a.shp", text);
  return read_shp(folder / "a.shp");
}

const std::string kTetrahedron =
    "nv 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\nne 6\n0 1\n0 2\n0 3\n1 2\n1 3\n2 3\n"
    "nf 4\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n";

/// A shape of which only `rest` varies.
std::string tetrahedron_with(const std::string& rest) {
  return "<\nname T\nradius 0.1\n" + kTetrahedron + rest + "\n>\n";
}

TEST(ShpFile, KeywordsComeInAnyOrderWithAnyLineEndsBlanksAndComments) {
  const std::string text =
      "\xef\xbb\xbf# made by hand\r\n<\r\n"
      "nf 4\t3 0 1 2  3 0 1 3  3 0 2 3  3 1 2 3\r\n"
      "! a remark\r\n// another\r\n"
      "OBBtreeLevel 0\r\nMCnstep 100000000\r\nfibObbOption 2\r\n"
      "ne 8 1 0 0 1 0 2 0 3 1 2 1 3 2 3 2 2\r\n"
      "nv 4 0 0 0\t1 0 0 0\r\n1 0 0 0 1 # the last\r\n"
      "volume 1.5\r\nI/m 3 2 1\r\nobb.extent 1 3 2\r\nobb.e1 1 0 0\r\nobb.e2 0 1 0\r\n"
      "obb.e3 0 0 1\r\nobb.center 4 5 6\r\nposition 7 8 9\r\norientation 0 0 1 0\r\n"
      "preCompDone y radius .25 name T\r\n>";
  const std::vector<ShpShape> shapes = shapes_in(text);
  ASSERT_EQ(shapes.size(), 1u);
  const ShpShape& shape = shapes[0];
  EXPECT_EQ(shape.name, "T");
  EXPECT_EQ(shape.body.radius, 0.25);
  EXPECT_EQ(shape.body.vertices[3], Vec3(0, 0, 1));
  EXPECT_EQ(shape.body.edges.size(), 6u);  // each once, whichever way round and how often
  EXPECT_EQ(shape.body.faces.size(), 4u);
  EXPECT_EQ(shape.volume, 1.5);
  EXPECT_EQ(shape.inertia_per_mass, Vec3(3, 2, 1));
  EXPECT_EQ(shape.sampled_points, 1e7);         // Rockable's own limit
  EXPECT_EQ(shape.box.lengths, Vec3(6, 4, 2));  // whole sides, longest first
  EXPECT_EQ(Vec3(shape.box.axes.col(0)), Vec3(Vec3::UnitY()));
  EXPECT_NEAR(shape.box.axes.determinant(), 1.0, 1e-15);
  EXPECT_EQ(shape.box.centre, Vec3(4, 5, 6));
  // A point of the shape, turned half round about y and moved, is where the rock was scanned.
  const Vec3 scanned = shape.source_from_body * Vec3(1, 2, 3);
  EXPECT_LT((scanned - Vec3(7 - 1, 8 + 2, 9 - 3)).norm(), 1e-15);
}

TEST(ShpFile, NumbersStillToBeComputedAreNotTaken) {
  for (const std::string answer : {"", "preCompDone n\n"}) {
    const ShpShape shape = shapes_in(
        tetrahedron_with(answer + "volume 1\nI/m 1 1 1\nobb.extent 1 1 1\nposition 1 2 3"))[0];
    EXPECT_EQ(shape.volume, 0.0);
    EXPECT_EQ(shape.inertia_per_mass, Vec3(Vec3::Zero()));
    EXPECT_EQ(shape.box.lengths, Vec3(Vec3::Zero()));
    EXPECT_EQ(shape.source_from_body.translation, Vec3(Vec3::Zero()));
  }
}

TEST(ShpFile, PolygonsMissingEdgesAndUnusedVerticesAreTaken) {
  const ShpShape cube = shapes_in(
      "< name cube radius 0 isSurface\nnv 10\n9 9 9\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n"
      "1 1 1\n0 1 1\n8 8 8\n"
      "ne 1\n1 3\n"  // a diagonal of a face
      "nf 6\n4 1 2 3 4\n4 5 6 7 8\n4 1 2 6 5\n4 2 3 7 6\n4 3 4 8 7\n4 4 1 5 8\n>")[0];
  EXPECT_EQ(cube.body.vertices.size(), 8u);
  EXPECT_EQ(cube.body.vertices[0], Vec3(0, 0, 0));
  EXPECT_EQ(cube.body.edges.size(), 12u);
  EXPECT_EQ(cube.body.faces[0], (SpheroPolyhedron::Face{0, 1, 2, 3}));
  EXPECT_TRUE(cube.is_surface);
  ASSERT_EQ(cube.notes.size(), 1u);
  EXPECT_TRUE(contains(cube.notes[0], "2 vertices"));
}

TEST(ShpFile, BallsAndCapsulesHaveNoFaces) {
  const std::vector<ShpShape> shapes = shapes_in(
      "<\nname ball\nradius 0.5\nnv 1\n0 0 0\nne 0\nnf 0\n>\n\n"
      "<\nname capsule\nradius 0.1\nnv 2\n0 0 0\n0 0 1\nne 1\n1 0\n>\n");
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes[0].body.vertices.size(), 1u);
  EXPECT_TRUE(shapes[0].body.edges.empty() && shapes[0].body.faces.empty());
  EXPECT_EQ(shapes[1].body.edges, (std::vector<SpheroPolyhedron::Edge>{{0, 1}}));
}

struct Damage {
  std::string text, line, reason;
};
void PrintTo(const Damage& damage, std::ostream* out) {
  *out << damage.line << (damage.line.empty() ? "" : ": ") << damage.reason;
}

class DamagedShp : public testing::TestWithParam<Damage> {};

TEST_P(DamagedShp, IsRefusedWithFileLineAndReason) {
  const std::string message = refusal([&] { shapes_in(GetParam().text); });
  EXPECT_TRUE(contains(message, "a.shp: "));
  EXPECT_TRUE(contains(message, GetParam().line));
  EXPECT_TRUE(contains(message, GetParam().reason));
}

INSTANTIATE_TEST_SUITE_P(
    Files, DamagedShp,
    testing::Values(
        Damage{"", "", "holds no shape"}, Damage{"\n# nothing\n", "", "holds no shape"},
        Damage{std::string("\0\0\x27\x0a\0\0", 6), "", "ESRI shapefile"},
        Damage{"solid rock\n", "line 1", "starts with <"},
        Damage{"<\nname T\nradius 0.1\nnv 1\n0 0", "line 5", "cut short"},
        Damage{"<\nname T\nradius 0.1\nnv 1\n0 0 0\n", "shape T", "not closed by >"},
        Damage{"<\nname T\nradius 0.1\nnv 1\n0 0 0\n<\n", "line 6", "not closed by >"},
        Damage{"<\nradius 0.1\nnv 1\n0 0 0\n>", "line 5", "no name"},
        Damage{"<\nname\nradius 0.1\n>", "line 2", "a name is needed"},
        Damage{"<\nname T\nnv 1\n0 0 0\n>", "shape T", "no radius"},
        Damage{"<\nname T\nradius 0.1\n>", "shape T", "no nv"},
        Damage{"<\nname T\nradius 0.1\nnv 0\n>", "shape T", "no vertices"},
        Damage{"<\nname T\nradius -1\n>", "line 3", "0 or more"},
        Damage{"<\nname T\nradius big\n>", "line 3", "found \"big\""},
        Damage{"<\nname T\nradius nan\n>", "line 3", "not a finite number"},
        Damage{"<\nname T\nradius 1e999\n>", "line 3", "not a finite number"},
        Damage{"<\nname T\nradius 0.1\nnv 2\n0 0 0\n0 inf 0\n>", "line 6", "vertex 1"},
        Damage{"<\nname T\nradius 0.1\nnv 2\n0 0 0\n>", "line 6", "vertex 1"},
        Damage{"<\nname T\nradius 0.1\nnv 1\n0 0 0\n0 0 0\n>", "line 6", "\"0\" is no keyword"},
        Damage{"<\nname T\nradius 0.1\nnv 99999999999999\n>", "line 4", "do not fit in a file"},
        Damage{"<\nname T\nradius 0.1\nnv 99999999999999999999\n>", "line 4", "number of vertices"},
        Damage{"<\nname T\nradius 0.1\nnv -3\n>", "line 4", "-3 vertices"},
        Damage{"<\nname T\nradius 0.1\nnv 1.5\n>", "line 4", "number of vertices"},
        Damage{"<\nname T\nradius 0.1\nnf 4000000000\n>", "line 4", "do not fit in a file"},
        Damage{"<\nname T\nradius 0.1\nnf 1\n4000000000\n>", "line 5", "do not fit in a file"},
        Damage{"<\nname T\nradius 0.1\nnf 1\n2 0 1\n>", "line 5", "2 corners"},
        Damage{"<\nname T\nradius 0.1\nnv 1\n0 0 0\nnf 1\n3 0 1 2\n>", "shape T", "vertex 2"},
        Damage{"<\nname T\nradius 0.1\nne 1\n0 -1\n>", "line 5", "-1"},
        Damage{"<\nname T\nradius 0.1\nne 1\n0 4294967296\n>", "line 5", "4294967296"},
        Damage{tetrahedron_with("radius 0.2"), "shape T", "occurs twice"},
        Damage{tetrahedron_with("colour red"), "shape T", "\"colour\" is no keyword"},
        Damage{tetrahedron_with("preCompDone maybe"), "shape T", "y or n"},
        Damage{tetrahedron_with("orientation 1 1 0 0"), "shape T", "length 1.414"},
        Damage{tetrahedron_with("volume"), "shape T", "the volume is needed"},
        Damage{tetrahedron_with("") + tetrahedron_with(""), "shape T",
               "another shape of the same name"},
        Damage{"<\nname T\nradius 0.1\nnv 5\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 5 5\nne 1\n0 4\n"
               "nf 4\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n>",
               "shape T", "edge 0 4 lies on no face"}));

TEST(ShpFile, MissingFilesAreNamed) {
  EXPECT_TRUE(contains(refusal([] { read_shp("nowhere/a.shp"); }), "nowhere/a.shp"));
  EXPECT_FALSE(is_esri_shapefile("nowhere/a.shp"));
}

TEST(ShpFile, AnyCutIsRefused) {
  const std::string text = tetrahedron_with("preCompDone y\nvolume 1\nI/m 1 1 1");
  for (std::size_t length = 0; length + 2 < text.size(); ++length) {
    EXPECT_FALSE(refusal([&] { shapes_detail::parse_shp(text.substr(0, length)); }).empty())
        << length;
  }
}

TEST(ShpFile, DamagedBytesAreRefusedOrGiveAShapeWhosePartsAreThere) {
  const std::string text = tetrahedron_with("preCompDone y\nvolume 1\norientation 1 0 0 0");
  Random random(11);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = text;
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(random.uniform(0, double(text.size())));
      damaged[at] = static_cast<char>(random.uniform(0, 256));
    }
    try {
      for (const ShpShape& shape : shapes_detail::parse_shp(damaged)) {
        for (const SpheroPolyhedron::Face& face : shape.body.faces) {
          ASSERT_GE(face.size(), 3u);
          for (const std::uint32_t v : face) ASSERT_LT(v, shape.body.vertices.size());
        }
        for (const Vec3& vertex : shape.body.vertices) ASSERT_TRUE(vertex.allFinite());
      }
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
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
