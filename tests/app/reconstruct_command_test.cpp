// clast reconstruct: scans of all kinds, judged by exit code, output and library.
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "shapes/convex_hull.hpp"
#include "tests/app/command_support.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/cut_mesh.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

/// A level square of so many cells a side.
TriangleMesh grid(std::uint32_t cells, double half) {
  TriangleMesh mesh;
  const double step = 2.0 * half / cells;
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i) {
      mesh.vertices.emplace_back(step * i - half, step * j - half, 0.0);
    }
  }
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = (cells + 1) * j + i;
      mesh.triangles.push_back({a, a + 1, a + cells + 2});
      mesh.triangles.push_back({a, a + cells + 2, a + cells + 1});
    }
  }
  return mesh;
}

class Scans : public testing::Test {
 protected:
  void refuse(const std::string& file, const std::string& what) {
    expect_refused(folder, {"reconstruct", file}, 1, file);
    expect_refused(folder, {"reconstruct", file}, 1, what);
  }
  ScratchFolder folder;
};

TEST_F(Scans, WhatIsNoClosedMeshIsRefusedByName) {
  write_text_file(folder / "empty.obj", "");
  write_text_file(folder / "prose.stl", "Field notes of the second of May.\n");
  write_text_file(folder / "points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  write_text_file(folder / "scan.las", "LASF");
  TriangleMesh open = noisy_ellipsoid(3, {0.5, 0.4, 0.3});
  open.triangles.resize(open.triangles.size() / 10);
  write_obj(folder / "open.obj", open);
  TriangleMesh sheet;
  for (int v = 0; v < 25; ++v) sheet.vertices.emplace_back(v % 5, v / 5, 0.1 * (v % 3));
  for (std::uint32_t v = 0; v < 19; ++v) {
    if (v % 5 == 4) continue;
    sheet.triangles.push_back({v, v + 1, v + 6});
    sheet.triangles.push_back({v, v + 6, v + 5});
  }
  write_obj(folder / "sheet.obj", sheet);
  write_text_file(folder / "nan.obj",
                  "v 0 0 0\nv nan 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  write_text_file(folder / "flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 3 2\n");
  refuse("none.obj", "none.obj");
  refuse("empty.obj", "empty");
  refuse("prose.stl", "prose.stl");
  refuse("points.obj", "no block: 3 points are too few");
  refuse("scan.las", "scan.las");
  refuse("open.obj", "open.obj: the largest component is the ground, or one side of a block");
  refuse("sheet.obj", "sheet.obj: the largest component is the ground");
  refuse("nan.obj", "nan.obj");
  refuse("flat.obj", "flat.obj");
}

TEST_F(Scans, AnOpenScanGivesABlockThatSaysWhatIsNotKnown) {
  const TriangleMesh whole = noisy_ellipsoid(3, {0.5, 0.4, 0.3});
  write_obj(folder / "open.obj", above_level(whole, -0.2101));
  const ProgramRun run = run_clast(
      {"reconstruct", "open.obj", "--vertices", "80", "--density", "2500"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "of the surface is not seen but filled in; volume between"));
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
  EXPECT_TRUE(contains(unseen["assumption"].get<std::string>(), "planes of the flanks"));
  const ProgramRun full = run_clast({"show", "blocks.h5", "open"}, folder.path());
  EXPECT_TRUE(contains(full.out, "surface filled in %")) << full.out;
  EXPECT_TRUE(contains(full.out, "mass kg")) << full.out;
}

TriangleMesh two_rocks_on_the_ground() {
  TriangleMesh scene = grid(60, 3.0);
  for (const double x : {1.5, -1.4}) {
    TriangleMesh rock = noisy_ellipsoid(x > 0 ? 5 : 6, {0.6, 0.5, 0.4});
    for (Vec3& v : rock.vertices) v += Vec3(x, 0.2, 0.3);
    scene = merged(std::move(scene), rock);
  }
  return scene;
}

TEST_F(Scans, BlocksOnAGroundAreSplitAndNumbered) {
  write_obj(folder / "scene.obj", two_rocks_on_the_ground());
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

TEST_F(Scans, OneBlockOfASplitThatIsThereAlreadyCostsNeitherTheOthersNorTheFolder) {
  write_obj(folder / "scene.obj", two_rocks_on_the_ground());
  write_obj(folder / "scene_2.obj", cuboid(1, 0.8, 0.6));
  ASSERT_EQ(run_clast({"reconstruct", "scene_2.obj"}, folder.path()).exit_code, 0);
  write_obj(folder / "cube.obj", cuboid(1, 0.9, 0.8));
  const ProgramRun run = run_clast(
      {"reconstruct", "scene.obj", "cube.obj", "--split", "--vertices", "60"}, folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "block scene_2 is in the library already")) << run.err;
  EXPECT_TRUE(contains(run.err, "1 of 2 scans gave no block, or not all of theirs")) << run.err;
  EXPECT_TRUE(contains(run.out, "2 blocks written, 3 in all")) << run.out;
  // A split into fewer than before leaves the others, and says so.
  write_obj(folder / "scene.obj", cuboid(1, 0.9, 0.8));
  const ProgramRun fewer =
      run_clast({"reconstruct", "scene.obj", "--split", "--replace"}, folder.path());
  EXPECT_EQ(fewer.exit_code, 0) << fewer.err;
  EXPECT_TRUE(contains(fewer.err, "still holds block scene_2 of an earlier split")) << fewer.err;
}

TEST_F(Scans, ASizeNoBlockHasIsRefusedWithTheLikelyUnit) {
  write_obj(folder / "mm.obj", cuboid(620, 500, 400));
  refuse("mm.obj",
         "block mm would be 620 m long, read with --units m; it is probably in mm: try --units mm, "
         "which makes it 0.620 m; --any-size takes it as it is");
  const ProgramRun run =
      run_clast({"reconstruct", "mm.obj", "--units", "mm", "--json"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json block = Json::parse(run.out)["blocks"][0];
  EXPECT_NEAR(block["volume_m3"], 0.62 * 0.5 * 0.4, 1e-4 * 0.124);
  EXPECT_EQ(
      run_clast({"reconstruct", "mm.obj", "--any-size", "-o", "huge.h5"}, folder.path()).exit_code,
      0);
  write_obj(folder / "tiny.obj", cuboid(1.0, 0.8, 0.6));
  expect_refused(folder, {"reconstruct", "tiny.obj", "--units", "0.0001", "-o", "t.h5"}, 1,
                 "it is probably in m: try --units m, which makes it 1.00 m; --any-size");
}

TEST_F(Scans, ACoreKeepsItsVerticesAndTheFormulaHolds) {
  const double r = 0.1;
  write_obj(folder / "cube.obj", cuboid(1, 1, 1));
  const ProgramRun run = run_clast(
      {"reconstruct", "cube.obj", "--core", "--radius", "0.1", "--mass", "4000", "--json"},
      folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json block = Json::parse(run.out)["blocks"][0];
  const double volume = 1 + 6 * r + 3 * kPi * r * r + 4 * kPi / 3 * r * r * r;
  EXPECT_EQ(block["vertices"], 8);
  EXPECT_EQ(block["radius_m"], r);
  EXPECT_NEAR(block["volume_m3"], volume, 1e-12 * volume);
  EXPECT_NEAR(block["density_kg_m3"], 4000.0 / volume, 1e-9);
  EXPECT_EQ(block["deviation_m"]["hausdorff"], 0.0);
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
  expect_refused(folder, core, 1, " m round near (");
  const ProgramRun run = run_clast({"reconstruct", "open.obj"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "the scan was open: "));
  EXPECT_TRUE(contains(run.out, " % of the surface is not seen but filled in; volume between "));
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
  for (const char* bad : {"0,0,0;0,10,0", "0,0,0;0,0,0;1", "0,0,0;0,10,0;-1", "a,0,0;0,10,0;1"}) {
    expect_refused(folder, {"reconstruct", "box.obj", "-o", "n.h5", "--scale-length", bad}, 2,
                   "two points of the scan and the metres between them");
  }
  expect_refused(
      folder, {"reconstruct", "box.obj", "-o", "n.h5", "--scale-length", "0,0,0;0,10,0;100"}, 1,
      "block box would be 200 m long, scaled by --scale-length: check its two points and "
      "its metres; --any-size takes it as it is");
  expect_refused(folder,
                 {"reconstruct", "box.obj", "--units", "mm", "--scale-length", "0,0,0;0,10,0;1"}, 2,
                 "--units");
}

TEST_F(Scans, APointOfTheMeasuredLengthThatIsOffTheScanIsToldOf) {
  write_obj(folder / "box.obj", cuboid(1, 0.9, 0.8));
  const auto out = [&](const std::string& length) {
    const ProgramRun run =
        run_clast({"reconstruct", "box.obj", "--replace", "--scale-length", length}, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  };
  const std::string note = "a point of --scale-length lies ";
  EXPECT_TRUE(contains(out("0,0,0;100,0,0;100"), note + "99")) << "half a side is on the scan";
  EXPECT_FALSE(contains(out("-0.5,0,0 0.5,0,0 1"), note));
}

TEST_F(Scans, AMassThatContradictsTheVolumeIsToldOf) {
  write_obj(folder / "cube.obj", cuboid(1, 0.9, 0.8));
  const ProgramRun run =
      run_clast({"reconstruct", "cube.obj", "--density", "2650", "--mass", "1500"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out,
                       "note: volume times density gives 1908 kg, 27.2 % more than the "
                       "1500 kg weighed; check scale, density and closed bottom"));
}

TEST_F(Scans, InnerShellsAreDroppedOrKeptAndToldOfEitherWay) {
  TriangleMesh cavity = cuboid(0.3, 0.3, 0.3);
  for (TriangleMesh::Triangle& t : cavity.triangles) std::swap(t[0], t[1]);
  write_obj(folder / "hollow.obj", merged(cuboid(1, 0.9, 0.8), cavity));
  const ProgramRun dropped = run_clast({"reconstruct", "hollow.obj"}, folder.path());
  ASSERT_EQ(dropped.exit_code, 0) << dropped.err;
  EXPECT_TRUE(contains(dropped.out, "0.7200 m3"));
  EXPECT_TRUE(contains(dropped.out, "1 inner shell (bubbles) of 0.027 m3 in all dropped"));
  const ProgramRun kept =
      run_clast({"reconstruct", "hollow.obj", "--keep-inner-shells", "-o", "k.h5"}, folder.path());
  ASSERT_EQ(kept.exit_code, 0) << kept.err;
  EXPECT_TRUE(contains(kept.out, "0.6930 m3"));
  EXPECT_TRUE(contains(kept.out, "1 inner shell (bubbles) of 0.027 m3 in all kept as cavities"));
  const ProgramRun shown = run_clast({"show", "k.h5", "hollow"}, folder.path());
  EXPECT_TRUE(contains(shown.out, "kept as cavities"));
  EXPECT_TRUE(contains(shown.out, "inner_shells=kept"));
}

TEST_F(Scans, NearlyEqualMomentsAreToldOf) {
  write_obj(folder / "cube.obj", cuboid(1, 1, 1));
  const ProgramRun made = run_clast({"reconstruct", "cube.obj"}, folder.path());
  EXPECT_TRUE(contains(made.out, "principal moments are nearly equal")) << made.err;
  const ProgramRun shown = run_clast({"show", "blocks.h5", "cube"}, folder.path());
  EXPECT_TRUE(contains(shown.out, "principal moments are nearly equal")) << shown.err;
}

TEST_F(Scans, AnOutputThatCantBeWrittenIsRefused) {
  write_obj(folder / "cube.obj", cuboid(1, 0.9, 0.8));
  fs::create_directory(folder / "folder.h5");
  expect_refused(folder, {"reconstruct", "cube.obj", "-o", "folder.h5"}, 1, "folder.h5");
  const std::vector<std::string> nowhere = {"reconstruct", "cube.obj", "-o", "cube.obj/blocks.h5"};
  expect_refused(folder, nowhere, 1, "cube.obj");
  EXPECT_EQ(run_clast(nowhere, folder.path()).out, "") << "before any block is made";
}

TEST_F(Scans, VerticesAreAddedUntilTheBlockIsWithinTheTolerance) {
  write_obj(folder / "rough.obj", rock_mesh(7, {1.0, 0.9, 0.8}, 5, 0.3));
  const auto made = [&](const std::vector<std::string>& options, const std::string& library) {
    std::vector<std::string> command = {"reconstruct", "rough.obj", "--json", "-o", library};
    command.insert(command.end(), options.begin(), options.end());
    const ProgramRun run = run_clast(command, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(run.out)["blocks"][0];
  };
  const auto off = [](const Json& block) {
    return block["deviation_m"]["hausdorff"].get<double>() / block["box_m"][0].get<double>();
  };
  const std::string tolerance = "0.005";
  const Json fixed = made({"--vertices", "60", "--tolerance", tolerance}, "fixed.h5");
  EXPECT_GT(off(fixed), 0.005) << "else there is nothing to add vertices for";
  EXPECT_LE(fixed["vertices"], 60);
  EXPECT_TRUE(contains(fixed["warnings"].dump(), "% of L")) << fixed["warnings"];
  const Json raised = made({"--tolerance", tolerance}, "raised.h5");
  EXPECT_LE(off(raised), 0.005);
  EXPECT_GT(raised["vertices"], 60);
  EXPECT_LE(raised["vertices"], 2000);
  // About the fewest: with half of them it is farther off.
  const auto fewer = std::to_string(raised["vertices"].get<std::size_t>() / 2);
  EXPECT_GT(off(made({"--vertices", fewer, "--tolerance", tolerance}, "fewer.h5")), 0.005);
  EXPECT_FALSE(contains(raised["warnings"].dump(), "% of L")) << raised["warnings"];
  // Out of reach: the nearest block, and a warning that says so.
  const Json far = made({"--tolerance", "0.00001", "--radius-share", "0.02"}, "far.h5");
  EXPECT_LE(far["vertices"], 2000);
  EXPECT_TRUE(contains(far["warnings"].dump(), "2000 vertices")) << far["warnings"];
}

TEST_F(Scans, ConvexTakesTheHullOnPurpose) {
  // A cube with its top pressed in to half its height: a third of half the cube is missing.
  TriangleMesh dented = cuboid(1, 1, 1);
  TriangleMesh cube = dented;
  std::erase_if(dented.triangles, [&](const TriangleMesh::Triangle& t) {
    return dented.vertices[t[0]].z() == dented.vertices[t[1]].z() &&
           dented.vertices[t[1]].z() == dented.vertices[t[2]].z() &&
           dented.vertices[t[0]].z() == bounds(cube).high.z();
  });
  const double top = bounds(cube).high.z(), floor = bounds(cube).low.z();
  const auto low = static_cast<std::uint32_t>(dented.vertices.size());
  dented.vertices.push_back(0.5 * (bounds(cube).low + bounds(cube).high));
  // The rim, counter-clockwise from above.
  std::vector<std::uint32_t> rim;
  for (const Vec3& corner : {Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)}) {
    const Vec3 at = bounds(cube).low + corner * (top - floor);
    for (std::uint32_t v = 0; v < low; ++v) {
      if ((dented.vertices[v] - at).norm() < 1e-9) rim.push_back(v);
    }
  }
  ASSERT_EQ(rim.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    dented.triangles.push_back({rim[k], rim[(k + 1) % 4], low});
  }
  write_obj(folder / "dented.obj", dented);
  const auto made = [&](const std::vector<std::string>& options) {
    std::vector<std::string> command = {"reconstruct", "dented.obj", "--json", "--replace"};
    command.insert(command.end(), options.begin(), options.end());
    const ProgramRun run = run_clast(command, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(run.out)["blocks"][0];
  };
  const Json as_it_is = made({}), convex = made({"--convex"});
  EXPECT_NEAR(as_it_is["volume_m3"], 5.0 / 6.0, 1e-3);
  EXPECT_FALSE(contains(as_it_is["warnings"].dump(), "hull"));
  EXPECT_NEAR(convex["volume_m3"], 1.0, 1e-3);
  EXPECT_TRUE(contains(convex["warnings"].dump(), "20.0 % more volume")) << convex["warnings"];
  const ProgramRun shown = run_clast({"show", "blocks.h5", "dented"}, folder.path());
  EXPECT_TRUE(contains(shown.out, "convex=yes")) << shown.out;
  expect_refused(folder, {"reconstruct", "dented.obj", "--convex", "--core", "--radius", "0.1"}, 2,
                 "--core");
}

TEST_F(Scans, TheRadiusIsHalvedOnlyWhereTheUserGaveNone) {
  // The corner of a cube with side 1 and radius r ends r (sqrt 3 - 1) short: 1.5 % at 0.02, 0.73 %
  // at 0.01. A core of eight vertices can't reach out there without swelling all faces.
  write_obj(folder / "cube.obj", cuboid(1, 1, 1));
  const auto radius = [&](const std::vector<std::string>& options) {
    std::vector<std::string> command = {"reconstruct", "cube.obj", "--json", "--replace"};
    command.insert(command.end(), options.begin(), options.end());
    const ProgramRun run = run_clast(command, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(run.out)["blocks"][0]["radius_m"].get<double>();
  };
  EXPECT_NEAR(radius({}), 0.01, 1e-9);
  EXPECT_NEAR(radius({"--tolerance", "0.02"}), 0.02, 1e-9);
  EXPECT_NEAR(radius({"--radius-share", "0.02"}), 0.02, 1e-9);
  EXPECT_EQ(radius({"--radius", "0.03"}), 0.03);
}

TEST_F(Scans, ACoreThatCrossesItselfIsTakenAsItIsAndToldOf) {
  // Upper corners turned by half a turn: the walls cross on the axis.
  TriangleMesh twisted = cuboid(1, 1, 1);
  for (Vec3& v : twisted.vertices) {
    if (v.z() > 0.0) v = Vec3(-v.x(), -v.y(), v.z());
  }
  write_obj(folder / "twisted.obj", twisted);
  const ProgramRun run =
      run_clast({"reconstruct", "twisted.obj", "--core", "--radius", "0.01"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "passes through itself at")) << run.out;
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
