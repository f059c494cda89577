// Populations out of tables and libraries: how they are read, and what is said of them.
#include "report/population_reading.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/files/text_file.hpp"
#include "core/utf8.hpp"
#include "report/json/population_json.hpp"
#include "report/population_report.hpp"
#include "report/text/population_text.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/library/core_library.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/working_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Two talus tables in centimetres with masses, the second more elongated.
class Talus : public WorkingFolder {
 protected:
  void SetUp() override {
    write_text_file("east.csv",
                    "id;L_cm;I_cm;S_cm;mass_kg\r\nE1;65,5;53;38;310\r\nE2;80;75;60;850\r\n"
                    "E3;40;38;30;\r\nE4;70;60;20;200\r\nE5;90;80;0;500\r\n");
    write_text_file(
        "west.csv",
        "id;L_cm;I_cm;S_cm;mass_kg\nW1;90;50;40;400\nW2;50;100;45;500\nW3;70;40;38;250\n");
  }
  /// Reads what `request` asks for, and the JSON of it.
  Json json_of(const PopulationReportRequest& request) {
    report = read_populations(request);
    std::ostringstream out;
    write_population_json(out, report);
    return Json::parse(out.str());
  }
  Json json_of(const std::vector<std::string>& inputs) {
    return json_of({.first = tables(inputs)});
  }
  static PopulationFiles tables(const std::vector<std::string>& inputs,
                                const std::string& columns = "L=L,I=I,S=S",
                                const std::string& units = "") {
    return {inputs, columns, units};
  }
  /// What a terminal is shown of the notes.
  std::string brief() const {
    std::string text;
    for (const ReportedPopulation& reported : report.populations) {
      for (const std::string& note : reported.brief_notes) text += note + "\n";
    }
    return text;
  }
  static std::string refused(const std::string& table, const std::string& columns) {
    return refusal([&] { read_populations({.first = tables({table}, columns)}); });
  }

  PopulationReport report;
};

TEST_F(Talus, GivesSharesByNumberAndByMass) {
  const Json json = json_of({"east.csv"});
  EXPECT_EQ(json["blocks"].size(), 4u);
  EXPECT_EQ(json["blocks"][0]["mass_kg"], 310.0);
  EXPECT_NEAR(json["blocks"][0]["box_m"][0], 0.655, 1e-12);
  EXPECT_FALSE(json["blocks"][2].contains("mass_kg"));
  double mass = 0.0, share = 0.0;
  for (const Json& row : json["population"]["zingg"]) {
    mass += double(row["mass_kg"]);
    share += double(row["mass_share"]);
  }
  EXPECT_NEAR(mass, 1360.0, 1e-9);
  EXPECT_NEAR(share, 1.0, 1e-12);
  EXPECT_NEAR(json["size"]["by_number"]["d50_m"], 0.565, 1e-12);  // 0.38 0.53 | 0.6 0.75
  EXPECT_EQ(json["size"]["by_mass"]["blocks"], 3);
  // Rows are named by line and counted.
  for (const char* part :
       {"east.csv: row 6 skipped", "row 4: mass is missing", "east.csv: 4 rows used, 1 skipped"}) {
    EXPECT_TRUE(contains(brief(), part));
  }
}

TEST_F(Talus, SeveralTablesAreOnePopulation) {
  const Json json = json_of({"east.csv", "west.csv"});
  EXPECT_EQ(json["blocks"].size(), 7u);
  EXPECT_EQ(json["name"], "east + west");
  write_text_file("a.txt", "3 2 1\n");
  write_text_file("b.txt", "3 2 1\n");
  const Json bare = json_of({.first = tables({"a.txt", "b.txt"}, "L=1,I=2,S=3")});
  EXPECT_EQ(bare["blocks"][0]["id"], "a row 1");
  EXPECT_EQ(bare["blocks"][1]["id"], "b row 1");
}

