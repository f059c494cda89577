#include "mesh/reference_system.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/files/text_file.hpp"
#include "mesh/point_cloud.hpp"
#include "tests/support/declared_las.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

constexpr double kFoot = 0.3048, kSurveyFoot = 1200.0 / 3937.0;

/// A projected system in WKT 1 with this unit; compound where `vertical` names the unit of heights.
std::string wkt1(const std::string& unit, const std::string& vertical = "") {
  const std::string plan =
      "PROJCS[\"local\",GEOGCS[\"NAD83\",DATUM[\"North_American_Datum_1983\",SPHEROID[\"GRS "
      "1980\",6378137,298.257222101]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],"
      "PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],PARAMETER["
      "\"central_meridian\",-105],PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\","
      "500000],PARAMETER[\"false_northing\",0]," +
      unit + "]";
  if (vertical.empty()) return plan;
  return "COMPD_CS[\"both\"," + plan +
         ",VERT_CS[\"heights\",VERT_DATUM[\"North American Vertical Datum 1988\",2005]," +
         vertical + ",AXIS[\"Up\",UP]]]";
}

std::string wkt2(const std::string& unit, const std::string& vertical = "") {
  const std::string plan =
      "PROJCRS[\"local\",BASEGEOGCRS[\"NAD83\",DATUM[\"North American Datum 1983\",ELLIPSOID[\"GRS "
      "1980\",6378137,298.257222101,LENGTHUNIT[\"metre\",1]]],PRIMEM[\"Greenwich\",0,ANGLEUNIT["
      "\"degree\",0.0174532925199433]]],CONVERSION[\"tm\",METHOD[\"Transverse "
      "Mercator\",ID[\"EPSG\","
      "9807]],PARAMETER[\"Latitude of natural origin\",0,ANGLEUNIT[\"degree\",0.0174532925199433]],"
      "PARAMETER[\"Longitude of natural origin\",-105,ANGLEUNIT[\"degree\",0.0174532925199433]],"
      "PARAMETER[\"Scale factor at natural "
      "origin\",0.9996,SCALEUNIT[\"unity\",1]],PARAMETER[\"False "
      "easting\",500000,LENGTHUNIT[\"metre\",1]],PARAMETER[\"False northing\",0,LENGTHUNIT["
      "\"metre\",1]]],CS[Cartesian,2],AXIS[\"(E)\",east,ORDER[1]],AXIS[\"(N)\",north,ORDER[2]]," +
      unit + "]";
  if (vertical.empty()) return plan;
  return "COMPOUNDCRS[\"both\"," + plan +
         ",VERTCRS[\"heights\",VDATUM[\"North American Vertical Datum 1988\"],CS[vertical,1],AXIS["
         "\"gravity-related height (H)\",up]," +
         vertical + "]]";
}

const char* const kMetre1 = "UNIT[\"metre\",1]";
const char* const kSurveyFoot1 = "UNIT[\"US survey foot\",0.3048006096012192]";
const char* const kFoot1 = "UNIT[\"foot\",0.3048]";
const char* const kMetre2 = "LENGTHUNIT[\"metre\",1]";
const char* const kSurveyFoot2 = "LENGTHUNIT[\"US survey foot\",0.304800609601219]";

/// One way of declaring something, and the metres in a unit of it.
struct Way {
  const char* name;
  LasDeclaration says;
  double metres;
};

