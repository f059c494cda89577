// clast classify on tables: populations, comparison, report.
#include <nlohmann/json.hpp>

#include "tests/app/command_support.hpp"
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

  expect_refused(folder, {"classify", "talus.csv", "--erdogan-limit", "0.9"}, 2, "erdogan_limit");
  expect_refused(folder, {"classify", "talus.csv", "--axis-error", "-1"}, 2, "--axis-error");
  expect_refused(folder, {"classify", "talus.csv", "--against", "none.csv"}, 1, "none.csv");
}

TEST(Tables, ATableOfAxesHasNoBoxToChoose) {
  const ScratchFolder folder;
  write_text_file(folder / "talus.csv", "L,I,S\n3,2,1\n");
  expect_refused(folder, {"classify", "talus.csv", "--box", "feret"}, 2, "talus.csv");
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
