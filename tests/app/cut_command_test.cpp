// clast cut: from the mesh of a rock mass to a library of its blocks.
#include <nlohmann/json.hpp>

#include "mesh/mesh_io.hpp"
#include "tests/app/command_support.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

class CutCommand : public testing::Test {
 protected:
  void SetUp() override { write_mesh(folder / "scar.ply", mass_); }

  static ProgramRun cut(const ScratchFolder& folder, std::vector<std::string> more = {}) {
    std::vector<std::string> words = {"cut", "scar.ply", "-j", "70/095/1.2/0.3", "-j", "60/200/1"};
    words.insert(words.end(), more.begin(), more.end());
    return run_clast(words, folder.path());
  }

  ScratchFolder folder;
  TriangleMesh mass_ = rock_mesh(6, {2.0, 1.5, 1.2}, 5);
};

TEST_F(CutCommand, WritesALibraryOfTheBlocks) {
  const ProgramRun run = cut(folder, {"-o", "insitu.h5", "--density", "2700", "--prefix", "K"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, " % of the mass of ")) << run.out;
  EXPECT_TRUE(contains(run.out, "insitu.h5: ")) << run.out;
  const Json blocks = Json::parse(run_clast({"show", "insitu.h5", "--json"}, folder.path()).out);
  ASSERT_GT(blocks.size(), 5u);
  double volume = 0.0;
  for (const Json& block : blocks) {
    EXPECT_TRUE(block["id"].get<std::string>().starts_with("K0"));
    EXPECT_EQ(block["density_kg_m3"], 2700.0);
    volume += block["volume_m3"].get<double>();
  }
  EXPECT_LT(volume, signed_volume(mass_));
  EXPECT_GT(volume, 0.85 * signed_volume(mass_));
  // Units and seed reach the cutting; blocks of the same id are kept without --replace.
  EXPECT_TRUE(contains(cut(folder, {"-o", "mm.h5", "--units", "mm", "--least-volume", "1e-12"}).out,
                       "mm.h5: "));
  const ProgramRun again = cut(folder, {"-o", "insitu.h5", "--prefix", "K"});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_TRUE(contains(again.err, "K0001")) << again.err;
  EXPECT_EQ(cut(folder, {"-o", "insitu.h5", "--prefix", "K", "--seed", "2", "--replace"}).exit_code,
            0);
  EXPECT_NE(Json::parse(run_clast({"show", "insitu.h5", "--json"}, folder.path()).out), blocks);
}

// A mass whose triangles face inwards is turned; one that joints hardly cut is warned of.
TEST_F(CutCommand, TurnsTheMassAndSaysWhatIsLost) {
  const ProgramRun outward = cut(folder, {"-o", "a.h5"});
  TriangleMesh turned = mass_;
  for (auto& triangle : turned.triangles) std::swap(triangle[0], triangle[1]);
  write_mesh(folder / "scar.ply", turned, {.rules = {.replace = true}});
  const ProgramRun inward = cut(folder, {"-o", "a.h5", "--replace"});
  EXPECT_EQ(inward.out, outward.out);
  EXPECT_FALSE(contains(outward.err, "is in no block")) << outward.err;
  const ProgramRun coarse =
      run_clast({"cut", "-j", "0/0/50", "scar.ply", "-o", "b.h5"}, folder.path());
  EXPECT_EQ(coarse.exit_code, 0) << coarse.err;
  EXPECT_TRUE(contains(coarse.err, " % of the mass is in no block")) << coarse.err;
}

TEST_F(CutCommand, RefusesWithItemAndNextStep) {
  const auto refused = [&](const std::vector<std::string>& words, int code,
                           const std::string& item) { expect_refused(folder, words, code, item); };
  refused({"cut", "scar.ply", "-j", "70/95"}, 2, "is no joint set; give DIP/DIP_DIRECTION/SPACING");
  refused({"cut", "scar.ply", "-j", "95/95/1"}, 2, "dip = 95; must be from 0 to 90");
  refused({"cut", "scar.ply"}, 2, "--joints is required");
  refused({"cut", "none.ply", "-j", "70/95/1"}, 1, "none.ply");
  refused({"cut", "scar.ply", "-j", "70/95/1", "--prefix", "a/b"}, 2, "a/b");
  refused({"cut", "scar.ply", "-j", "70/95/0.01", "-j", "10/95/0.01", "--least-volume", "1e-9",
           "--most-blocks", "100"},
          1, "scar.ply: the joint sets cut the mass into more than 100 blocks");
  TriangleMesh open = mass_;
  open.triangles.pop_back();
  write_mesh(folder / "open.ply", open);
  refused({"cut", "open.ply", "-j", "70/95/1"}, 1, "open.ply: the mass is not a closed surface");
  write_text_file(folder / "blocks.h5", "no library");
  refused({"cut", "scar.ply", "-j", "70/95/1"}, 1, "blocks.h5");
}

}  // namespace
}  // namespace clast
