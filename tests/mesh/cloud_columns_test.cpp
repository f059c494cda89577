// Which columns of a text are coordinates.
#include <algorithm>
#include <array>
#include <functional>

#include "core/number_text.hpp"
#include "core/random.hpp"
#include "mesh/reference_system.hpp"
#include "tests/mesh/cloud_files.hpp"
#include "tests/support/cloud_bytes.hpp"

namespace clast {
namespace {

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
    std::string text = format_significant(value, 9);
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
                       "a.pcd: `columns` applies only to clouds in text"));
}

TEST_F(Clouds, UnitsOfHeadingsAreDeclared) {
  write_text_file(folder / "a.csv", "X (ft),Y (ft),Z (ft)\n1,2,3\n");
  const CloudSummary feet = stream_cloud(folder / "a.csv", [](const PointBatch&) {});
  EXPECT_TRUE(contains(refusal([&] {
                         check_length_units("a.csv", feet.unit_declarations,
                                            {.conversion_command = "WAY"});
                       }),
                       "its map unit is the ft (0.3048 m) (heading \"X (ft)\")"));
  write_text_file(folder / "b.csv", "X [m];Y [m];Z [mm]\n1;2;3\n");
  const CloudSummary mixed = stream_cloud(folder / "b.csv", [](const PointBatch&) {});
  EXPECT_TRUE(contains(refusal([&] { check_length_units("b.csv", mixed.unit_declarations, {}); }),
                       "its heights are in units of the mm (0.001 m) (heading \"Z [mm]\")"));
  write_text_file(folder / "u.csv", "id;X;Y;Z\n-;m;m;ft\n1;1;2;3\n");
  const CloudSummary row = stream_cloud(folder / "u.csv", [](const PointBatch&) {});
  EXPECT_TRUE(contains(refusal([&] { check_length_units("u.csv", row.unit_declarations, {}); }),
                       "its heights are in units of the ft (0.3048 m) (unit \"ft\" of line 2)"));
  write_text_file(folder / "c.csv", "X (deg);Y (deg);Z (m)\n1;2;3\n");
  const CloudSummary degrees = stream_cloud(folder / "c.csv", [](const PointBatch&) {});
  EXPECT_TRUE(contains(refusal([&] { check_length_units("c.csv", degrees.unit_declarations, {}); }),
                       "degrees"));
  write_text_file(folder / "d.csv", "X (m);Y (m);Z (m)\n1;2;3\n");
  const CloudSummary metres = stream_cloud(folder / "d.csv", [](const PointBatch&) {});
  EXPECT_TRUE(check_length_units("d.csv", metres.unit_declarations, {}).empty());
}

TEST_F(Clouds, RowsThatSumUpTheOthersAreRefused) {
  for (const char* name : {"Mean", "Std. dev.", "Mittelwert", "\xC3\x98", "75%"}) {
    EXPECT_TRUE(contains(refused("a.csv", std::string("Nr,X,Y,Z\nP1,1,2,3\n") + name + ",1,2,3\n"),
                         "line 3: \"" + std::string(name) + "\" is a sum of other rows"));
  }
}

TEST_F(Clouds, UnitsThatAreNotUnderstoodAreNoted) {
  write_text_file(folder / "a.csv", "X (el);Y (el);Z (el)\n1;2;3\n");
  const CloudSummary els =
      stream_cloud(folder / "a.csv", [](const PointBatch&) {}, {"1", "2", "3"});
  const std::vector<std::string> notes = check_length_units("a.csv", els.unit_declarations, {});
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_TRUE(contains(notes[0], "its heading \"X (el)\" names no known unit or reference system"));
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

TEST_F(Clouds, ANumberOfThePointIsNotTakenForX) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += std::to_string(i + 1) + " 0.5 0.25 0.125\n";
  EXPECT_TRUE(contains(refused("a.xyz", text),
                       "column 1, which was read as x, holds point numbers; name the columns in "
                       "a first line, such as \"id x y z\""));
  EXPECT_EQ(read("b.xyz", "id x y z\n" + text).size(), 200u);
  EXPECT_EQ(read("c.xyz", text + "7 0.5 0.25 0.125\n").size(), 201u) << "a profile may count";
  std::string even;
  for (int i = 0; i < 200; ++i) even += std::to_string(1000 + 2 * i) + " 0.5 0.25 0.125\n";
  EXPECT_TRUE(contains(refused("d.xyz", even), "holds point numbers"));
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
  const char* asked = "column 1 holds only whole numbers, unlike three or more columns after it";
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

}  // namespace
}  // namespace clast
