// clast classify on tables: populations, comparison, report.
#include <nlohmann/json.hpp>

#include "classify/schemes.hpp"
#include "core/utf8.hpp"
#include "tests/app/command_support.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/markup.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

/// Two talus tables in centimetres with masses, the second more elongated.
class Talus : public testing::Test {
 protected:
  void SetUp() override {
    write_text_file(folder / "east.csv",
                    "id;L_cm;I_cm;S_cm;mass_kg\r\nE1;65,5;53;38;310\r\nE2;80;75;60;850\r\n"
                    "E3;40;38;30;\r\nE4;70;60;20;200\r\nE5;90;80;0;500\r\n");
    write_text_file(
        folder / "west.csv",
        "id;L_cm;I_cm;S_cm;mass_kg\nW1;90;50;40;400\nW2;50;100;45;500\nW3;70;40;38;250\n");
  }
  Json json_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "classify");
    arguments.push_back("--json");
    const ProgramRun run = run_clast(arguments, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    err = run.err;
    return Json::parse(run.out);
  }

  ScratchFolder folder;
  std::string err;
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
  for (const char* part : {"row 6 skipped", "row 4: mass is missing", "4 rows used, 1 skipped"}) {
    EXPECT_TRUE(contains(err, part));
  }
}

TEST_F(Talus, SeveralTablesAreOnePopulation) {
  const Json json = json_of({"east.csv", "west.csv"});
  EXPECT_EQ(json["blocks"].size(), 7u);
  EXPECT_EQ(json["name"], "east + west");
  write_text_file(folder / "a.txt", "3 2 1\n");
  write_text_file(folder / "b.txt", "3 2 1\n");
  const Json bare = json_of({"a.txt", "b.txt", "--columns", "L=1,I=2,S=3"});
  EXPECT_EQ(bare["blocks"][0]["id"], "a row 1");
  EXPECT_EQ(bare["blocks"][1]["id"], "b row 1");
}

TEST_F(Talus, ComparesTwoPopulations) {
  const Json json = json_of({"east.csv", "--against", "west.csv"});
  EXPECT_EQ(json["against"]["blocks"].size(), 3u);
  EXPECT_EQ(json["comparison"]["a"], "east");
  const Json& s_c = json["comparison"]["measures"][0];
  // s_c: 0.236 0.067 0.053 0.167 against 0.8 1.0 0.75: no overlap, 2 of the 35 deals.
  EXPECT_EQ(s_c["measure"], "s_c");
  EXPECT_EQ(s_c["ks_distance"], 1.0);
  EXPECT_NEAR(s_c["p_value"], 2.0 / 35.0, 1e-12);
  EXPECT_EQ(json["comparison"]["schemes"].size(), json["population"].size());
  const ProgramRun text =
      run_clast({"classify", "east.csv", "--against", "west.csv"}, folder.path());
  EXPECT_TRUE(contains(text.out, "east against west"));
  EXPECT_TRUE(contains(text.out, "No difference in s_c"));
}

TEST_F(Talus, ASecondPopulationMayHaveItsOwnColumnsAndUnit) {
  write_text_file(folder / "north.txt", "1 0.9 0.8 0.7\n2 0.6 0.5 0.4\n");
  const Json json = json_of({"east.csv", "--against", "north.txt", "--against-columns",
                             "L=2,I=3,S=4,name=1", "--against-units", "m"});
  EXPECT_NEAR(json["against"]["blocks"][0]["box_m"][0], 0.9, 1e-12);
  EXPECT_EQ(json["against"]["blocks"][1]["id"], "2");
}

TEST_F(Talus, WritesAReportThatNeedsNothingElse) {
  const ProgramRun run = run_clast({"classify", "east.csv", "-o", "out"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "report.html"));
  const std::string html = read_text_file(folder / "out" / "report.html");
  EXPECT_EQ(unbalanced(html), "");
  expect_self_contained(html);
  EXPECT_TRUE(contains(html, "E2") && contains(html, "row 6 skipped"));
  for (const char* name : {"classes.csv", "sneed_folk.svg", "zingg.svg", "s_c.svg", "size.svg"}) {
    EXPECT_TRUE(names_in(folder / "out").count(name)) << name;
  }
  // The same input gives the same bytes.
  run_clast({"classify", "east.csv", "-o", "again"}, folder.path());
  EXPECT_EQ(read_text_file(folder / "again" / "report.html"), html);
}

