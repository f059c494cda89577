// clast vary: from a library to twins and series of its blocks.
#include <nlohmann/json.hpp>

#include "library/block_library.hpp"
#include "library/make_block.hpp"
#include "tests/app/command_support.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

class VaryCommand : public testing::Test {
 protected:
  void SetUp() override {
    BlockLibrary library;
    for (const std::uint64_t seed : {3u, 4u}) {
      const SpheroPolyhedron body =
          make_sphero_polyhedron(rock_mesh(2, Vec3(1.0, 0.8, 0.5), seed, 0.3), 0.02);
      library.add(make_block("R" + std::to_string(seed), body,
                             {"rock.ply", std::string(64, 'a'), "", ""}, {}));
    }
    library.write(folder / "blocks.h5");
  }
  ProgramRun vary(std::vector<std::string> more) const {
    more.insert(more.begin(), {"vary", "blocks.h5"});
    return run_clast(more, folder.path());
  }
  void refused(std::vector<std::string> more, int code, const std::string& item) const {
    more.insert(more.begin(), {"vary", "blocks.h5"});
    expect_refused(folder, more, code, item);
  }
  ScratchFolder folder;
};

TEST_F(VaryCommand, WritesALibraryOfTwins) {
  const ProgramRun run =
      vary({"R3", "--to", "0.8,0.5", "--to", "1,0.3", "--reference", "ellipsoid", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json bodies = Json::parse(run.out)["bodies"];
  ASSERT_EQ(bodies.size(), 3u);
  EXPECT_EQ(bodies[0]["id"], "R3_il0.8_sl0.5");
  EXPECT_EQ(bodies[0]["parent"], "R3");
  EXPECT_EQ(bodies[0]["target_I_over_L"], 0.8);
  EXPECT_NEAR(bodies[0]["I_over_L"].get<double>(), 0.8, 0.004);
  EXPECT_NEAR(bodies[1]["S_over_L"].get<double>(), 0.3, 0.0015);
  EXPECT_EQ(bodies[2]["reference"], "ellipsoid");
  EXPECT_TRUE(bodies[2]["target"].is_null());
  const std::string formats = read_text_file(fs::path(CLAST_SOURCE_DIR) / "docs" / "formats.md");
  for (const auto& [key, value] : bodies[0].items()) {
    EXPECT_TRUE(contains(formats, "`" + key + "`"));
  }
  const Json shown = Json::parse(run_clast({"show", "series.h5", "--json"}, folder.path()).out);
  ASSERT_EQ(shown.size(), 3u);
  const Json parent =
      Json::parse(run_clast({"show", "blocks.h5", "R3", "--json"}, folder.path()).out);
  for (const Json& block : shown) {
    EXPECT_NEAR(block["mass_kg"].get<double>() / parent[0]["mass_kg"].get<double>(), 1.0, 1e-3);
  }
  // Bodies of the same name stay without --replace.
  const std::string before = read_text_file(folder / "series.h5");
  const ProgramRun again = vary({"R3", "--to", "0.8,0.5"});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_TRUE(contains(again.err, "R3_il0.8_sl0.5")) << again.err;
  EXPECT_EQ(read_text_file(folder / "series.h5"), before);
  EXPECT_EQ(vary({"R3", "--to", "0.8,0.5", "--replace"}).exit_code, 0);
}

TEST_F(VaryCommand, MakesWhatItCanAndNamesTheRest) {
  const ProgramRun run = vary({"R3", "--convexity", "0.3", "1"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "block R3: a convexity of 0.3 can't be reached")) << run.err;
  EXPECT_TRUE(contains(run.err, "1 of 2 bodies could not be made")) << run.err;
  EXPECT_TRUE(contains(run.out, "series.h5: 1 body written")) << run.out;
  refused({"R3", "--convexity", "0.3", "-o", "none.h5"}, 1, "no body could be made");
}

TEST_F(VaryCommand, DrawsBodiesFromATableTheSameOnAnyNumberOfThreads) {
  std::string table = "L_cm;I_cm;S_cm\n";
  for (int i = 0; i < 20; ++i) {
    table += std::to_string(80 + 3 * i) + ";" + std::to_string(60 + 2 * ((7 * i) % 20) / 3) + ";" +
             std::to_string(30 + (3 * i) % 11) + "\n";
  }
  write_text_file(folder / "taped.csv", table);
  const std::vector<std::string> words = {"--draw", "6", "--from", "taped.csv", "--seed", "5"};
  std::vector<std::string> one = words, two = words;
  one.insert(one.end(), {"--threads", "1", "-o", "one.h5"});
  two.insert(two.end(), {"--threads", "2", "-o", "two.h5"});
  const ProgramRun run = vary(one);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "rank correlations")) << run.out;
  ASSERT_EQ(vary(two).exit_code, 0);
  EXPECT_EQ(read_text_file(folder / "one.h5"), read_text_file(folder / "two.h5"));
  // Two blocks are no population.
  refused({"--draw", "6", "-o", "none.h5"}, 1, "ten blocks, but there are 2");
}