const std::vector<Way>& ways_of_plan() {
  static const std::vector<Way> kWays = {
      {"nothing", {}, 1.0},
      {"code in metres", {.keys = {{1024, 1}, {3072, 26913}}}, 1.0},
      {"code in survey feet", {.keys = {{1024, 1}, {3072, 2232}}}, kSurveyFoot},
      {"code in feet", {.keys = {{3072, 2222}}}, kFoot},
      {"code and unit in metres", {.keys = {{1024, 1}, {3072, 26913}, {3076, 9001}}}, 1.0},
      {"unit over code", {.keys = {{1024, 1}, {3072, 26913}, {3076, 9003}}}, kSurveyFoot},
      {"unit under code", {.keys = {{1024, 1}, {3072, 2232}, {3076, 9001}}}, kSurveyFoot},
      {"own system in metres",
       {.keys = {{1024, 1}, {2048, 4269}, {3072, 32767}, {3074, 32767}, {3075, 1}, {3076, 9001}}},
       1.0},
      {"own system in feet", {.keys = {{1024, 1}, {3072, 32767}, {3076, 9002}}}, kFoot},
      {"own system in survey feet, no kind", {.keys = {{3072, 32767}, {3076, 9003}}}, kSurveyFoot},
      {"unit alone", {.keys = {{3076, 9003}}}, kSurveyFoot},
      {"unit of its own size",
       {.keys = {{1024, 1}, {3072, 32767}, {3076, 32767}, {3077, 0, 0.3048}}},
       kFoot},
      {"metre of its own size",
       {.keys = {{1024, 1}, {3072, 32767}, {3076, 32767}, {3077, 0, 1.0}}},
       1.0},
      {"foot in a citation",
       {.keys = {{1024, 1}, {3072, 32767}, {3073, 0, 0.0, "NAD_1983_StatePlane_Colorado_Feet|"}}},
       kFoot},
      {"metres in a citation",
       {.keys = {{1024, 1}, {3072, 32767}, {3073, 0, 0.0, "NAD83 / UTM zone 13N|"}}},
       1.0},
      {"WKT 1 in metres", {.wkt = wkt1(kMetre1)}, 1.0},
      {"WKT 1 in survey feet", {.wkt = wkt1(kSurveyFoot1)}, kSurveyFoot},
      {"WKT 1 in feet beside a code in metres",
       {.keys = {{1024, 1}, {3072, 26913}}, .wkt = wkt1(kFoot1), .encoding = 16},
       kFoot},
      {"WKT 1 in metres beside a code in metres",
       {.keys = {{1024, 1}, {3072, 26913}}, .wkt = wkt1(kMetre1), .encoding = 16},
       1.0},
      {"WKT 2 in metres", {.wkt = wkt2(kMetre2), .minor = 4, .encoding = 16}, 1.0},
      {"WKT 2 in survey feet",
       {.wkt = wkt2(kSurveyFoot2), .minor = 4, .encoding = 16},
       kSurveyFoot},
      {"WKT 2 after the points",
       {.wkt = wkt2(kSurveyFoot2), .wkt_after_points = true, .minor = 4, .encoding = 16},
       kSurveyFoot},
      {"local system of WKT 1 in feet",
       {.wkt =
            "LOCAL_CS[\"pit\",LOCAL_DATUM[\"pit\",0],UNIT[\"foot\",0.3048],AXIS[\"x\",EAST],AXIS["
            "\"y\",NORTH]]"},
       kFoot},
      {"engineering system in metres",
       {.wkt = "ENGCRS[\"pit\",EDATUM[\"pit\"],CS[Cartesian,2],AXIS[\"x\",east],AXIS[\"y\",north],"
               "LENGTHUNIT[\"metre\",1]]"},
       1.0},
      {"engineering system in feet",
       {.wkt = "ENGCRS[\"pit\",EDATUM[\"pit\"],CS[Cartesian,3],AXIS[\"x\",east],AXIS[\"y\",north],"
               "AXIS[\"z\",up],LENGTHUNIT[\"foot\",0.3048]]"},
       kFoot}};
  return kWays;
}

/// @param vertical  of WKT
struct HeightWay {
  const char* name;
  std::vector<LasKey> keys;
  const char* vertical1;
  const char* vertical2;
  double metres;
};

const std::vector<HeightWay>& ways_of_heights() {
  static const std::vector<HeightWay> kWays = {
      {"nothing", {}, "", "", 1.0},
      {"unit key metre", {{4099, 9001}}, kMetre1, kMetre2, 1.0},
      {"unit key foot", {{4099, 9002}}, kFoot1, "LENGTHUNIT[\"foot\",0.3048]", kFoot},
      {"unit key survey foot", {{4099, 9003}}, kSurveyFoot1, kSurveyFoot2, kSurveyFoot},
      {"system in metres", {{4096, 5703}}, kMetre1, kMetre2, 1.0},
      {"system in survey feet", {{4096, 6360}}, kSurveyFoot1, kSurveyFoot2, kSurveyFoot},
      {"system in feet", {{4096, 8228}}, kFoot1, "LENGTHUNIT[\"foot\",0.3048]", kFoot},
      {"datum of GeoTIFF 1.0, unit in metres", {{4096, 5103}, {4099, 9001}}, kMetre1, kMetre2, 1.0},
      {"system in metres, unit in survey feet",
       {{4096, 5703}, {4099, 9003}},
       kSurveyFoot1,
       kSurveyFoot2,
       kSurveyFoot}};
  return kWays;
}