TEST_F(Talus, SizeMayBeTheMeanAxis) {
  const Json json = json_of({"east.csv", "--size", "mean"});
  EXPECT_EQ(json["size"]["size"], "(L I S)^(1/3)");
  expect_refused(folder, {"classify", "east.csv", "--size", "L"}, 2, "--size");
}

TEST_F(Talus, WhatCantBeUsedIsRefused) {
  expect_refused(folder, {"classify", "east.csv", "--columns", "L=1,weight=2"}, 2, "weight=2");
  expect_refused(folder, {"classify", "east.csv", "--columns", "mass=kilos"}, 1, "kilos");
  expect_refused(folder, {"classify", "east.csv", "--against", "south.csv"}, 1, "south.csv");
  expect_refused(folder, {"classify", "east.csv", "-o", "west.csv"}, 1, "west.csv");
}

TEST(Tables, ClassifyReadsTapedAxesInTheirUnit) {
  const ScratchFolder folder;
  // The two blocks of a teaching sheet: CB and VP after Sneed & Folk.
  write_text_file(folder / "talus.csv", "name,litho,a,b,c\none,x,56,49.5,39\ntwo,y,46,36,13\n");
  const ProgramRun run =
      run_clast({"classify", "talus.csv", "--columns", "L=3,I=4,S=5", "--units", "cm", "--json"},
                folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json blocks = Json::parse(run.out)["blocks"];
  EXPECT_EQ(blocks[0]["sneed_folk"], "CB");
  EXPECT_EQ(blocks[1]["sneed_folk"], "VP");
  EXPECT_NEAR(blocks[1]["box_m"][0], 0.46, 1e-12);
}

TEST(Tables, ClassifyWeighsSizesAndComparesPopulations) {
  const ScratchFolder folder;
  std::string talus = "L,I,S,kg\n", rods = "L,I,S\n";
  for (int i = 0; i < 20; ++i) {
    const std::string size = std::to_string(1.0 + 0.01 * i);
    talus += size + ",0.9,0.8," + std::to_string(100 + i) + "\n";
    rods += std::to_string(3.0 + 0.01 * i) + ",0.9,0.8\n";
  }
  write_text_file(folder / "talus.csv", talus + "0,1,1,5\n");
  write_text_file(folder / "rods.csv", rods);
  const std::vector<std::string> words = {
      "classify", "talus.csv", "--columns", "L=L,I=I,S=S,mass=kg", "--scheme", "garcia,zingg"};
  const ProgramRun text = run_clast(words, folder.path());
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_TRUE(contains(text.out, "by mass") && contains(text.out, "1 row skipped"));
  EXPECT_TRUE(contains(text.err, "row 22 skipped")) << text.err;

  const ProgramRun other =
      run_clast({"classify", "talus.csv", "--scheme", "garcia", "--against", "rods.csv", "--json"},
                folder.path());
  ASSERT_EQ(other.exit_code, 0) << other.err;
  const Json json = Json::parse(other.out);
  EXPECT_EQ(json["skipped"], 1);
  EXPECT_EQ(json["comparison"]["measures"][0]["ks_distance"], 1.0);
  EXPECT_LT(json["comparison"]["schemes"][0]["p_value"], 1e-6);
  EXPECT_EQ(json["blocks"][0]["axis_error_m"], 0.05);
  EXPECT_EQ(json["box"], "as measured");
  EXPECT_EQ(json["size"]["by_number"]["d50_m"], 0.9);

  expect_refused(folder, {"classify", "talus.csv", "--erdogan-limit", "0.9"}, 2, "--erdogan-limit");
  expect_refused(folder, {"classify", "talus.csv", "--axis-error", "-1"}, 2, "--axis-error");
  expect_refused(folder, {"classify", "talus.csv", "--against", "none.csv"}, 1, "none.csv");
}

TEST(Tables, ATableOfAxesHasNoBoxToChoose) {
  const ScratchFolder folder;
  write_text_file(folder / "talus.csv", "L,I,S\n3,2,1\n");
  expect_refused(folder, {"classify", "talus.csv", "--box", "feret"}, 2, "talus.csv");
}

// What would change nothing, or could mean two things.
TEST_F(Talus, OptionsThatDontApplyAreRefused) {
  expect_refused(folder, {"classify", "a.h5", "--units", "mm"}, 2, "--units");
  expect_refused(folder, {"classify", "a.h5", "--columns", "L=1,I=2,S=3"}, 2, "--columns");
  expect_refused(folder, {"classify", "a.h5", "--against", "b.h5", "--against-units", "mm"}, 2,
                 "--against-units");
  expect_refused(folder, {"classify", "east.csv", "--against-columns", "L=1"}, 2,
                 "--against-columns");
  expect_refused(folder, {"classify", "a.h5", "--roundness", "0.1"}, 2, "--json");
  expect_refused(folder, {"classify", "east.csv", "--roundness", "0.1", "--json"}, 2, "library");
  expect_refused(folder, {"classify", "east.csv", "--erdogan-limit", "1.5"}, 2, "erdogan");
  expect_refused(folder, {"classify", "east.csv", "--thirds", "--scheme", "zingg"}, 2,
                 "sneed-folk");
  expect_refused(folder, {"classify", "east.csv", "--scheme", "zingg,garcia,zingg"}, 2,
                 "zingg more than once");
  expect_refused(folder, {"classify", "east.csv", "-o", ""}, 2, "--output");
  expect_refused(folder, {"classify", "east.csv", "--units", ""}, 2, "--units");
  // Where one of the inputs is a table they do apply.
  EXPECT_EQ(run_clast({"classify", "east.csv", "--units", "cm"}, folder.path()).exit_code, 0);
}

TEST_F(Talus, NumbersThatAreNoneAreRefused) {
  for (const char* number : {"nan", "-inf", "x"}) {
    expect_refused(folder, {"classify", "east.csv", "--axis-error", number}, 2, "--axis-error");
    expect_refused(folder,
                   {"classify", "east.csv", "--scheme", "erdogan", "--erdogan-limit", number}, 2,
                   "erdogan");
    expect_refused(folder, {"classify", "a.h5", "--json", "--roundness", number}, 2, "--roundness");
    expect_refused(folder, {"classify", "east.csv", "--seed", number}, 2, "--seed");
    expect_refused(folder, {"classify", "east.csv", "--units", number}, 2, "--units");
  }
  for (const char* number : {"-1", "1.5", "18446744073709551616"}) {
    expect_refused(folder, {"classify", "east.csv", "--seed", number}, 2, "--seed");
  }
}

TEST_F(Talus, AColumnIsOneQuantity) {
  expect_refused(folder, {"classify", "east.csv", "--columns", "L=1,I=1,S=3"}, 2, "L and as I");
  expect_refused(folder, {"classify", "east.csv", "--columns", "L=1,L=2"}, 2, "column 2");
  expect_refused(folder, {"classify", "east.csv", "--columns", "L=L_cm,I=2,S=S_cm"}, 1,
                 "L and as I");
  write_text_file(folder / "twice.csv", "L,I,S,L\n3,2,1,4\n");
  expect_refused(folder, {"classify", "twice.csv"}, 1, "1, 4");
}

TEST_F(Talus, BlocksThatAreCountedTwiceAreTold) {
  const Json twice = json_of({"east.csv", "east.csv"});
  EXPECT_EQ(twice["blocks"].size(), 8u);
  EXPECT_TRUE(contains(err, "the same file was given 2 times") && contains(err, "counted 2 times"));
  EXPECT_TRUE(contains(twice["notes"].dump(), "counted 2 times"));
  // By content, whatever the name.
  fs::copy_file(folder / "east.csv", folder / "copy.csv");
  EXPECT_TRUE(contains(json_of({"east.csv", "copy.csv"})["notes"].dump(), "east.csv, copy.csv"));
  EXPECT_TRUE(contains(json_of({"east.csv", "--against", "copy.csv"})["against"]["notes"].dump(),
                       "both populations hold the same file"));
  write_text_file(folder / "a.csv", "id,L,I,S\nA,3,2,1\nA,3,2,1\nB,3,2,1\nA,3,2,1\n");
  EXPECT_TRUE(contains(json_of({"a.csv"})["notes"].dump(), "A 3 times"));
}

TEST_F(Talus, DoubtfulUnitsAndErrorsAreTold) {
  write_text_file(folder / "cm.csv", "L,I,S\n90,70,50\n");
  EXPECT_TRUE(contains(json_of({"cm.csv"})["notes"].dump(), "0.9 m in cm"));
  EXPECT_TRUE(contains(err, "--units"));
  write_text_file(folder / "pebbles.csv", "L_mm,I_mm,S_mm\n20,15,10\n");
  EXPECT_TRUE(contains(json_of({"pebbles.csv"})["notes"].dump(), "`axis_error`"));
  EXPECT_TRUE(contains(err, "--axis-error"));
  EXPECT_EQ(json_of({"pebbles.csv", "--axis-error", "0.001"})["notes"].size(), 1u);  // the unit
}

// As Excel saves accents: everything written is UTF-8 all the same.
TEST_F(Talus, NamesInLatin1ComeOutAsUtf8) {
  write_text_file(folder / "\xe9t\xe9.csv", "id;L;I;S\nCh\xe2teau;3;2;1\n\xc9tang;3;1;1\n");
  EXPECT_EQ(json_of({"\xe9t\xe9.csv"})["blocks"][1]["id"], "\xc3\x89tang");
  EXPECT_TRUE(contains(err, "Windows-1252"));
  ASSERT_EQ(run_clast({"classify", "\xe9t\xe9.csv", "-o", "out"}, folder.path()).exit_code, 0);
  for (const std::string& name : names_in(folder / "out")) {
    const std::string text = read_text_file(folder / "out" / name);
    EXPECT_TRUE(is_utf8(text)) << name;
  }
  EXPECT_TRUE(contains(read_text_file(folder / "out" / "classes.csv"), "\xc3\xa9t\xc3\xa9,Ch"));
}

TEST_F(Talus, ProvenanceHoldsEveryOption) {
  ASSERT_EQ(run_clast({"classify", "east.csv", "--columns", "L=2,I=3,S=4", "--units", "mm",
                       "--axis-error", "0.001", "--against", "west.csv", "--against-units", "cm",
                       "-o", "out"},
                      folder.path())
                .exit_code,
            0);
  const Json json = Json::parse(read_text_file(folder / "out" / "provenance.json"));
  const Json& east = json["populations"][0];
  EXPECT_EQ(east["columns"], "L=2,I=3,S=4");
  EXPECT_EQ(east["units"], "mm");
  EXPECT_EQ(east["axis_error_m"], 0.001);
  EXPECT_TRUE(east["box"].is_null());
  EXPECT_EQ(json["populations"][1]["units"], "cm");
  EXPECT_EQ(east["inputs"][0]["file"], "east.csv");
  EXPECT_EQ(east["inputs"][0]["sha256"].get<std::string>().size(), 64u);
}

TEST_F(Talus, AnEarlierReportLeavesNoDiagramBehind) {
  run_clast({"classify", "east.csv", "-o", "out"}, folder.path());
  EXPECT_TRUE(names_in(folder / "out").count("size.svg"));
  run_clast({"classify", "east.csv", "--against", "west.csv", "-o", "out", "--replace"},
            folder.path());
  run_clast({"classify", "east.csv", "--against", "west.csv", "-o", "fresh"}, folder.path());
  EXPECT_EQ(names_in(folder / "out"), names_in(folder / "fresh"));
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
  write_obj(folder / "rock.obj", cuboid(0.5, 0.4, 0.3));
  const ProgramRun made = run_clast({"reconstruct", "rock.obj", "-o", "rock.h5"}, folder.path());
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Json json = json_of(
      {"rock.h5", "east.csv", "--against", "west.csv", "--scheme", "all", "--roundness", "0.1"});
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
  const std::string theory = read_text_file(fs::path(CLAST_SOURCE_DIR) / "docs" / "theory.md");
  for (const auto& [scheme, shares] : json["population"].items()) {
    EXPECT_NE(theory.find("`" + scheme + "`"), std::string::npos) << scheme;
  }
  for (const auto& [index, formula] : json["formulas"].items()) {
    EXPECT_NE(theory.find("`" + index + "`"), std::string::npos) << index;
  }
  EXPECT_EQ(json["population"].size(), scheme_names().size());
}

TEST(Tables, TablesThatCantBeReadAreRefused) {
  const ScratchFolder folder;
  write_text_file(folder / "empty.csv", "");
  write_text_file(folder / "other.csv", "name,weight\none,5\n");
  write_text_file(folder / "bad.csv", "L,I,S\nlong,wide,high\n");
  expect_refused(folder, {"classify", "none.csv"}, 1, "none.csv");
  expect_refused(folder, {"classify", "empty.csv"}, 1, "empty.csv");
  expect_refused(folder, {"classify", "other.csv"}, 1, "weight");
  expect_refused(folder, {"classify", "bad.csv"}, 1, "bad.csv");
}

}  // namespace
}  // namespace clast