TEST_F(Talus, ComparesTwoPopulations) {
  const Json json = json_of({.first = tables({"east.csv"}), .against = {{"west.csv"}, "", ""}});
  EXPECT_EQ(json["against"]["blocks"].size(), 3u);
  EXPECT_EQ(json["comparison"]["a"], "east");
  const Json& s_c = json["comparison"]["measures"][0];
  // s_c: 0.236 0.067 0.053 0.167 against 0.8 1.0 0.75: no overlap, 2 of the 35 deals.
  EXPECT_EQ(s_c["measure"], "s_c");
  EXPECT_EQ(s_c["ks_distance"], 1.0);
  EXPECT_NEAR(s_c["p_value"], 2.0 / 35.0, 1e-12);
  EXPECT_EQ(json["comparison"]["schemes"].size(), json["population"].size());
  const std::string text = format_population_comparison(*report.comparison);
  EXPECT_TRUE(contains(text, "east against west"));
  EXPECT_TRUE(contains(text, "No difference in s_c"));
}

TEST_F(Talus, PopulationsOfOneNameAreNumbered) {
  fs::create_directory("old");
  fs::copy_file("west.csv", "old/east.csv");
  const Json json = json_of({.first = tables({"east.csv"}), .against = {{"old/east.csv"}, "", ""}});
  EXPECT_EQ(json["comparison"]["a"], "east (1)");
  EXPECT_EQ(json["comparison"]["b"], "east (2)");
}

TEST_F(Talus, ASecondPopulationMayHaveItsOwnColumnsAndUnit) {
  write_text_file("north.txt", "1 0.9 0.8 0.7\n2 0.6 0.5 0.4\n");
  const Json json = json_of(
      {.first = tables({"east.csv"}), .against = tables({"north.txt"}, "L=2,I=3,S=4,name=1", "m")});
  EXPECT_NEAR(json["against"]["blocks"][0]["box_m"][0], 0.9, 1e-12);
  EXPECT_EQ(json["against"]["blocks"][1]["id"], "2");
}

TEST_F(Talus, SizeMayBeTheMeanAxis) {
  const Json json =
      json_of({.first = tables({"east.csv"}), .options = {.size = SizeMeasure::kMean}});
  EXPECT_EQ(json["size"]["size"], "(L I S)^(1/3)");
}

TEST_F(Talus, TapedAxesAreReadInTheirUnit) {
  // The two blocks of a teaching sheet: CB and VP after Sneed & Folk.
  write_text_file("sheet.csv", "name,litho,a,b,c\none,x,56,49.5,39\ntwo,y,46,36,13\n");
  const Json blocks = json_of({.first = tables({"sheet.csv"}, "L=3,I=4,S=5", "cm")})["blocks"];
  EXPECT_EQ(blocks[0]["sneed_folk"], "CB");
  EXPECT_EQ(blocks[1]["sneed_folk"], "VP");
  EXPECT_NEAR(blocks[1]["box_m"][0], 0.46, 1e-12);
}

TEST_F(Talus, SizesAreWeighedAndPopulationsCompared) {
  std::string talus = "L,I,S,kg\n", rods = "L,I,S\n";
  for (int i = 0; i < 20; ++i) {
    const std::string size = std::to_string(1.0 + 0.01 * i);
    talus += size + ",0.9,0.8," + std::to_string(100 + i) + "\n";
    rods += std::to_string(3.0 + 0.01 * i) + ",0.9,0.8\n";
  }
  write_text_file("talus.csv", talus + "0,1,1,5\n");
  write_text_file("rods.csv", rods);
  json_of({.first = tables({"talus.csv"}, "L=L,I=I,S=S,mass=kg")});
  EXPECT_TRUE(contains(format_population_summary(report.populations[0].summary), "by mass"));
  EXPECT_EQ(report.populations[0].skipped, 1u);
  EXPECT_TRUE(contains(brief(), "row 22 skipped"));

  const Json json = json_of({.first = tables({"talus.csv"}),
                             .against = {{"rods.csv"}, "", ""},
                             .options = {.schemes = {"garcia"}}});
  EXPECT_EQ(json["skipped"], 1);
  EXPECT_EQ(json["comparison"]["measures"][0]["ks_distance"], 1.0);
  EXPECT_LT(json["comparison"]["schemes"][0]["p_value"], 1e-6);
  EXPECT_EQ(json["blocks"][0]["axis_error_m"], 0.05);
  EXPECT_EQ(json["box"], "as measured");
  EXPECT_EQ(json["size"]["by_number"]["d50_m"], 0.9);
}

