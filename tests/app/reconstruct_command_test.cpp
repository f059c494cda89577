// clast reconstruct: scans of all kinds, judged by exit code, output and library.
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/app/command_support.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/cut_mesh.hpp"
#include "tests/support/rocks_on_ground.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

class Scans : public testing::Test {
 protected:
  ScratchFolder folder;
};

TEST_F(Scans, AnOpenScanGivesABlockThatSaysWhatIsNotKnown) {
  const TriangleMesh whole = noisy_ellipsoid(3, {0.5, 0.4, 0.3});
  write_obj(folder / "open.obj", above_level(whole, -0.2101));
  const ProgramRun run = run_clast(
      {"reconstruct", "open.obj", "--vertices", "80", "--density", "2500"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "of the surface was not scanned but filled in; volume between"));
  const ProgramRun shown = run_clast({"show", "blocks.h5", "--json"}, folder.path());
  const Json block = Json::parse(shown.out)[0];
  const Json& unseen = block["unseen"];
  EXPECT_LT(unseen["volume_lower_m3"], unseen["volume_best_m3"]);
  EXPECT_LT(unseen["volume_best_m3"], unseen["volume_upper_m3"]);
  const double best = unseen["volume_best_m3"], made = block["volume_m3"];
  EXPECT_NEAR(made, best, 1e-3 * best);
  EXPECT_DOUBLE_EQ(unseen["mass_upper_kg"], 2500.0 * unseen["volume_upper_m3"].get<double>());
  EXPECT_GT(unseen["invented_share"], 0.05);
  EXPECT_LE(unseen["s_c_lower"], block["s_c"]);
  EXPECT_GE(unseen["s_c_upper"], block["s_c"]);
  EXPECT_GE(unseen["zingg"].size(), 1u);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(unseen["axes_lower_m"][axis], block["box_m"][axis]);
    EXPECT_GE(unseen["axes_upper_m"][axis], block["box_m"][axis]);
  }
  EXPECT_TRUE(contains(unseen["assumption"].get<std::string>(), "planes of the observed flanks"));
  const ProgramRun full = run_clast({"show", "blocks.h5", "open"}, folder.path());
  EXPECT_TRUE(contains(full.out, "surface filled in %")) << full.out;
  EXPECT_TRUE(contains(full.out, "mass kg")) << full.out;
}

TEST_F(Scans, BlocksOnAGroundAreSplitAndNumbered) {
  write_obj(folder / "scene.obj", two_rocks_on_ground());
  const ProgramRun run = run_clast(
      {"reconstruct", "scene.obj", "--split", "--vertices", "60", "--json"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json blocks = Json::parse(run.out)["blocks"];
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0]["id"], "scene_1");
  EXPECT_EQ(blocks[1]["id"], "scene_2");
  EXPECT_LT(blocks[0]["centre_m"][0], 0.0);
  EXPECT_GT(blocks[1]["centre_m"][0], 0.0);
  expect_refused(folder, {"reconstruct", "scene.obj", "--ground", "none"}, 1, "scene.obj");
}

TEST_F(Scans, ASizeNoBlockHasIsRefusedWithTheLikelyUnit) {
  write_obj(folder / "mm.obj", cuboid(620, 500, 400));
  expect_refused(folder, {"reconstruct", "mm.obj"}, 1,
                 "block mm would be 620 m long, read with --units m; it is probably in mm: try "
                 "--units mm, which makes it 0.620 m; --any-size accepts it");
  const ProgramRun run =
      run_clast({"reconstruct", "mm.obj", "--units", "mm", "--json"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json block = Json::parse(run.out)["blocks"][0];
  EXPECT_NEAR(block["volume_m3"], 0.62 * 0.5 * 0.4, 1e-4 * 0.124);
}

TEST_F(Scans, ASmallHoleIsClosedAndSaid) {
  TriangleMesh mesh = noisy_ellipsoid(4, {0.5, 0.4, 0.3});
  mesh.triangles.pop_back();
  write_obj(folder / "hole.obj", mesh);
  const ProgramRun run = run_clast({"reconstruct", "hole.obj"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "note: ") && contains(run.out, "hole")) << run.out;
}

TEST_F(Scans, AnOpenScanIsABlockThatSaysWhatWasInventedButNoCore) {
  TriangleMesh open = noisy_ellipsoid(3, {0.5, 0.4, 0.3});
  open.triangles.resize(open.triangles.size() - 40);
  write_obj(folder / "open.obj", open);
  const std::vector<std::string> core = {"reconstruct", "open.obj", "--core", "--radius", "0.01"};
  expect_refused(folder, core, 1, "open.obj: the surface is not closed: ");
  expect_refused(folder, core, 1, " m in perimeter near (");
  const ProgramRun run = run_clast({"reconstruct", "open.obj"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "the scan was open: "));
  EXPECT_TRUE(
      contains(run.out, " % of the surface was not scanned but filled in; volume between "));
  const ProgramRun shown = run_clast({"show", "blocks.h5", "open", "--json"}, folder.path());
  const double share = Json::parse(shown.out)[0]["unseen"]["invented_share"];
  EXPECT_TRUE(0.01 < share && share < 0.2) << share;
}

TEST_F(Scans, ALengthThatWasMeasuredSetsTheScale) {
  write_obj(folder / "box.obj", cuboid(20, 10, 10));
  const auto volume = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"reconstruct", "box.obj", "--json", "--replace"});
    const ProgramRun run = run_clast(options, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return double(Json::parse(run.out)["blocks"][0]["volume_m3"]);
  };
  // Corners of the short side, 10 units apart, are 0.3 m apart: a unit is 3 cm.
  const double expected = 2000.0 * std::pow(0.03, 3);
  EXPECT_NEAR(volume({"--scale-length", "0,0,0;0,10,0;0.3"}) / expected, 1.0, 2e-4);
  EXPECT_NEAR(volume({"--scale-length", "1,0,0,1,6,8,0.3"}) / expected, 1.0, 2e-4);
  EXPECT_NEAR(volume({"--units", "cm", "--scale-factor", "3"}) / expected, 1.0, 2e-4);
  const ProgramRun shown = run_clast({"show", "blocks.h5", "box"}, folder.path());
  EXPECT_TRUE(contains(shown.out, "units=cm scale_factor=3 "));
  expect_refused(folder,
                 {"reconstruct", "box.obj", "-o", "n.h5", "--scale-length", "0,0,0;0,10,0;100"}, 1,
                 "block box would be 200 m long, scaled by --scale-length: check its two points "
                 "and its length; --any-size accepts it");
}

