#include "mesh/point_cloud.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <functional>

#include "core/number_text.hpp"
#include "core/random.hpp"
#include "core/text_file.hpp"
#include "tests/support/cloud_bytes.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

class Clouds : public testing::Test {
 protected:
  std::vector<Vec3> read(const std::string& name, const std::string& content) {
    write_text_file(folder / name, content);
    return read_cloud(folder / name);
  }
  std::string refused(const std::string& name, const std::string& content) {
    write_text_file(folder / name, content);
    return refusal([&] { read_cloud(folder / name); });
  }
  void expect_points(const std::string& name, const std::string& content,
                     const std::vector<Vec3>& expected) {
    const std::vector<Vec3> points = read(name, content);
    ASSERT_EQ(points.size(), expected.size()) << content;
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i], expected[i]) << content;
  }
  ScratchFolder folder;
};

TEST_F(Clouds, TextIsReadHoweverItIsSeparated) {
  const std::vector<Vec3> two = {{1.5, 2.5, 3.5}, {-4, 5e6, 0.25}};
  expect_points("a.xyz", "1.5 2.5 3.5\n-4 5e6 0.25\n", two);
  expect_points("a.txt", "1.5\t2.5\t3.5\t99\r\n-4\t5e6\t0.25\t99", two);
  expect_points("a.csv", "1.5,2.5,3.5,a\n-4, 5e6, 0.25, b\n", two);
  expect_points("b.csv", "1.5;2.5;3.5\n\n-4;5e6;0.25\n", two);
  expect_points("c.csv", "1,5;2,5;3,5\n-4;5e6;0,25\n", two);
  expect_points("d.txt", "1,5 2,5 3,5\n-4 5000000 0,25\n", two);
  expect_points("a.pts", "2\n1.5 2.5 3.5 -120 10 20 30\n-4 5e6 0.25 -80 1 2 3\n", two);
}

TEST_F(Clouds, HeadingsAndRemarksAreUnderstood) {
  const std::vector<Vec3> one = {{1, 2, 3}};
  expect_points("a.csv", "\xEF\xBB\xBF\"Z\",\"X\",\"Y\"\n3,1,2\n", one);
  expect_points("b.csv", "id;x_m;y_m;z [m]\n7;1;2;3\n", one);
  expect_points("c.xyz", "//X Y Z R G B\n# a remark\n1 2 3 255 255 255\n", one);
  expect_points("d.txt", "easting northing height\n1 2 3\n", one);
  expect_points("e.csv", "PointID,Northing,Easting,Elevation_m\n7,2,1,3\n", one);
  expect_points("f.csv", "Nr;E;N;H;code\n7;1;2;3;4\n", one);
  expect_points("h.xyz", "1 2 3\n1,5 2,25 3\n", {{1, 2, 3}, {1.5, 2.25, 3}});
  expect_points("i.csv", "x;y;z;q\n1;2;3;;\n", one);
  expect_points("g.txt", "scan of May\nsite: quarry\nby hand\nid y x z\n7 2 1 3\n", one);
}

/// Rows of a plane as a program writes them: a number, x, y, z and a class, in an order of its own.
struct ColumnLayout {
  char separator;
  bool decimal_comma;
  std::vector<int> order;  ///< of number, x, y, z, class

  std::string row(int k, const Vec3& p) const {
    const std::array<std::string, 5> cells = {std::to_string(1000 + 2 * k), number(p.x()),
                                              number(p.y()), number(p.z()), "2"};
    std::string text;
    for (const int cell : order) {
      text +=
          (text.empty() ? "" : std::string(1, separator)) + cells[static_cast<std::size_t>(cell)];
    }
    return text + "\n";
  }
  std::string heading(const std::array<std::string, 5>& names) const {
    std::string text;
    for (const int cell : order) {
      const std::string& name = names[static_cast<std::size_t>(cell)];
      const bool quote = name.find_first_of(" ,;\t") != std::string::npos && separator == ' ';
      text += (text.empty() ? "" : std::string(1, separator)) + (quote ? "\"" + name + "\"" : name);
    }
    return text + "\n";
  }

 private:
  std::string number(double value) const {
    std::string text = with_digits(value, 9);
    if (decimal_comma) std::replace(text.begin(), text.end(), '.', ',');
    return text;
  }
};