TEST_F(Talus, AColumnIsOneQuantity) {
  EXPECT_TRUE(contains(refused("east.csv", "L=1,I=1,S=3"), "column 1 is given as L and as I"));
  EXPECT_TRUE(contains(refused("east.csv", "L=1,L=2"), "L is given as column 1 and as column 2"));
  EXPECT_TRUE(contains(refused("east.csv", "L=L_cm,I=2,S=S_cm"), "L and as I"));
  write_text_file("twice.csv", "L,I,S,L\n3,2,1,4\n");
  EXPECT_TRUE(contains(refused("twice.csv", ""), "1, 4"));
}

TEST_F(Talus, OptionsThatCantBeUnderstoodAreRefusedByTheirFields) {
  EXPECT_TRUE(contains(refused("east.csv", "L=1,weight=2"), "`columns`: \"weight=2\""));
  EXPECT_TRUE(contains(
      refusal([&] { PopulationReportRequest{.first = tables({"east.csv"}, "", "ell")}.check(); }),
      "`units`: \"ell\" is not a length unit"));
  EXPECT_TRUE(
      contains(refusal([&] {
                 PopulationReportRequest{.options = {.schemes = {"zingg", "zingg"}}}.check();
               }),
               "`schemes`: names zingg more than once"));
  EXPECT_TRUE(contains(
      refusal([&] { PopulationReportRequest{.options = {.schemes = {"best"}}}.check(); }), "best"));
  const PopulationReportRequest box = {.first = tables({"east.csv"}),
                                       .reading = {.box = "feret", .box_given = true}};
  EXPECT_TRUE(contains(refusal([&] { read_populations(box); }), "`box`: east.csv is a table"));
}

TEST_F(Talus, TablesThatCantBeReadAreRefused) {
  write_text_file("empty.csv", "");
  write_text_file("other.csv", "name,weight\none,5\n");
  write_text_file("bad.csv", "L,I,S\nlong,wide,high\n");
  for (const std::string file : {"none.csv", "empty.csv", "bad.csv"}) {
    EXPECT_TRUE(contains(refused(file, ""), file));
  }
  EXPECT_TRUE(contains(refused("other.csv", ""), "weight"));
  EXPECT_TRUE(contains(refused("east.csv", "mass=kilos"), "kilos"));
  EXPECT_TRUE(contains(
      refusal([&] {
        read_populations({.first = tables({"east.csv"}), .against = {{"south.csv"}, "", ""}});
      }),
      "south.csv"));
}

TEST_F(Talus, BlocksThatAreCountedTwiceAreNoted) {
  const Json twice = json_of({"east.csv", "east.csv"});
  EXPECT_EQ(twice["blocks"].size(), 8u);
  EXPECT_TRUE(contains(brief(), "the same file is given 2 times"));
  EXPECT_TRUE(contains(brief(), "counted 2 times"));
  EXPECT_TRUE(contains(twice["notes"].dump(), "counted 2 times"));
  // By content, whatever the name.
  fs::copy_file("east.csv", "copy.csv");
  EXPECT_TRUE(contains(json_of({"east.csv", "copy.csv"})["notes"].dump(), "east.csv, copy.csv"));
  const Json both = json_of({.first = tables({"east.csv"}), .against = {{"copy.csv"}, "", ""}});
  EXPECT_TRUE(contains(both["against"]["notes"].dump(), "both populations hold the same file"));
  write_text_file("a.csv", "id,L,I,S\nA,3,2,1\nA,3,2,1\nB,3,2,1\nA,3,2,1\n");
  EXPECT_TRUE(contains(json_of({"a.csv"})["notes"].dump(), "A 3 times"));
}

TEST_F(Talus, DoubtfulUnitsAndErrorsAreNoted) {
  write_text_file("cm.csv", "L,I,S\n90,70,50\n");
  EXPECT_TRUE(contains(json_of({"cm.csv"})["notes"].dump(), "0.9 m in cm"));
  EXPECT_TRUE(contains(brief(), "`units`"));
  write_text_file("pebbles.csv", "L_mm,I_mm,S_mm\n20,15,10\n");
  EXPECT_TRUE(contains(json_of({"pebbles.csv"})["notes"].dump(), "`axis_error`"));
  EXPECT_TRUE(contains(brief(), "`axis_error`"));
  const Json sure = json_of({.first = tables({"pebbles.csv"}), .reading = {.axis_error = 0.001}});
  EXPECT_EQ(sure["notes"].size(), 1u);  // the unit
}