TEST_F(Scans, BlocksBeyondTheUsualSizesAreTakenOnRequestOnly) {
  write_obj(folder / "long.obj", cuboid(21, 1, 1));
  write_obj(folder / "heavy.obj", cuboid(18, 17, 16));
  expect_refused(folder, {"reconstruct", "long.obj", "-o", "n.h5"}, 1,
                 "block long would be 21.0 m long, read with --units m");
  expect_refused(folder, {"reconstruct", "heavy.obj", "-o", "n.h5", "--density", "2500"}, 1,
                 "t heavy, but blocks are rarely heavier than 10000 t");
  EXPECT_EQ(
      run_clast({"reconstruct", "long.obj", "heavy.obj", "-o", "n.h5", "--any-size"}, folder.path())
          .exit_code,
      0);
}

TEST_F(Scans, AnOutputThatCantBeWrittenIsRefused) {
  write_obj(folder / "cube.obj", cuboid(1, 0.9, 0.8));
  fs::create_directory(folder / "folder.h5");
  expect_refused(folder, {"reconstruct", "cube.obj", "-o", "folder.h5"}, 1, "folder.h5");
  const std::vector<std::string> nowhere = {"reconstruct", "cube.obj", "-o", "cube.obj/blocks.h5"};
  expect_refused(folder, nowhere, 1, "cube.obj");
  EXPECT_EQ(run_clast(nowhere, folder.path()).out, "") << "before any block is made";
}

TEST_F(Scans, OptionsReachTheBlock) {
  write_obj(folder / "cube.obj", cuboid(1, 0.9, 0.8));
  const auto made = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"reconstruct", "cube.obj", "--json", "--replace"});
    const ProgramRun run = run_clast(options, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(run.out)["blocks"][0];
  };
  const Json block = made({"--radius", "0.03", "--density", "2650", "--mass", "1500", "--convex"});
  EXPECT_EQ(block["radius_m"], 0.03);
  EXPECT_TRUE(contains(block["warnings"].dump(), "27.2 % more than the 1500 kg weighed"));
  EXPECT_TRUE(contains(block["warnings"].dump(), "0 % more volume"));
  const Json core = made({"--core", "--radius", "0.1", "--mass", "4000"});
  EXPECT_EQ(core["vertices"], 8);
  EXPECT_EQ(core["mass_kg"], 4000.0);
  const ProgramRun shown = run_clast({"show", "blocks.h5", "cube"}, folder.path());
  EXPECT_TRUE(contains(shown.out, "core=yes")) << shown.out;
}

TEST_F(Scans, TheSameScanGivesTheSameLibrary) {
  write_obj(folder / "rock.obj", noisy_ellipsoid(8, {0.5, 0.4, 0.3}));
  for (const char* name : {"a.h5", "b.h5"}) {
    ASSERT_EQ(run_clast({"reconstruct", "rock.obj", "-o", name}, folder.path()).exit_code, 0);
  }
  EXPECT_EQ(read_text_file(folder / "a.h5"), read_text_file(folder / "b.h5"));
}

}  // namespace
}  // namespace clast
