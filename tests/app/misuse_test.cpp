// Command lines that make no sense: refused while they are parsed, before any file is read.
//
// The commands run in the process of the test; what a shell sees is tested in the other files.
#include <algorithm>
#include <iostream>
#include <sstream>

#include "app/commands/commands.hpp"
#include "app/program.hpp"
#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/working_folder.hpp"

namespace clast {
namespace {

using Words = std::vector<std::string>;

/// Collects what a stream is given.
class Capture {
 public:
  explicit Capture(std::ostream& stream) : stream_(stream), old_(stream.rdbuf(text_.rdbuf())) {}
  ~Capture() { stream_.rdbuf(old_); }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::ostream& stream_;
  std::streambuf* old_;
};

void add_commands(CLI::App& app) {
  for (const auto add :
       {add_reconstruct_command, add_cut_command, add_vary_command, add_show_command,
        add_classify_command, add_export_command, add_library_command, add_terrain_command,
        add_new_command, add_check_command, add_simulate_command, add_compare_command}) {
    add(app);
  }
}

/// What is said of a misuse; the exit code has to be that of one, and nothing is written.
std::string misuse(Words words) {
  const std::set<std::string> before = names_in(".");
  words.insert(words.begin(), "clast");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  const Capture out(std::cout), err(std::cerr);
  const int code = run_program(static_cast<int>(argv.size()), argv.data(), add_commands);
  EXPECT_EQ(code, 2) << testing::PrintToString(words) << err.text();
  EXPECT_EQ(out.text(), "");
  EXPECT_TRUE(err.text().starts_with("clast: ")) << err.text();
  EXPECT_EQ(names_in("."), before);
  return err.text();
}

void expect_misuse(const Words& words, const std::string& item) {
  EXPECT_TRUE(contains(misuse(words), item)) << testing::PrintToString(words);
}

using Misuse = WorkingFolder;

TEST_F(Misuse, IsRefusedWithTheMistake) {
  expect_misuse({"launch"}, "\"launch\" is not a command");
  expect_misuse({"library", "join"}, "\"join\" is not a command");
  expect_misuse({"show"}, "library is required");
  expect_misuse({"show", "a.h5", "--yaml"}, "--yaml");
  expect_misuse({"library", "set", "a.h5", "B1"}, "--site");
  expect_misuse({"library", "set", "a.h5", "B1", "--taped", "1,2"}, "1,2");
  expect_misuse({"library", "set", "a.h5", "B1", "--taped", "1,0,2"}, "1,0,2");
}

TEST_F(Misuse, OfReconstruct) {
  const auto refuse = [](Words options, const std::string& item) {
    options.insert(options.begin(), {"reconstruct", "a.obj"});
    expect_misuse(options, item);
  };
  refuse({"--units", "parsec"}, "--units: \"parsec\" is not a length unit");
  refuse({"--units", "-1"}, "-1");
  refuse({"--up", "x"}, "--up");
  refuse({"--ground", "flat"}, "--ground");
  refuse({"--split", "--mass", "5"}, "--mass is the mass of a single block, but --split");
  refuse({"b.obj", "--mass", "5"}, "--mass is the mass of a single block, but 2 scans are given");
  refuse({"--edits", "edits.json"}, "--split");
  refuse({"--pose", "top: x=180"}, "--join");
  refuse({"--picked", "picked.csv"}, "--join");
  refuse({"b.obj", "--join", "B017", "--split"}, "--split");
  refuse({"b.obj", "--join", "B017", "--join-folders"}, "--join");
  refuse({"b.obj", "--join", "B017", "--pose", "top"}, "names no scan");
  refuse({"b.obj", "--join", "B017", "--pose", "top: w=3"}, "has no rotation");
  refuse({"--core"}, "--radius");
  refuse({"--radius", "-0.1"}, "-0.1");
  refuse({"--radius", "0.1", "--radius-share", "0.1"}, "--radius-share");
  refuse({"--radius-share", "0.3"}, "0 (sharp edges), or from 1e-06 to 0.25 of S");
  refuse({"--density", "0"}, "--density");
  refuse({"--density", "nan"}, "nan");
  refuse({"--vertices", "3"}, "--vertices");
  refuse({"--tolerance", "0"}, "--tolerance");
  refuse({"--convex", "--core", "--radius", "0.1"}, "--core");
  refuse({"--units", "mm", "--scale-length", "0,0,0;0,10,0;1"}, "--units");
  for (const char* bad : {"0,0,0;0,10,0", "0,0,0;0,0,0;1", "0,0,0;0,10,0;-1", "a,0,0;0,10,0;1"}) {
    refuse({"--scale-length", bad}, "two points of the scan and the metres between them");
  }
  for (const char* bar : {"0,1", "0,1,0", "0,0,1.5", "0.5,1,2", "a,b,c", "0,1,-2", "0,1,2,3"}) {
    refuse({"--scale-bar", bar}, "--scale-bar");
  }
}

TEST_F(Misuse, OfExport) {
  const auto refuse = [](Words options, const std::string& item) {
    options.insert(options.begin(), {"export", "a.h5"});
    expect_misuse(options, item);
  };
  refuse({"--format", "dwg"}, "dwg");
  refuse({"--what", "bones"}, "--what");
  refuse({"--frame", "principal", "--up", "y"}, "--up");
  refuse({"--segments", "0"}, "--segments");
  // Where no skin is written it would change nothing at all.
  for (const Words& other : {Words{"--format", "shp"}, Words{"--format", "ply", "--what", "core"},
                             Words{"--format", "ply", "--what", "surface"}}) {
    Words options = other;
    options.insert(options.end(), {"--segments", "8"});
    refuse(options, "--segments: applies to the rounded skin");
  }
}

TEST_F(Misuse, OfTerrain) {
  write_text_file("ground.obj", "v 0 0 0\n");
  write_text_file("zones.geojson", "{}");
  const auto refuse = [](Words options, const std::string& item) {
    options.insert(options.begin(), {"terrain", "ground.obj"});
    expect_misuse(options, item);
  };
  refuse({"--resolution", "0"}, "--resolution");
  refuse({"--percentile", "105"}, "--percentile");
  refuse({"--barriers", "nets.geojson"}, "--picture");
  refuse({"-o", "t.h5", "--export", "ground.obj"},
         "ground.obj: is an input and would be overwritten");
  refuse({"-o", "t.h5", "--export", "./ground.obj"}, "is an input and would be overwritten");
  refuse({"-o", "ground.obj"}, "--output ground.obj: its name must end in .h5, .hdf5");
  refuse({"-o", "t.txt"}, "its name must end in .h5");
  refuse({"-o", "t.h5", "--export", "t.xyz"}, "--export t.xyz: its name must end in .stl, .ply");
  refuse({"-o", "t.h5", "--picture", "t.png"}, "--picture t.png: its name must end in .svg");
  EXPECT_EQ(read_text_file("ground.obj"), "v 0 0 0\n");
}

TEST_F(Misuse, OfSimulate) {
  for (const std::string shard : {"5/4", "0/4", "1/0", "1", "1/4/2", "a/b", "-1/4"}) {
    expect_misuse({"simulate", "campaign.toml", "--shard", shard}, shard);
  }
  expect_misuse({"simulate"}, "campaign");
  expect_misuse({"simulate", "campaign.toml", "--merge", "a.h5"}, "--merge");
  expect_misuse({"simulate", "a.toml", "--threads", "-1"}, "--threads");
}

TEST_F(Misuse, OfClassify) {
  expect_misuse({"classify", "a.csv", "--scheme", "best"}, "--scheme");
  expect_misuse({"classify", "a.csv", "--columns", "L=1,W=2"}, "--columns: \"W=2\"");
  expect_misuse({"classify", "a.h5", "--box", "best"}, "--box");
  expect_misuse({"classify", "a.csv", "--box", "feret"}, "--box: a.csv is a table");
  expect_misuse({"classify", "a.csv", "--replace"}, "--replace");
  expect_misuse({"classify", "a.csv", "--size", "L"}, "--size");
}

// What would change nothing, or could mean two things.
TEST_F(Misuse, OptionsOfClassifyThatDontApplyAreRefused) {
  expect_misuse({"classify", "a.h5", "--units", "mm"}, "--units");
  expect_misuse({"classify", "a.h5", "--columns", "L=1,I=2,S=3"}, "--columns");
  expect_misuse({"classify", "a.h5", "--against", "b.h5", "--against-units", "mm"},
                "--against-units");
  expect_misuse({"classify", "a.csv", "--against-columns", "L=1"}, "--against-columns");
  expect_misuse({"classify", "a.h5", "--roundness", "0.1"}, "--json");
  expect_misuse({"classify", "a.csv", "--roundness", "0.1", "--json"}, "library");
  expect_misuse({"classify", "a.csv", "--erdogan-limit", "1.5"}, "erdogan");
  expect_misuse({"classify", "a.csv", "--thirds", "--scheme", "zingg"}, "sneed-folk");
  expect_misuse({"classify", "a.csv", "--scheme", "zingg,garcia,zingg"}, "zingg more than once");
  expect_misuse({"classify", "a.csv", "--scheme", ","}, "--scheme: names no scheme");
  expect_misuse({"classify", "a.csv", "-o", ""}, "--output");
  expect_misuse({"classify", "a.csv", "--units", ""}, "--units");
}

/// An option with a number, with VALUE where it stands.
struct NumberOption {
  const char* name;
  const char* value = "VALUE";
};

/// Every one of the options refuses every one of the values, which it repeats, with its range.
void expect_numbers_refused(const Words& before, const std::vector<NumberOption>& options,
                            const std::vector<std::string>& values, bool with_range) {
  for (const NumberOption& option : options) {
    for (const std::string& value : values) {
      Words words = before;
      std::string text = option.value;
      text.replace(text.find("VALUE"), 5, value);
      words.push_back(option.name + std::string("=") + text);
      const std::string said = misuse(words);
      EXPECT_TRUE(contains(said, option.name) && contains(said, value));
      if (!with_range) continue;
      EXPECT_TRUE(contains(said, "from ") && contains(said, " to ")) << value;
    }
  }
}

const Words kNoBlock = {"1e308", "-1e308", "1e-300", "nan", "inf"};

TEST_F(Misuse, NumbersOfTerrainOutsideTheirRangesAreRefusedWithThem) {
  expect_numbers_refused({"terrain", "x.stl", "--release", "p.xyz", "--export", "x.ply"},
                         {{"--resolution"},
                          {"--percentile"},
                          {"--outliers"},
                          {"--fill"},
                          {"--crack"},
                          {"--spikes"},
                          {"--tolerance"},
                          {"--border-distance"},
                          {"--block-size"},
                          {"--export-cell"},
                          {"--smoothing"}},
                         kNoBlock, true);
}

TEST_F(Misuse, NumbersOfReconstructOutsideTheirRangesAreRefusedWithThem) {
  expect_numbers_refused({"reconstruct", "x.stl"},
                         {{"--units"},
                          {"--scale-length", "0,0,0;1,0,0;VALUE"},
                          {"--scale-factor"},
                          {"--radius"},
                          {"--radius-share"},
                          {"--density"},
                          {"--mass"},
                          {"--accuracy"},
                          {"--tolerance"},
                          {"--marker-size"},
                          {"--scale-bar", "0,1,VALUE"},
                          {"--colmap-minutes"},
                          {"--vertices"},
                          {"--jobs"}},
                         kNoBlock, true);
}

TEST_F(Misuse, NumbersOfOtherCommandsOutsideTheirRangesAreRefusedWithThem) {
  expect_numbers_refused(
      {"classify", "x.csv"},
      {{"--seed"}, {"--units"}, {"--axis-error"}, {"--roundness"}, {"--erdogan-limit"}}, kNoBlock,
      true);
  expect_numbers_refused({"cut", "x.ply", "-j", "60/90/1"},
                         {{"--seed"},
                          {"--least-volume"},
                          {"--most-blocks"},
                          {"--density"},
                          {"--radius-share"},
                          {"--units"},
                          {"--threads"},
                          {"--joints", "60/90/VALUE"}},
                         kNoBlock, true);
  expect_numbers_refused({"cut", "--before", "x.asc", "--after", "y.asc", "-j", "60/90/1"},
                         {{"--min-thickness"}, {"--resolution"}}, kNoBlock, true);
  expect_numbers_refused({"cut", "--before", "x.asc", "--after", "y.asc", "-j", "60/90/1"},
                         {{"--bodies"}}, kNoBlock, false);
  expect_numbers_refused({"vary", "x.h5"},
                         {{"--seed"},
                          {"--least"},
                          {"--convexity"},
                          {"--rounding"},
                          {"--vertices"},
                          {"--detail"},
                          {"--degree"},
                          {"--exponent"},
                          {"--draw"},
                          {"--threads"},
                          {"--to", "0.8,VALUE"},
                          {"--grid", "zingg:VALUE"}},
                         kNoBlock, true);
  expect_numbers_refused({"simulate", "x.toml"}, {{"--threads"}}, kNoBlock, true);
  expect_numbers_refused({"compare", "x.h5"}, {{"--animate"}}, kNoBlock, true);
  expect_numbers_refused({"export", "x.h5"}, {{"--segments"}}, kNoBlock, true);
  expect_numbers_refused({"library", "set", "b.h5", "B"},
                         {{"--weighed"}, {"--taped", "1,0.5,VALUE"}}, kNoBlock, true);
}

TEST_F(Misuse, WhatIsNoNumberIsRefused) {
  const Words none = {"nan", "-inf", "x"};
  expect_numbers_refused({"classify", "a.csv"}, {{"--axis-error"}, {"--seed"}, {"--units"}}, none,
                         false);
  expect_numbers_refused({"classify", "a.csv", "--scheme", "erdogan"}, {{"--erdogan-limit"}}, none,
                         false);
  expect_numbers_refused({"classify", "a.h5", "--json"}, {{"--roundness"}}, none, false);
  expect_numbers_refused({"classify", "a.csv"}, {{"--seed"}}, {"-1", "1.5", "18446744073709551616"},
                         false);
  expect_numbers_refused({"classify", "a.csv"}, {{"--erdogan-limit"}}, {"0.9"}, false);
  expect_numbers_refused({"classify", "a.csv"}, {{"--axis-error"}}, {"-1"}, false);
}

}  // namespace
}  // namespace clast