const std::vector<ColumnLayout>& column_layouts() {
  static const std::vector<ColumnLayout> kLayouts = {
      {',', false, {0, 1, 2, 3, 4}}, {',', false, {0, 4, 2, 1, 3}}, {';', false, {0, 1, 2, 3}},
      {';', true, {0, 1, 2, 3, 4}},  {';', true, {3, 2, 1, 0}},     {'\t', false, {0, 1, 2, 3}},
      {'\t', true, {4, 0, 3, 1, 2}}, {' ', false, {0, 1, 2, 3, 4}}, {' ', true, {0, 2, 1, 3}}};
  return kLayouts;
}

std::vector<Vec3> plane_points() {
  std::vector<Vec3> points;
  for (int k = 0; k < 12; ++k) {
    points.emplace_back(500000.25 + k % 4, 4400000.5 + k / 4, 100.125 + k % 4 / 2.0);
  }
  return points;
}

// The names of surveyors and programs in five languages, with units, brackets and quotes.
TEST_F(Clouds, HeadingsOfManyProgramsNameTheColumns) {
  const std::vector<std::array<std::string, 5>> names = {
      {"Point ID", "X (m)", "Y (m)", "Z (m)", "Class"},
      {"ID", "X[m]", "Y[m]", "Z[m]", "Intensity"},
      {"\"id\"", "\"X\"", "\"Y\"", "\"Z\"", "\"code\""},
      {"PointID", "POINT_X", "POINT_Y", "POINT_Z", "grid_code"},
      {"U:0", "Points:0", "Points:1", "Points:2", "U:1"},
      {"vtkOriginalPointIds", "Points_0", "Points_1", "Points_2", "Normals_0"},
      {"Nr", "x-coord", "y-coord", "z-coord", "c"},
      {"name", "Easting (m)", "Northing (m)", "Elevation (m)", "RGB"},
      {"#", "East", "North", "Height [m]", "class"},
      {"fid", "E", "N", "H", "Q"},
      {"N", "X", "Y", "Z", "E"},
      {"Punkt", "Rechtswert", "Hochwert", "Hoehe", "Art"},
      {"Punkt-Nr.", "Rechtswert [m]", "Hochwert [m]", "H\xC3\xB6he [m]", "Klasse"},
      {"Punktnummer", "Ostwert", "Nordwert", "H\xF6he", "Klasse"},  // Windows-1252
      {"Nr.", "X-Koordinate", "Y-Koordinate", "Z-Koordinate", "Code"},
      {"Punkt", "RW", "HW", "H", "Typ"},
      {"Num\xC3\xA9ro", "Est", "Nord", "Altitude (m)", "Classe"},
      {"N\xC2\xB0",
       "Coordonn\xC3\xA9"
       "e X",
       "Coordonn\xC3\xA9"
       "e Y",
       "Coordonn\xC3\xA9"
       "e Z",
       "Type"},
      {"Point", "Abscisse",
       "Ordonn\xC3\xA9"
       "e",
       "Cote", "Nature"},
      {"Punto", "Est (m)", "Nord (m)", "Quota (m)", "Classe"},
      {"id_punto", "Coordinata X", "Coordinata Y", "Altezza", "tipo"},
      {"Punto", "Este", "Norte", "Cota", "Clase"},
      {"N\xC3\xBAmero", "Coord. X", "Coord. Y", "Elevaci\xC3\xB3n", "Tipo"},
      {"objectid", "UTM_E", "UTM_N", "Altura_m", "tipo"},
      {"scan", "pos_x", "pos_y", "pos_z", "nx"},
      {"t", "X in m", "Y in m", "Z in m", "sigma_x"},
      {"gps_time", "CoordX", "CoordY", "CoordZ", "number_of_returns"}};
  for (const auto& each : names) {
    for (const ColumnLayout& layout : column_layouts()) {
      std::string text = layout.heading(each);
      const std::vector<Vec3> expected = plane_points();
      for (std::size_t k = 0; k < expected.size(); ++k) {
        text += layout.row(static_cast<int>(k), expected[k]);
      }
      SCOPED_TRACE(text.substr(0, 120));
      expect_points("a.csv", text, expected);
      expect_points("b.txt", "\xEF\xBB\xBF" + text, expected);
      if (layout.separator != ' ')
        expect_points("c.xyz", "survey of May\n// by hand\n" + text, expected);
    }
  }
}

