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
  ScratchFolder folder;
};

TEST_F(Talus, EveryOptionReachesThePopulation) {
  const ProgramRun run = run_clast({"classify",
                                    "east.csv",
                                    "--columns",
                                    "L=2,I=3,S=4",
                                    "--units",
                                    "mm",
                                    "--axis-error",
                                    "0.001",
                                    "--size",
                                    "mean",
                                    "--scheme",
                                    "zingg",
                                    "--against",
                                    "west.csv",
                                    "--against-columns",
                                    "L=L_cm,I=I_cm,S=S_cm,name=3",
                                    "--against-units",
                                    "m",
                                    "--seed",
                                    "7",
                                    "--json"},
                                   folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_NEAR(json["blocks"][0]["box_m"][0], 0.0655, 1e-12);
  EXPECT_EQ(json["blocks"][0]["axis_error_m"], 0.001);
  EXPECT_EQ(json["size"]["size"], "(L I S)^(1/3)");
  EXPECT_EQ(json["population"].size(), 1u);
  EXPECT_NEAR(json["against"]["blocks"][0]["box_m"][0], 90.0, 1e-12);
  EXPECT_EQ(json["against"]["blocks"][0]["id"], "50");
}

TEST_F(Talus, NotesComeInTheWordsOfTheCommandLine) {
  write_text_file(folder / "cm.csv", "L,I,S\n90,70,50\n0,1,1\n");
  const ProgramRun run =
      run_clast({"classify", "cm.csv", "--axis-error", "60", "--scheme", "garcia"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "cm.csv: axes were read in metres"));
  EXPECT_TRUE(contains(run.err, "as --units") && contains(run.err, "as --axis-error"));
  EXPECT_TRUE(contains(run.out, "1 row skipped")) << run.out;
  expect_refused(folder, {"classify", "east.csv", "--against", "south.csv"}, 1, "south.csv");
  expect_refused(folder, {"classify", "east.csv", "-o", "west.csv"}, 1, "west.csv");
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

TEST_F(Talus, AnEarlierReportLeavesNoDiagramBehind) {
  run_clast({"classify", "east.csv", "-o", "out"}, folder.path());
  EXPECT_TRUE(names_in(folder / "out").count("size.svg"));
  run_clast({"classify", "east.csv", "--against", "west.csv", "-o", "out", "--replace"},
            folder.path());
  run_clast({"classify", "east.csv", "--against", "west.csv", "-o", "fresh"}, folder.path());
  EXPECT_EQ(names_in(folder / "out"), names_in(folder / "fresh"));
}

}  // namespace
}  // namespace clast