// As Excel saves accents: everything written is UTF-8 all the same.
TEST_F(Talus, NamesInLatin1ComeOutAsUtf8) {
  write_text_file("\xe9t\xe9.csv", "id;L;I;S\nCh\xe2teau;3;2;1\n\xc9tang;3;1;1\n");
  EXPECT_EQ(json_of({"\xe9t\xe9.csv"})["blocks"][1]["id"], "\xc3\x89tang");
  EXPECT_TRUE(contains(brief(), "Windows-1252"));
  fs::create_directory("out");
  write_population_report(report, "out");
  for (const std::string& name : names_in("out")) {
    EXPECT_TRUE(is_utf8(read_text_file(fs::path("out") / name))) << name;
  }
  EXPECT_TRUE(contains(read_text_file("out/classes.csv"), "\xc3\xa9t\xc3\xa9,Ch"));
}

TEST_F(Talus, ProvenanceHoldsEveryOption) {
  fs::create_directory("out");
  write_population_report(read_populations({.first = tables({"east.csv"}, "L=2,I=3,S=4", "mm"),
                                            .against = {{"west.csv"}, "", "cm"},
                                            .reading = {.axis_error = 0.001}}),
                          "out");
  const Json json = Json::parse(read_text_file("out/provenance.json"));
  const Json& east = json["populations"][0];
  EXPECT_EQ(east["columns"], "L=2,I=3,S=4");
  EXPECT_EQ(east["units"], "mm");
  EXPECT_EQ(east["axis_error_m"], 0.001);
  EXPECT_TRUE(east["box"].is_null());
  EXPECT_EQ(json["populations"][1]["units"], "cm");
  EXPECT_EQ(east["inputs"][0]["file"], "east.csv");
  EXPECT_EQ(east["inputs"][0]["sha256"].get<std::string>().size(), 64u);
}

/// Names of the members of every object in `json`; of maps by scheme, box or index the name of the
/// map and what is below, since their names are data.
void add_keys(const Json& json, std::set<std::string>& keys, bool names_are_data = false) {
  static const std::set<std::string> kMaps = {"classes", "population", "indices", "formulas",
                                              "boxes_m"};
  if (json.is_array()) {
    for (const Json& item : json) add_keys(item, keys);
  }
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    if (!names_are_data) keys.insert(key);
    add_keys(value, keys, !names_are_data && kMaps.count(key) > 0);
  }
}

TEST_F(Talus, EveryKeyOfTheJsonIsDocumented) {
  write_core_library("rock.h5", {{"rock", cuboid(0.5, 0.4, 0.3)}});
  const Json json = json_of({.first = tables({"rock.h5", "east.csv"}),
                             .against = {{"west.csv"}, "", ""},
                             .reading = {.surfaces = true, .roundness_edge = 0.1}});
  std::set<std::string> keys;
  add_keys(json, keys);
  EXPECT_GT(keys.size(), 60u);
  const std::string formats = read_text_file(fs::path(CLAST_SOURCE_DIR) / "docs" / "formats.md");
  const std::size_t begin = formats.find("`clast classify INPUT --json` is an object");
  ASSERT_NE(begin, std::string::npos);
  const std::string section = formats.substr(begin, formats.find("\n## ", begin) - begin);
  for (const std::string& key : keys) {
    EXPECT_NE(section.find("`" + key + "`"), std::string::npos) << key << " is not in formats.md";
  }
  // Names that are data: boxes beside the key, schemes and indices in the theory.
  for (const auto& [box, axes] : json["blocks"][0]["boxes_m"].items()) {
    EXPECT_NE(section.find("`" + box + "`"), std::string::npos) << box;
  }
  const std::string theory =
      read_text_file(fs::path(CLAST_SOURCE_DIR) / "docs" / "theory" / "shape-classes.md");
  for (const auto& [scheme, shares] : json["population"].items()) {
    EXPECT_NE(theory.find("`" + scheme + "`"), std::string::npos) << scheme;
  }
  for (const auto& [index, formula] : json["formulas"].items()) {
    EXPECT_NE(theory.find("`" + index + "`"), std::string::npos) << index;
  }
  EXPECT_EQ(json["population"].size(), scheme_names().size());
}

}  // namespace
}  // namespace clast