class DeclaredLengths : public testing::Test {
 protected:
  CloudSummary read(const LasDeclaration& says) {
    const Vec3 at(500000, 4400000, 100);
    write_text_file(folder / "a.las", declared_las(says, {at, at + Vec3(1, 0, 0)}));
    return stream_cloud(folder / "a.las", [](const PointBatch&) {});
  }
  std::string refused(const LasDeclaration& says, double unit = 1.0) {
    return refusal([&] {
      check_length_units("a.las", read(says).unit_declarations,
                         {.unit = unit, .unit_given = unit != 1.0, .conversion_command = "WAY"});
    });
  }
  ScratchFolder folder;
};

bool names_feet(const std::string& message) {
  return contains(message, "foot") || contains(message, "feet");
}

// What is declared in metres by every word of a file is read, and everything else is refused.
TEST_F(DeclaredLengths, AreReadFromKeysAndWktInEveryCombination) {
  std::size_t read_count = 0, refused_count = 0;
  for (const Way& plan : ways_of_plan()) {
    for (const HeightWay& height : ways_of_heights()) {
      LasDeclaration says = plan.says;
      says.keys.insert(says.keys.end(), height.keys.begin(), height.keys.end());
      const std::string message = refused(says);
      const bool metres = plan.metres == 1.0 && height.metres == 1.0;
      SCOPED_TRACE(std::string(plan.name) + ", heights: " + height.name + ": " + message);
      EXPECT_EQ(message.empty(), metres);
      if (!metres) {
        EXPECT_TRUE(names_feet(message) || contains(message, "user-defined unit"));
      }
      ++(metres ? read_count : refused_count);
    }
  }
  EXPECT_GT(read_count, 30u);
  EXPECT_GT(refused_count, 100u);
}

TEST_F(DeclaredLengths, OfBothPartsOfACompoundSystemCount) {
  for (const HeightWay& height : ways_of_heights()) {
    if (!*height.vertical1) continue;
    for (const std::string& wkt :
         {wkt1(kMetre1, height.vertical1), wkt2(kMetre2, height.vertical2)}) {
      const std::string message = refused({.wkt = wkt, .minor = 4, .encoding = 16});
      EXPECT_EQ(message.empty(), height.metres == 1.0) << height.name << ": " << message;
      if (height.metres != 1.0) {
        EXPECT_TRUE(contains(message, "heights")) << message;
      }
    }
  }
}

TEST_F(DeclaredLengths, OfHeightsThatStandBehindThePlanCount) {
  const std::string plan = wkt1("UNIT[\"Meter\",1.0]");
  const auto heights = [](const char* unit) {
    return ",VERTCS[\"NAVD_1988\",VDATUM[\"North_American_Vertical_Datum_1988\"],PARAMETER["
           "\"Vertical_Shift\",0.0],PARAMETER[\"Direction\",1.0],UNIT[" +
           std::string(unit) + "]]";
  };
  EXPECT_EQ(refused({.wkt = plan + heights("\"Meter\",1.0")}), "");
  EXPECT_TRUE(contains(refused({.wkt = plan + heights("\"Foot_US\",0.3048006096012192")}),
                       "its heights are in units of the"));
  EXPECT_TRUE(contains(refused({.wkt = plan + heights("\"Foot\",0.3048")}),
                       "its heights are in units of the"));
}