TEST_F(Clouds, HeadingsThatDoNotSayWhichAreTheAxesAreAskedAbout) {
  const std::vector<std::array<std::string, 5>> names = {
      {"Punkt", "A", "B", "C", "D"},
      {"a", "b", "c", "d", "e"},
      {"id", "U", "V", "W", "class"},
      {"Nr", "X", "X", "Z", "k"},
      {"Nr", "X", "Y", "Temperature", "k"},
      {"Nr.", "\xD0\xA5", "\xD0\xA3", "\xD0\x97", "k"},
      {"id", "Easting", "East", "Height", "k"},
      {"id", "col1", "col2", "col3", "col4"},
      {"id", "Z (m)", "Altitude", "Elevation", "k"}};
  for (const auto& each : names) {
    for (const ColumnLayout& layout : column_layouts()) {
      std::string text = layout.heading(each);
      for (int k = 0; k < 3; ++k)
        text += layout.row(k, plane_points()[static_cast<std::size_t>(k)]);
      EXPECT_TRUE(contains(refused("a.csv", text), "a.csv: line 1: the heading \"")) << text;
      EXPECT_TRUE(contains(refused("a.csv", text), "does not say which of the ")) << text;
      EXPECT_TRUE(
          contains(refused("a.csv", text),
                   "columns are x, y and z; give `columns`, three names or numbers from 1"));
    }
  }
  EXPECT_TRUE(contains(refused("a.csv", "id,longitude,latitude,height\n1,7.5,46.1,500\n"),
                       "longitude and latitude, in degrees"));
  // R writes no heading for the numbers of the rows.
  EXPECT_TRUE(
      contains(refused("a.txt", "\"x\" \"y\" \"z\"\n\"1\" 0.5 0.25 3.5\n\"2\" 0.5 1.25 3.5\n"),
               "does not say which of the 4 columns"));
}

TEST_F(Clouds, ColumnsThatAreAskedForAreTaken) {
  const auto read_columns = [&](const std::string& text, const std::vector<std::string>& columns) {
    write_text_file(folder / "a.csv", text);
    std::vector<Vec3> points;
    stream_cloud(
        folder / "a.csv",
        [&](const PointBatch& batch) {
          points.insert(points.end(), batch.points.begin(), batch.points.end());
        },
        columns);
    return points;
  };
  const std::vector<Vec3> one = {{1, 2, 3}};
  EXPECT_EQ(read_columns("a;b;c;d\n9;1;2;3\n", {"2", "3", "4"}), one);
  EXPECT_EQ(read_columns("a;b;c;d\n9;1;2;3\n", {"b", "C", "d"}), one);
  EXPECT_EQ(read_columns("id,x,y,z\n1,2,9,3\n", {"1", "2", "4"}), one);
  EXPECT_EQ(read_columns("9 1 2 3\n", {"2", "3", "4"}), one);
  EXPECT_EQ(read_columns("\"U (m)\",\"V (m)\",\"W (m)\"\n3,1,2\n", {"V", "W (m)", "U"}), one);
  const auto refused_columns = [&](const std::vector<std::string>& columns) {
    return refusal([&] { read_columns("a;b;c;a\n9;1;2;3\n", columns); });
  };
  EXPECT_TRUE(contains(refused_columns({"1", "2"}), "`columns` must be three names or numbers"));
  EXPECT_TRUE(
      contains(refused_columns({"1", "2", "5"}), "no column \"5\"; give names of its heading"));
  EXPECT_TRUE(contains(refused_columns({"a", "b", "c"}), "several columns \"a\""));
  EXPECT_TRUE(contains(refused_columns({"1", "2", "2"}), "one column can't be two axes"));
  write_text_file(folder / "a.pcd", kPcdHeader + "DATA ascii\n");
  EXPECT_TRUE(contains(refusal([&] {
                         stream_cloud(folder / "a.pcd", [](const PointBatch&) {}, {"1", "2", "3"});
                       }),
                       "a.pcd: `columns` are of clouds in text"));
}

