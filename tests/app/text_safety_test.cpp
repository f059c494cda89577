// Text that people and spreadsheets read: tables that are split wrongly, names that a terminal or a
// spreadsheet would obey, numbers that make no sense.
#include "core/files/delimited_text.hpp"
#include "tests/app/command_support.hpp"
#include "tests/app/slope_campaign.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

TEST(TextSafety, TablesWithDecimalCommasBetweenCommasAreRefused) {
  const ScratchFolder folder;
  write_text_file(folder / "talus.csv", "id,L,I,S\nB1,0,9,0,8,0,7\nB2,2,2,1\n");
  expect_refused(folder, {"classify", "talus.csv"}, 1,
                 "talus.csv:2: has 7 fields, but line 1 has 4; where commas are decimal signs");
  write_text_file(folder / "talus.csv", "id;L;I;S\nB1;0,9;0,8;0,7\nB2;2;2;1\n");
  const ProgramRun good = run_clast({"classify", "talus.csv"}, folder.path());
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_TRUE(contains(good.out, "0.9"));
}

const std::string kEsc = "\x1b[31mred", kTurned =
                                            "B\xe2\x80\xae"
                                            "1";

/// No byte that a terminal obeys, apart from line ends.
void expect_tame(const std::string& printed) {
  for (const char c : printed) {
    EXPECT_TRUE(c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f)) << printed;
  }
  EXPECT_EQ(printed.find("\xe2\x80\xae"), std::string::npos) << printed;
}

TEST(TextSafety, NamesReachATerminalEscaped) {
  const ScratchFolder folder;
  write_text_file(folder / "talus.csv",
                  "id,L,I,S\n" + kEsc + ",3,2,1\n\"" + kTurned + "\",3,2,1\nB3,1,2,0\n");
  const ProgramRun table = run_clast({"classify", "talus.csv"}, folder.path());
  ASSERT_EQ(table.exit_code, 0) << table.err;
  expect_tame(table.out);
  expect_tame(table.err);
  EXPECT_TRUE(contains(table.out, "\\u001b[31mred") && contains(table.out, "B\\u202e1"));
  // Names of files, in refusals and in what is said of their content.
  const std::string file = "t\r\x1b[2J\nclast: done.csv";
  write_text_file(folder / file, "L,I,S\n3,2,1\n1,2,3\n");
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"classify", file},
                                                    {"classify", "none" + file},
                                                    {"classify", file, "--columns", "L=" + kEsc},
                                                    {"show", file},
                                                    {kEsc}}) {
    const ProgramRun run = run_clast(arguments, folder.path());
    expect_tame(run.out);
    expect_tame(run.err);
    EXPECT_EQ(("\n" + run.err).find("\nclast: done"), std::string::npos) << run.err;
  }
}

TEST(TextSafety, BlocksOfAnyNameReachATerminalEscaped) {
  const ScratchFolder folder;
  const std::string name = "B\x1b[31m\n7";
  write_obj(folder / (name + ".obj"), box_mesh({1.0, 0.8, 0.6}));
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"reconstruct", name + ".obj", "-o", "b.h5"},
        {"show", "b.h5"},
        {"show", "b.h5", name},
        {"classify", "b.h5"},
        {"library", "set", "b.h5", name, "--note", kEsc},
        {"show", "b.h5", name},
        {"export", "b.h5", "-o", kEsc},
        {"show", "b.h5", "none" + kEsc},
        {"library", "remove", "b.h5", name}}) {
    const ProgramRun run = run_clast(arguments, folder.path());
    expect_tame(run.out);
    expect_tame(run.err);
  }
}

TEST(TextSafety, CellsThatASpreadsheetWouldRunAreTextAndComeBack) {
  const ScratchFolder folder;
  write_text_file(folder / "talus.csv", "id;L;I;S\n=1+1;3;2;1\n@SUM(A1);3;2;1\n-B7;4;3;2\n");
  ASSERT_EQ(run_clast({"classify", "talus.csv", "-o", "out"}, folder.path()).exit_code, 0);
  const std::string classes = read_text_file(folder / "out" / "classes.csv");
  for (const char* cell : {",\"'=1+1\",", ",\"'@SUM(A1)\",", ",\"'-B7\","}) {
    EXPECT_TRUE(contains(classes, cell));
  }
  DelimitedTextReader text(classes, "classes.csv");
  Record record;
  std::vector<std::string> names;
  while (text.read_record(record)) names.emplace_back(record.fields.at(1));
  EXPECT_EQ(names, (std::vector<std::string>{"block", "=1+1", "@SUM(A1)", "-B7"}));
  ASSERT_EQ(run_clast({"classify", "out/classes.csv", "-o", "again"}, folder.path()).exit_code, 0);
  const std::string again = read_text_file(folder / "again" / "classes.csv");
  EXPECT_TRUE(contains(again, ",\"'=1+1\",") && contains(again, ",\"'-B7\","));
}

TEST(TextSafety, ReleasePointsOfTheGroundAreReadAsThoseOfACampaign) {
  const ScratchFolder folder;
  write_obj(folder / "g.obj",
            TriangleMesh{{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, {{0, 1, 2}, {0, 2, 3}}});
  write_text_file(folder / "p.csv", "x;y;z\n4,5;4,5;3\n");
  EXPECT_EQ(run_clast({"terrain", "g.obj", "--release", "p.csv"}, folder.path()).exit_code, 0);
  write_text_file(folder / "p.csv", "x,y,z\n4,5,4,5,3,0\n");
  expect_refused(folder, {"terrain", "g.obj", "--release", "p.csv", "-o", "o.h5"}, 1,
                 "p.csv:2: 6 numbers; where commas are decimal signs");
  write_text_file(folder / "bad.csv", "x,y,z\n1,5,2,5,3,5\n4,5,5,5,6,5\n");
  expect_refused(folder, {"terrain", "bad.csv", "-o", "o.h5"}, 1,
                 "line 2: has 6 fields, but line 1 has 3; where commas are decimal signs");
}

// Across the way down, as wide as the slope.
TEST_F(SlopeCampaign, ARingCountsEntriesAndExits) {
  const std::string campaign = slope_campaign();
  const std::size_t at = campaign.find("[run]");
  for (const char* line : {"[[14, -9], [14, 9], [12, 9], [12, -9], [14, -9]]",
                           "[[14, -9], [12, -9], [12, 9], [14, 9], [14, -9]]"}) {
    std::string text = campaign;
    text.insert(at, std::string("[[barrier]]\nname = \"ring\"\nthrough = ") + line + "\n");
    write_text_file(folder / "ring.toml", text);
    ASSERT_EQ(
        run_clast({"simulate", "ring.toml", "-o", "r.h5", "--replace"}, folder.path()).exit_code,
        0);
    ASSERT_EQ(run_clast({"compare", "r.h5", "-o", "out", "--replace"}, folder.path()).exit_code, 0);
    const std::string crossings = read_text_file(folder / "out" / "crossings.csv");
    EXPECT_TRUE(contains(crossings, ",ring (in),in,1,"));
    EXPECT_TRUE(contains(crossings, ",ring (out),out,1,"));
    EXPECT_EQ(crossings.find("ring (in),out"), std::string::npos);
    const std::string barriers = read_text_file(folder / "out" / "barriers.csv");
    EXPECT_TRUE(contains(barriers, "\nring (in),all,") && contains(barriers, "\nring (out),all,"));
  }
}

}  // namespace
}  // namespace clast