TEST_F(DeclaredLengths, RefusalsNameItemValueAndWay) {
  EXPECT_TRUE(
      contains(refused({.keys = {{1024, 1}, {3072, 2232}}}),
               "a.las: its map unit is the US survey foot (0.3048006 m) (GeoTIFF key 3072 = "
               "2232, NAD83 / Colorado Central (ftUS)); project it to a system in metres "
               "first (WAY)"));
  EXPECT_TRUE(contains(
      refused({.keys = {{1024, 1}, {3072, 26913}, {3076, 9003}}}),
      "the unit of its x and y is the metre according to its GeoTIFF key 3072 = 26913, NAD83 / UTM "
      "zone 13N, but the US survey foot (0.3048006 m) according to its GeoTIFF key 3076 = 9003; "
      "correct the one that is wrong"));
  EXPECT_TRUE(contains(refused({.keys = {{1024, 1}, {3072, 26913}, {4099, 9003}}}),
                       "its heights are in units of the US survey foot (0.3048006 m) (GeoTIFF key "
                       "4099 = 9003), its x and y in units of the metre"));
  EXPECT_TRUE(contains(refused({.keys = {{1024, 1}, {3072, 32767}, {3076, 32767}}}),
                       "user-defined unit of unstated length"));
  EXPECT_TRUE(contains(refused({.keys = {{1024, 1}, {3072, 32767}, {3076, 9102}}}),
                       "the code 9102, which is not a length unit"));
}

TEST_F(DeclaredLengths, DegreesAndGeocentricCoordinatesAreRefused) {
  const char* degrees = "coordinates are degrees; project it to metres first, for example with WAY";
  EXPECT_TRUE(contains(refused({.keys = {{1024, 2}, {2048, 4326}}}), degrees));
  EXPECT_TRUE(contains(refused({.keys = {{2048, 4326}}}), degrees));
  EXPECT_TRUE(contains(refused({.keys = {{1024, 2}, {2048, 32767}, {2054, 9102}}}), degrees));
  EXPECT_TRUE(contains(refused({.keys = {{1024, 2}, {2048, 4326}, {4099, 9001}}}), degrees));
  EXPECT_TRUE(contains(refused({.keys = {{3072, 4326}}}), degrees));
  EXPECT_TRUE(contains(refused({.keys = {{1024, 2}, {3072, 26913}}}),
                       "are lengths according to its GeoTIFF key 3072 = 26913"));
  EXPECT_TRUE(contains(refused({.wkt = "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS "
                                       "84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],UNIT["
                                       "\"degree\",0.0174532925199433]]"}),
                       degrees));
  EXPECT_TRUE(contains(refused({.keys = {{1024, 3}, {2048, 4978}}}), "geocentric"));
  EXPECT_TRUE(contains(refused({.keys = {{1024, 1}, {3072, 32767}, {3075, 7}, {3076, 9001}}}),
                       "its projection is Mercator"));
}

// The user's unit holds where it is one that the file declares, or the only one.
TEST_F(DeclaredLengths, AGivenUnitDecides) {
  EXPECT_EQ(refused({.keys = {{1024, 1}, {3072, 2232}}}, kFoot), "");
  EXPECT_EQ(refused({.keys = {{1024, 1}, {3072, 26913}, {3076, 9003}}}, kSurveyFoot), "");
  EXPECT_TRUE(contains(refused({.keys = {{1024, 1}, {3072, 26913}, {4099, 9003}}}, kSurveyFoot),
                       "its heights are in units of"));
  const std::vector<std::string> notes =
      check_length_units("a.las", read({.keys = {{1024, 1}, {3072, 26913}}}).unit_declarations,
                         {.unit = 0.001, .unit_given = true});
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(contains(notes[0], "its map unit is the metre (GeoTIFF key 3072 = 26913"));
  EXPECT_TRUE(contains(notes[0], "lengths were read as 0.001 m per unit, as requested"));
}

TEST_F(DeclaredLengths, ThatNobodyUnderstandsAreNoted) {
  const std::vector<std::string> notes = check_length_units(
      "a.las", read({.keys = {{1024, 1}, {3072, 1}}, .wkt = "nonsense"}).unit_declarations, {});
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_TRUE(contains(notes[0], "GeoTIFF key 3072 = 1 names no known unit or reference system"));
  EXPECT_TRUE(contains(notes[1], "WKT names no known unit or reference system"));
}