TEST_F(Clouds, UnitsOfHeadingsAreDeclared) {
  write_text_file(folder / "a.csv", "X (ft),Y (ft),Z (ft)\n1,2,3\n");
  const CloudSummary feet = stream_cloud(folder / "a.csv", [](const PointBatch&) {});
  EXPECT_TRUE(contains(refusal([&] { check_lengths("a.csv", feet.lengths, {.way = "WAY"}); }),
                       "its map unit is the ft (0.3048 m) (heading \"X (ft)\")"));
  write_text_file(folder / "b.csv", "X [m];Y [m];Z [mm]\n1;2;3\n");
  const CloudSummary mixed = stream_cloud(folder / "b.csv", [](const PointBatch&) {});
  EXPECT_TRUE(contains(refusal([&] { check_lengths("b.csv", mixed.lengths, {}); }),
                       "its heights are in units of the mm (0.001 m) (heading \"Z [mm]\")"));
  write_text_file(folder / "u.csv", "id;X;Y;Z\n-;m;m;ft\n1;1;2;3\n");
  const CloudSummary row = stream_cloud(folder / "u.csv", [](const PointBatch&) {});
  EXPECT_TRUE(contains(refusal([&] { check_lengths("u.csv", row.lengths, {}); }),
                       "its heights are in units of the ft (0.3048 m) (unit \"ft\" of line 2)"));
  write_text_file(folder / "c.csv", "X (deg);Y (deg);Z (m)\n1;2;3\n");
  const CloudSummary degrees = stream_cloud(folder / "c.csv", [](const PointBatch&) {});
  EXPECT_TRUE(contains(refusal([&] { check_lengths("c.csv", degrees.lengths, {}); }), "degrees"));
  write_text_file(folder / "d.csv", "X (m);Y (m);Z (m)\n1;2;3\n");
  const CloudSummary metres = stream_cloud(folder / "d.csv", [](const PointBatch&) {});
  EXPECT_TRUE(check_lengths("d.csv", metres.lengths, {}).empty());
}

TEST_F(Clouds, TheSeparatorDecidesTheColumns) {
  const std::vector<Vec3> one = {{1, 2, 3}};
  expect_points("a.csv", "time,X,Y,Z\n2024-05-03 12:00:00,1,2,3\n", one);
  expect_points("b.csv", "label;X;Y;Z\nblock one, left;1;2;3\n", one);
  expect_points("c.csv", "\"label, side\",X,Y,Z\n\"one, left\",1,2,3\n", one);
  expect_points("d.txt", "sep=;\nlabel;X;Y;Z\na b;1;2;3\n", one);
  expect_points("e.csv", "label,note,X,Y,Z\n,,1,2,3\n", one);
  expect_points("f.txt", "label\tX\tY\tZ\na b\t1\t2\t3\n", one);
  expect_points("h.csv", "X,Y,Z\n1,2,3,\n", one);
  expect_points("i.csv", "X,Y,Z,\n1,2,3,\n", one);
  expect_points("g.csv", "\"1\",\"2\",\"3\"\n", one);
}

TEST_F(Clouds, WordsOfPcdHaveAnyCase) {
  for (const char* fields : {"FIELDS X Y Z", "FIELDS x Y z", "fields X Y Z", "Fields x y z"}) {
    for (const char* data : {"DATA ascii", "data ASCII", "DATA Ascii"}) {
      expect_points("a.pcd",
                    std::string("VERSION 0.7\n") + fields +
                        "\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n" +
                        data + "\n1 2 3\n",
                    {{1, 2, 3}});
    }
  }
}

TEST_F(Clouds, TextThatIsNoneOfPointsIsRefusedByName) {
  using namespace std::string_literals;
  EXPECT_TRUE(contains(
      refused("a.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n4 5 6\n"),
      "is an Esri grid of heights, and no cloud"));
  EXPECT_TRUE(
      contains(refused("b.csv", "\xFF\xFEX\0;\0Y\0;\0Z\0\r\0\n\0"s), "text in UTF-16; save it as"));
}

