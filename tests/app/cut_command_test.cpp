// clast cut: from the mesh of a rock mass to a library of its blocks.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "mesh/mesh_io.hpp"
#include "mesh/mesh_topology.hpp"
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
  refused({"cut", "scar.ply", "-j", "70/95"}, 2,
          "is not a joint set; give DIP/DIP_DIRECTION/SPACING");
  refused({"cut", "scar.ply", "-j", "95/95/1"}, 2, "dip = 95; must be from 0 to 90");
  refused({"cut", "scar.ply"}, 2, "--joints is required");
  refused({"cut", "-j", "70/95/1"}, 2, "give a closed mesh of the mass, or --before and --after");
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

/// A made quarry, a bench 12 m high with a slope of 45 degrees, on a grid of 0.5 m; before, a
/// rounded nose of 3 m stood out of it.
class CutBetweenTerrains : public testing::Test {
 protected:
  void SetUp() override {
    write("before.asc", true, 651000.0);
    write("after.asc", false, 651000.0);
    write("elsewhere.asc", false, 652000.0);
  }

  void write(const std::string& name, bool nose, double west) const {
    std::ofstream file(folder / name);
    file << "ncols 80\nnrows 60\nxllcorner " << std::fixed << west
         << "\nyllcorner 5200000\ncellsize 0.5\nNODATA_value -9999\n";
    for (int row = 59; row >= 0; --row) {
      for (int column = 0; column < 80; ++column) {
        const double x = 0.5 * (column + 0.5), y = 0.5 * (row + 0.5);
        const double ground = 100.0 + std::clamp(22.0 - x, 0.0, 12.0);
        const double u = (std::pow(x - 14.0, 2) + std::pow(y - 15.0, 2)) / 36.0;
        file << ground + (nose ? std::max(0.0, 3.0 * (1.0 - u)) : 0.0) << ' ';
      }
      file << '\n';
    }
  }

  const ScratchFolder folder;
  const std::vector<std::string> between_ = {"cut", "--before", "before.asc", "--after",
                                             "after.asc"};
  std::vector<std::string> with(std::vector<std::string> more) const {
    more.insert(more.begin(), between_.begin(), between_.end());
    return more;
  }
};

TEST_F(CutBetweenTerrains, TheBlocksAreReleasedInPlaceOnTheTerrainAfter) {
  const ProgramRun run = run_clast(with({"--scar", "scar.ply", "-j", "45/90/1.5", "-j", "80/0/1.5",
                                         "-j", "60/270/1.5", "-o", "insitu.h5"}),
                                   folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "in 1 body; left out: none")) << run.out;
  EXPECT_TRUE(contains(run.out, "edges of the surfaces, median: ")) << run.out;
  const TriangleMesh scar = read_mesh(folder / "scar.ply");
  EXPECT_TRUE(inspect_mesh(scar).is_closed());
  // A paraboloid, without what is thinner than 0.1 m.
  const double volume = 0.5 * std::numbers::pi * 36.0 * 3.0 * (1.0 - std::pow(0.1 / 3.0, 2));
  EXPECT_NEAR(signed_volume(scar) / volume, 1.0, 5e-3);
  const auto planned_on = [&](const std::string& terrain) {
    write_text_file(folder / "campaign.toml",
                    "[blocks]\nlibrary = \"insitu.h5\"\n[terrain]\nsurface = [\"" + terrain +
                        "\"]\n[ground.ground]\nenergy_restitution = 0.01\nfriction = 0.7\n"
                        "rolling_friction = 0.2\n[[mass]]\nin_place = true\n"
                        "[contact.blocks]\nenergy_restitution = 0.01\nfriction = 0.7\n"
                        "rolling_friction = 0.2\n[run]\nmax_time_s = 5\n");
    return run_clast({"simulate", "campaign.toml", "--dry-run"}, folder.path());
  };
  const ProgramRun plan = planned_on("after.asc");
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_TRUE(contains(plan.out, "in place")) << plan.out;
  // On the terrain before, they lie in the ground.
  const ProgramRun wrong = planned_on("before.asc");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_TRUE(contains(wrong.err, "the terrain must be the one without the mass")) << wrong.err;
}

TEST_F(CutBetweenTerrains, WithoutJointsTheMassAloneIsWritten) {
  const ProgramRun run = run_clast(with({"--scar", "scar.stl"}), folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(fs::exists(folder / "scar.stl"));
  EXPECT_FALSE(fs::exists(folder / "blocks.h5"));
  const ProgramRun again = run_clast(with({"--scar", "scar.stl"}), folder.path());
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_EQ(run_clast(with({"--scar", "scar.stl", "--replace"}), folder.path()).exit_code, 0);
}

TEST_F(CutBetweenTerrains, RefusesWithItemAndNextStep) {
  const auto refused = [&](const std::vector<std::string>& words, int code,
                           const std::string& item) { expect_refused(folder, words, code, item); };
  refused(between_, 2, "--joints is required");
  refused(with({"-j", "70/95/1", "scar.ply"}), 2, "mass");
  refused({"cut", "--before", "before.asc", "-j", "70/95/1"}, 2, "--before requires --after");
  refused({"cut", "scar.ply", "--scar", "a.ply", "-j", "70/95/1"}, 2, "--scar requires --before");
  refused(with({"--scar", "after.asc"}), 2, "after.asc: is an input and would be overwritten");
  refused(with({"--scar", "scar.tif"}), 2, "its name must end in .glb, .obj, .ply, .stl, .vtp");
  refused(with({"-j", "70/95/1", "--bodies", "none"}), 2, "--bodies = \"none\": must be largest");
  refused(with({"-j", "70/95/1", "--bodies", "2"}), 1, "--bodies = 2: there is 1 body");
  refused(with({"-j", "70/95/1", "--min-thickness", "4"}), 1, "give a smaller --min-thickness");
  refused({"cut", "--before", "after.asc", "--after", "before.asc", "-j", "70/95/1"}, 1,
          "check that the two are not swapped");
  refused({"cut", "--before", "before.asc", "--after", "elsewhere.asc", "-j", "70/95/1"}, 1,
          "--before and --after do not overlap");
  refused({"cut", "--before", "before.asc", "--after", "none.asc", "-j", "70/95/1"}, 1, "none.asc");
  std::string empty = read_text_file(folder / "after.asc");
  empty.resize(empty.find("-9999") + 6);
  for (int i = 0; i < 80 * 60; ++i) empty += "-9999 ";
  write_text_file(folder / "empty.asc", empty);
  refused({"cut", "--before", "before.asc", "--after", "empty.asc", "-j", "70/95/1"}, 1,
          "empty.asc");
  write_text_file(folder / "nan.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n");
  refused({"cut", "--before", "before.asc", "--after", "nan.obj", "-j", "70/95/1"}, 1, "nan.obj");
}

}  // namespace
}  // namespace clast