// Mercator on a sphere has the scale 1 / cos(latitude); on the ellipsoid of WGS 84 both scales are
// within 0.7 % of it. Transverse Mercator of UTM has 0.9996 on its central meridian.
TEST(MapScale, IsTheStretchOfTheProjection) {
  constexpr double kRadius = 6378137.0;
  for (const double degrees : {0.0, 20.0, 46.8, 70.0}) {
    const double latitude = degrees * std::acos(-1.0) / 180.0;
    const double y = kRadius * std::log(std::tan(std::acos(-1.0) / 4.0 + latitude / 2.0));
    const auto scale = map_scale_factor("EPSG:3857", {1.1e6, y});
    ASSERT_TRUE(scale);
    EXPECT_NEAR(scale->x() * std::cos(latitude), 1.0, 0.007);
    EXPECT_NEAR(scale->y() * std::cos(latitude), 1.0, 0.007);
  }
  EXPECT_NEAR(map_scale_factor("EPSG:32632", {5e5, 5.2e6})->x(), 0.9996, 1e-6);
  EXPECT_NEAR(map_scale_factor("EPSG:32632", {5e5, 5.2e6})->y(), 0.9996, 1e-6);
  EXPECT_NEAR(map_scale_factor("EPSG:2232", {3e6, 1.7e6})->x(), 1.0, 2e-4);  // in feet
  EXPECT_NEAR(map_scale_factor("EPSG:3832", {3.33958e6, 0.0})->x(), 1.0, 1e-3)
      << "on the date line";
  EXPECT_FALSE(map_scale_factor("EPSG:4326", {10.0, 46.0}));
}

TEST(MapScale, OfWorldMapsIsRefusedAndOfSurveyorsMapsIsNot) {
  const auto refused = [](const std::string& crs, const Vec2& place) {
    return refusal([&] { check_map_scale("a.tif", crs, place, "convert EPSG:CODE"); });
  };
  const std::string mercator = refused("EPSG:3857", {1147666, 5903972});
  EXPECT_TRUE(contains(mercator,
                       "a.tif: lengths on its map (WGS 84 / Pseudo-Mercator (EPSG:3857)) are 1."));
  EXPECT_TRUE(
      contains(mercator, "project it to a local system in metres first (convert EPSG:32632)"));
  const Vec2 alps(1147666, 5903972);
  for (const char* crs : {"EPSG:3395", "EPSG:4087", "ESRI:102100", "ESRI:54009", "EPSG:6933"}) {
    EXPECT_TRUE(contains(refused(crs, alps), "those on the ground")) << crs;
  }
  EXPECT_TRUE(contains(refused("EPSG:3857", {-8.2e6, -4.1e6}), "EPSG:32718"));
  const std::vector<std::pair<const char*, Vec2>> good = {{"EPSG:32632", {652000, 5203000}},
                                                          {"EPSG:2154", {652000, 6860000}},
                                                          {"EPSG:2056", {2600000, 1200000}},
                                                          {"EPSG:31287", {400000, 400000}},
                                                          {"EPSG:3035", {4321000, 2600000}},
                                                          {"EPSG:27700", {530000, 180000}},
                                                          {"EPSG:26913", {500000, 4400000}},
                                                          {"EPSG:2193", {1570000, 5180000}},
                                                          {"EPSG:25832", {1.0, 2.0}},
                                                          {"EPSG:2154", {3.0, 4.0}},
                                                          {"EPSG:27572", {600000, 2200000}},
                                                          {"EPSG:3857", {1e6, 0.0}},
                                                          {"", {5e5, 5e6}},
                                                          {"nonsense", {5e5, 5e6}}};
  for (const auto& [crs, place] : good) EXPECT_EQ(refused(crs, place), "") << crs;
}

TEST(ReferenceSystemName, IsTheNameWithItsCode) {
  EXPECT_EQ(reference_system_name("EPSG:26913"), "NAD83 / UTM zone 13N (EPSG:26913)");
  EXPECT_EQ(reference_system_name(wkt1(kMetre1)), "local");
  EXPECT_EQ(reference_system_name("by hand"), "by hand");
  EXPECT_EQ(reference_system_name(std::string(700, 'x')).size(), 63u);
}

}  // namespace
}  // namespace clast