TEST_F(Clouds, SeveralScansOfAFileFollowEachOther) {
  expect_points("a.pts", "2\n1 2 3 17\n4 5 6 17\n1\n7 8 9 17\n", {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  expect_points("b.pts", "1\r\n1 2 3 -5 1 2 3\r\n2 \r\n4 5 6 -5 1 2 3\r\n7 8 9 1 2 3 4\r\n",
                {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  // A number alone that counts nothing is a line cut short.
  EXPECT_TRUE(
      contains(refused("c.pts", "3\n1 2 3\n4 5 6\n1\n7 8 9\n"), "line 4: fewer than three"));
  EXPECT_TRUE(contains(refused("d.xyz", "1 2 3\n4\n7 8 9\n"), "line 2: fewer than three"));
}

TEST_F(Clouds, ANumberOfThePointIsNotTakenForX) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += std::to_string(i + 1) + " 0.5 0.25 0.125\n";
  EXPECT_TRUE(contains(refused("a.xyz", text),
                       "column 1, which was taken for x, numbers the points; name the columns in "
                       "a first line, such as \"id x y z\""));
  EXPECT_EQ(read("b.xyz", "id x y z\n" + text).size(), 200u);
  EXPECT_EQ(read("c.xyz", text + "7 0.5 0.25 0.125\n").size(), 201u) << "a profile may count";
  std::string even;
  for (int i = 0; i < 200; ++i) even += std::to_string(1000 + 2 * i) + " 0.5 0.25 0.125\n";
  EXPECT_TRUE(contains(refused("d.xyz", even), "numbers the points"));
}

// Without a heading: numbers in any order, rows and columns of a scanner, and what only looks so.
TEST_F(Clouds, WholeNumbersBeforeThreeOthersAreAskedAbout) {
  Random random(3);
  const auto lines = [&](const std::function<std::string(int)>& first, const std::string& last) {
    std::string text;
    for (int k = 0; k < 200; ++k) {
      text += first(k);
      for (int axis = 0; axis < 3; ++axis) text += " " + std::to_string(random.uniform(2.0, 900.0));
      text += last + "\n";
    }
    return text;
  };
  const char* asked = "column 1 holds whole numbers and three or more behind it do not";
  const auto shuffled = [](int k) { return std::to_string(k * 7919 % 1000); };
  EXPECT_TRUE(contains(refused("a.xyz", lines(shuffled, "")), asked));
  EXPECT_TRUE(contains(refused("b.xyz", lines(shuffled, " 12 250 3")), asked));
  const auto row_column = [](int k) {
    return std::to_string(k / 20) + " " + std::to_string(k % 20);
  };
  EXPECT_TRUE(contains(refused("c.xyz", lines(row_column, " 1 2 3")), asked));
  // A grid of whole metres with heights and normals, and one with scalars below it.
  std::string grid, scalars;
  for (int k = 0; k < 400; ++k) {
    const std::string place =
        std::to_string(600000 + k % 20) + " " + std::to_string(5180000 + k / 20) + " ";
    grid += place + "1000.25 0.25 -0.5 0.75\n";
    scalars += place + "1000.25 12.5\n";
  }
  EXPECT_EQ(read("d.xyz", grid).size(), 400u);
  EXPECT_EQ(read("e.xyz", scalars).size(), 400u);
}

TEST_F(Clouds, TextLongerThanAReadingBlockLosesNothing) {
  std::string text;
  std::vector<Vec3> expected;
  Random random(1);
  for (int i = 0; i < 100000; ++i) {
    expected.emplace_back(random.uniform(-1e4, 1e4), i, -i);
    text += std::to_string(expected.back().x());
    expected.back().x() = std::stod(text.substr(text.rfind('\n') + 1));
    text += ' ' + std::to_string(i) + ' ' + std::to_string(-i) + '\n';
  }
  const std::vector<Vec3> points = read("long.xyz", text);
  EXPECT_EQ(points, expected);
}

TEST_F(Clouds, BadTextIsRefusedByLine) {
  EXPECT_TRUE(contains(refused("a.xyz", "1 2 3\n1 2\n"), "a.xyz: line 2: fewer than three"));
  EXPECT_TRUE(contains(refused("b.xyz", "1 2 3\n\n1 x 3\n"), "line 3: \"x\" stands where y"));
  EXPECT_TRUE(contains(refused("c.xyz", ""), "c.xyz: holds no points: the file is empty"));
  EXPECT_TRUE(contains(refused("n.xyz", "nan 1 2\nnan 1 2\n"),
                       "2 have a coordinate that is not finite; export it again"));
  EXPECT_TRUE(contains(refused("d.xyz", "# nothing\n"), "holds no points"));
  EXPECT_TRUE(contains(refused("e.xyz", "1 2 3\n1 2 1,5,2\n"), "line 2: \"1,5,2\""));
  // Decimal commas between commas: (1.5, 2.5, 3.5).
  EXPECT_TRUE(contains(refused("e.csv", "x,y,z\n1,5,2,5,3,5\n"),
                       "line 2: has 6 fields, but line 1 has 3; where commas are decimal signs"));
  EXPECT_TRUE(contains(refused("e.csv", "1,2,3\n1,5,2,5,3,5\n"), "line 2: has 6 fields"));
  EXPECT_TRUE(contains(refused("e.csv", "id;x;y;z\n7;1;2;3\n8;;2;3\n"),
                       "line 3: an empty field stands where x is needed"));
  EXPECT_TRUE(contains(refused("f.xyz", std::string(3 << 20, 'x')), "line 1: has no end"));
  EXPECT_TRUE(contains(refusal([&] { read_cloud(folder / "none.xyz"); }), "no such file"));
  EXPECT_TRUE(contains(refusal([&] { read_cloud(folder.path()); }), "folder"));
}

TEST_F(Clouds, PointsWithoutPlaceAreCounted) {
  write_text_file(folder / "nan.xyz", "1 2 3\nnan nan nan\n4 5 6\n1 inf 3\n");
  const CloudSummary summary = stream_cloud(folder / "nan.xyz", [](const PointBatch&) {});
  EXPECT_EQ(summary.points, 2u);
  EXPECT_EQ(summary.without_place, 2u);
}

class LasVersions : public testing::TestWithParam<std::array<int, 3>> {};

TEST_P(LasVersions, GivePointsClassesAndSystem) {
  const auto [minor, format, size] = GetParam();
  ScratchFolder folder;
  const Vec3 scale(0.001, 0.01, 0.001), offset(652000, 5203000, 0);
  // One more byte per record than the format needs: extra bytes are allowed.
  write_text_file(
      folder / "a.las",
      las_file(minor, static_cast<std::uint8_t>(format), static_cast<std::size_t>(size) + 1,
               {{{1250, -75, 789123}, 2}, {{0, 0, 1}, 5}, {{1, 1, 1}, 7}, {{2, 2, 2}, 2, true}},
               scale, offset));
  std::vector<Vec3> points;
  std::vector<std::uint8_t> classes;
  const CloudSummary summary = stream_cloud(folder / "a.las", [&](const PointBatch& batch) {
    points.insert(points.end(), batch.points.begin(), batch.points.end());
    classes.insert(classes.end(), batch.classes.begin(), batch.classes.end());
  });
  ASSERT_EQ(points.size(), 2u);
  EXPECT_LT((points[0] - Vec3(652001.25, 5202999.25, 789.123)).norm(), 1e-8);
  EXPECT_LT((points[1] - Vec3(652000, 5203000, 0.001)).norm(), 1e-8);
  EXPECT_EQ(classes, (std::vector<std::uint8_t>{2, 5}));
  EXPECT_EQ(summary.points, 2u);
  EXPECT_EQ(summary.withheld, 2u);  // one flagged, one of class noise
  EXPECT_EQ(summary.crs, "EPSG:25832");
}
INSTANTIATE_TEST_SUITE_P(Formats, LasVersions,
                         testing::Values(std::array{0, 0, 20}, std::array{1, 1, 28},
                                         std::array{2, 2, 26}, std::array{2, 3, 34},
                                         std::array{3, 5, 63}, std::array{4, 6, 30},
                                         std::array{4, 7, 36}, std::array{4, 10, 67}));

TEST_F(Clouds, DamagedLasIsRefused) {
  const std::string good =
      las_file(2, 0, 20, {{{1, 2, 3}}, {{4, 5, 6}}}, Vec3::Ones(), Vec3::Zero());
  ASSERT_EQ(read("good.las", good).size(), 2u);
  EXPECT_TRUE(contains(refused("cut.las", good.substr(0, good.size() - 1)),
                       "cut.las: its header says 2 points, the file has 1"));
  EXPECT_TRUE(contains(refused("short.las", good.substr(0, 100)), "ends within"));
  EXPECT_TRUE(contains(refused("other.las", "ply\n"), "does not start with LASF"));
  std::string bad = good;
  put<double>(bad, 131, 0.0);
  EXPECT_TRUE(contains(refused("scale.las", bad), "scale"));
  bad = good;
  put<std::uint8_t>(bad, 104, 11);
  EXPECT_TRUE(contains(refused("format.las", bad), "point format 11"));
  bad = good;
  put<std::uint16_t>(bad, 105, 12);
  EXPECT_TRUE(contains(refused("record.las", bad), "12 bytes"));
  bad = good;
  put<std::uint32_t>(bad, 96, 4000000000u);
  EXPECT_TRUE(contains(refused("offset.las", bad), "outside the file"));
  bad = good;
  put<std::uint8_t>(bad, 104, 0x80);
  EXPECT_TRUE(contains(refused("packed.laz", bad), "pdal translate cloud.laz cloud.las"));
}

TEST_F(Clouds, PcdInItsThreeForms) {
  const std::vector<Vec3> two = {{1, 2, 3.1}, {4, 5, 6}};
  expect_points("a.pcd", kPcdHeader + "DATA ascii\n1 2 3.1 7\n4 5 6 7\nnan nan 0 7\n", two);
  expect_points("b.pcd", kPcdHeader + "DATA binary\n" + pcd_points(false), two);

  expect_points("c.pcd", packed_pcd(), two);
}

TEST_F(Clouds, DamagedPcdIsRefused) {
  EXPECT_TRUE(contains(refused("a.pcd", kPcdHeader), "no DATA line"));
  EXPECT_TRUE(contains(refused("b.pcd", kPcdHeader + "DATA ascii\n1 2 3 7\n"), "2 are missing"));
  EXPECT_TRUE(contains(refused("c.pcd", kPcdHeader + "DATA ascii\n1 2 x 7\n"), "number is needed"));
  EXPECT_TRUE(
      contains(refused("d.pcd", kPcdHeader + "DATA ascii\n1 2 3\n4 5 6\n"), "fewer values"));
  EXPECT_TRUE(contains(refused("e.pcd", kPcdHeader + "DATA binary\n" + std::string(40, 'x')),
                       "the file has 2"));
  EXPECT_TRUE(contains(refused("f.pcd", kPcdHeader + "DATA zip\n"), "\"zip\""));
  EXPECT_TRUE(contains(refused("g.pcd",
                               "FIELDS x y\nSIZE 4 4\nTYPE F F\nCOUNT 1 1\nPOINTS 1\n"
                               "DATA ascii\n1 2\n"),
                       "has no field z"));
  EXPECT_TRUE(contains(refused("h.pcd", "FIELDS x y z\nPOINTS -4\nDATA ascii\n"), "can't be"));
  std::string file = kPcdHeader + "DATA binary_compressed\n";
  put(file, file.size(), std::uint32_t{3});
  put(file, file.size(), std::uint32_t{60});
  EXPECT_TRUE(contains(refused("i.pcd", file + "\x60\x05\x05"), "corrupt"));
}

TEST_F(Clouds, VerticesOfAMeshArePoints) {
  expect_points("a.ply",
                "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
                "property double z\nproperty uchar red\nend_header\n1 2 3 9\n4 5 6 9\n",
                {{1, 2, 3}, {4, 5, 6}});
}

TEST_F(Clouds, MutatedFilesNeverCrash) {
  const std::vector<std::pair<std::string, std::string>> seeds = {
      {"f.las", las_file(4, 6, 30, {{{1, 2, 3}}, {{4, 5, 6}}}, Vec3::Ones(), Vec3::Zero())},
      {"f.pcd", kPcdHeader + "DATA binary\n" + pcd_points(false)},
      {"old.las", las_file(2, 0, 20, {{{1, 2, 3}}, {{4, 5, 6}}}, Vec3::Ones(), Vec3::Zero())},
      {"text.pcd", kPcdHeader + "DATA ascii\n1 2 3.1 7\n4 5 6 7\n"},
      {"packed.pcd", packed_pcd()},
      {"f.ply",
       "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
       "property double z\nend_header\n1 2 3\n4 5 6\n"},
      {"f.csv", "id;x;y;z\n1;1,5;2,5;3,5\n2;4,0;5,0;6,0\n"},
      {"f.xyz", "x y z\n1.5 2.5 3.5\n4 5 6\n"}};
  Random random(5);
  int refused_count = 0;
  for (const auto& [name, good] : seeds) {
    for (int i = 0; i < 500; ++i) {
      std::string bad = good;
      for (int k = 0; k < 3; ++k) {
        bad[static_cast<std::size_t>(random.uniform(0.0, 0.999) *
                                     static_cast<double>(bad.size()))] =
            static_cast<char>(random.uniform(0.0, 255.9));
      }
      if (i % 3 == 0)
        bad.resize(
            static_cast<std::size_t>(random.uniform(0.0, 1.0) * static_cast<double>(bad.size())));
      std::ofstream(folder / name, std::ios::binary) << bad;  // no wait for the disk
      try {
        read_cloud(folder / name);
      } catch (const InputError& error) {
        ++refused_count;
        EXPECT_TRUE(contains(error.what(), name));
      }
    }
  }
  EXPECT_GT(refused_count, 1000);
}

}  // namespace
}  // namespace clast