TEST_F(VaryCommand, ShowsSeriesAsTablesOfPictures) {
  ASSERT_EQ(vary({"R3", "--grid", "sneed-folk:2", "--least", "0.4"}).exit_code, 0);
  ASSERT_EQ(vary({"--convexity", "1", "--reference", "box", "sphere"}).exit_code, 0);
  ASSERT_EQ(run_clast({"show", "series.h5", "--report", "page"}, folder.path()).exit_code, 0);
  const std::string page = read_text_file(folder / "page/gallery.html");
  EXPECT_TRUE(contains(page, "<h2>Forms of R3</h2>"));
  EXPECT_TRUE(contains(page, "<h2>Convexity, increased by filling hollows</h2>"));
  EXPECT_TRUE(contains(page, "<h2>Reference bodies</h2>"));
  std::size_t cells = 0;
  for (std::size_t at = 0; (at = page.find("class=\"cell\"", at)) != page.npos; ++at) ++cells;
  EXPECT_EQ(cells, 6u + 2u + 4u);
  ASSERT_EQ(run_clast({"show", "blocks.h5", "--report", "plain"}, folder.path()).exit_code, 0);
  EXPECT_EQ(read_text_file(folder / "plain/gallery.html").find("class=\"cell\""),
            std::string::npos);
}

TEST_F(VaryCommand, RefusesWhatMakesNoSense) {
  refused({}, 2, "no variation is requested");
  refused({"R3", "--roundness", "1.5"}, 2, "--roundness");
  refused({"R3", "--roundness", "0.99"}, 1, "a roundness of 0.99 can't be reached");
  refused({"--to", "0.5"}, 2, "--to 0.5: give I/L,S/L");
  refused({"--to", "0.5,0.8"}, 2, "S/L at most I/L");
  refused({"--grid", "folk:3"}, 2, "use sneed-folk or zingg");
  refused({"--grid", "zingg"}, 2, "sneed-folk:STEPS or zingg:STEPS");
  refused({"--to", "0.5,0.5", "--draw", "100000"}, 1, "the limit is 100000");
  refused({"--reference", "cone"}, 2, "cone");
  refused({"--from", "x.csv"}, 2, "--draw");
  refused({"--to", "0.5,0.5", "--keep", "weight"}, 2, "weight");
  refused({"--draw", "3", "--prefix", "a/b"}, 2, "a/b");
  refused({"R9", "--to", "0.5,0.5"}, 1, "R9");
  refused({"--like", "R9"}, 1, "R9");
  refused({"R3", "--to", "0.5,0.5", "--to", "0.5,0.5"}, 1, "requested twice");
  refused({"--draw", "3", "--from", "none.csv"}, 1, "none.csv");
  refused({"--draw", "3", "--units", "furlong"}, 2, "furlong");
  write_text_file(folder / "huge.csv", "L,I,S\n100000,3,1\n");
  refused({"--draw", "3", "--from", "huge.csv"}, 1, "L and S must be from 0.0001 to 1000 m");
  write_text_file(folder / "text.h5", "no library");
  expect_refused(folder, {"vary", "text.h5", "--to", "0.5,0.5"}, 1, "text.h5");
  refused({"--to", "0.5,0.5", "-o", "text.h5"}, 1, "text.h5");
  expect_refused(folder, {"vary", "none.h5", "--to", "0.5,0.5"}, 1, "none.h5");
}

}  // namespace
}  // namespace clast
