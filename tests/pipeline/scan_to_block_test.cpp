// One scan on its way to its blocks: scale, size, simplification, and what is noted about it.
#include "pipeline/scan_to_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "pipeline/stations_file.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/rocks_on_ground.hpp"
#include "tests/support/scan_files.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

class ScanToBlock : public testing::Test {
 protected:
  Block block_of(const TriangleMesh& mesh) {
    write_obj(folder / "scan.obj", mesh);
    return reconstruct_blocks(folder / "scan.obj", "scan", options).front();
  }

  std::string refused(const TriangleMesh& mesh) {
    write_obj(folder / "scan.obj", mesh);
    return refusal([&] { reconstruct_blocks(folder / "scan.obj", "scan", options); });
  }

  /// All warnings of a block, one per line.
  static std::string notes(const Block& block) {
    std::string text;
    for (const std::string& warning : block.warnings) text += warning + "\n";
    return text;
  }

  ScratchFolder folder;
  ScanToBlockOptions options;
};

TEST_F(ScanToBlock, BlocksOnAGroundAreSplitAndNumbered) {
  options.split = true;
  options.vertices = 60;
  write_obj(folder / "scene.obj", two_rocks_on_ground());
  std::vector<std::string> steps, made;
  const std::vector<Block> blocks = reconstruct_blocks(
      folder / "scene.obj", "scene", options,
      {.progress = [&](const ProgressUpdate& step) { steps.push_back(step.activity); },
       .on_block_made =
           [&](const Block& block, const BlockOrigin& origin) {
             made.push_back(block.id);
             EXPECT_EQ(origin.raw->triangles.size(), two_rocks_on_ground().triangles.size());
             EXPECT_FALSE(origin.field_block->scan.mesh.triangles.empty());
             EXPECT_EQ(origin.photos, nullptr);
           }});
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0].id, "scene_1");
  EXPECT_EQ(blocks[1].id, "scene_2");
  EXPECT_LT(blocks[0].mass.centre.x(), 0.0);
  EXPECT_GT(blocks[1].mass.centre.x(), 0.0);
  EXPECT_EQ(made, (std::vector<std::string>{"scene_1", "scene_2"}));
  ASSERT_FALSE(steps.empty());
  EXPECT_EQ(steps.front(), "reading scene");
}

TEST_F(ScanToBlock, StationsAreRecordedAndThoseOfAnotherSystemAreRefused) {
  options.split = true;
  options.vertices = 60;
  write_obj(folder / "scene.obj", two_rocks_on_ground());
  write_text_file(folder / "stations.csv", "name,x_m,y_m,z_m\nA,6,1,2\nB,-6,-1,2\n");
  options.stations = read_stations(folder / "stations.csv");
  EXPECT_EQ(options.stations, (std::vector<Vec3>{{6, 1, 2}, {-6, -1, 2}}));
  const std::vector<Block> blocks = reconstruct_blocks(folder / "scene.obj", "scene", options);
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_TRUE(contains(blocks[0].source.options, " stations="));
  options.stations[1] = {652013.0, 5203000.0, 1824.0};
  EXPECT_TRUE(contains(refusal([&] { reconstruct_blocks(folder / "scene.obj", "scene", options); }),
                       "position 2 of `stations`"));
  options.split = false;
  EXPECT_TRUE(contains(refusal([&] { options.check(); }), "`stations` needs `split`"));
}

/// Highest vertex of the surface of a block.
Vec3 top_of(const Block& block) {
  return *std::max_element(block.surface.vertices.begin(), block.surface.vertices.end(),
                           [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
}

TEST_F(ScanToBlock, EditsCorrectADepositAndAreRecorded) {
  options.split = true;
  options.vertices = 60;
  write_obj(folder / "scene.obj", two_rocks_on_ground());
  const auto split = [&](const ScanCallbacks& callbacks = {}) {
    return reconstruct_blocks(folder / "scene.obj", "scene", options, callbacks);
  };
  const std::vector<Block> both = split();
  ASSERT_EQ(both.size(), 2u);
  EXPECT_FALSE(contains(both[0].source.options, "edits="));

  options.edits = {{DepositEditKind::kDrop, {top_of(both[0])}}};
  const std::vector<Block> one = split();
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].deposit->points, both[1].deposit->points) << "the other block remains";
  EXPECT_NEAR(one[0].mass.volume, both[1].mass.volume, 0.05 * both[1].mass.volume);
  const std::string dropped = one[0].source.options;
  EXPECT_TRUE(contains(dropped, " edits="));

  options.edits[0].kind = DepositEditKind::kAccept;
  std::size_t deposits = 0;
  const std::vector<Block> accepted =
      split({.on_deposit_made = [&](const std::vector<Block>& blocks, const DepositOrigin& origin) {
        ++deposits;
        EXPECT_EQ(blocks.size(), 2u);
        EXPECT_EQ(origin.ids, (std::vector<std::string>{"scene_1", "scene_2"}));
        EXPECT_EQ(origin.scan->block_of_point.size(), origin.scan->raw.vertices.size());
        EXPECT_GT(origin.scan->spacing, 0.0);
      }});
  EXPECT_EQ(deposits, 1u);
  ASSERT_EQ(accepted.size(), 2u);
  EXPECT_EQ(accepted[0].surface.vertices, both[0].surface.vertices);
  EXPECT_NE(accepted[0].source.options, dropped) << "the digest differs between edits";

  options.edits[0].points[0].z() += 100.0;
  EXPECT_TRUE(contains(refusal([&] { split(); }), "edit 1 of 1 (accept at ("));
}

TEST_F(ScanToBlock, EditsAreForScansOfManyBlocks) {
  options.edits = {{DepositEditKind::kDrop, {Vec3::Zero()}}};
  EXPECT_TRUE(contains(refusal([&] { options.check(); }), "`edits` needs `split`"));
  options.split = true;
  options.check();
  EXPECT_TRUE(contains(refused(cuboid(1, 0.9, 0.8)), "a closed body, hence one block"));
}

TEST_F(ScanToBlock, WhatIsNoClosedMeshIsRefusedByName) {
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
  const auto refuse = [&](const std::string& file, const std::string& what) {
    const std::string id = std::filesystem::path(file).stem();
    const std::string said =
        refusal<Error>([&] { reconstruct_blocks(folder / file, id, options); });
    EXPECT_TRUE(contains(said, id) && contains(said, what));
  };
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

TEST_F(ScanToBlock, ASizeNoBlockHasIsRefusedWithTheLikelyUnit) {
  EXPECT_TRUE(contains(refused(cuboid(620, 500, 400)),
                       "block scan would be 620 m long, read with `units` m; it is probably in mm: "
                       "try `units` mm, which makes it 0.620 m; `any_size` accepts it"));
  options.allow_any_size = true;
  EXPECT_NEAR(block_of(cuboid(620, 500, 400)).mass.volume / 1.24e8, 1.0, 1e-3);
  options.allow_any_size = false;
  options.units = "mm";
  options.scan.unit = 0.001;
  EXPECT_NEAR(block_of(cuboid(620, 500, 400)).mass.volume, 0.124, 1e-4 * 0.124);
  options.units = "0.0001";
  options.scan.unit = 0.0001;
  EXPECT_TRUE(contains(refused(cuboid(1.0, 0.8, 0.6)),
                       "it is probably in m: try `units` m, which makes it 1.00 m"));
  options.scale_points = {{Vec3(0, 0, 0), Vec3(0, 10, 0)}};
  options.scan.unit = 10.0;
  EXPECT_TRUE(contains(refused(cuboid(20, 10, 10)),
                       "block scan would be 200 m long, scaled by `scale_points`: check its two "
                       "points and its length; `any_size` accepts it"));
}

TEST_F(ScanToBlock, ACoreKeepsItsVerticesAndTheFormulaHolds) {
  const double r = 0.1;
  options.block.core = true;
  options.block.radius = r;
  options.block.mass = 4000.0;
  const Block block = block_of(cuboid(1, 1, 1));
  const double volume = 1 + 6 * r + 3 * kPi * r * r + 4 * kPi / 3 * r * r * r;
  EXPECT_EQ(block.body.vertices.size(), 8u);
  EXPECT_EQ(block.body.radius, r);
  EXPECT_NEAR(block.mass.volume, volume, 1e-12 * volume);
  EXPECT_NEAR(block.density, 4000.0 / volume, 1e-9);
  EXPECT_EQ(block.deviation.hausdorff, 0.0);
}

TEST_F(ScanToBlock, APointOfTheMeasuredLengthThatIsOffTheScanIsNoted) {
  const std::string note = "a point of `scale_points` lies ";
  options.scale_points = {{Vec3(0, 0, 0), Vec3(100, 0, 0)}};
  EXPECT_TRUE(contains(notes(block_of(cuboid(1, 0.9, 0.8))), note + "99"))
      << "half a side is on the scan";
  options.scale_points = {{Vec3(-0.5, 0, 0), Vec3(0.5, 0, 0)}};
  EXPECT_FALSE(contains(notes(block_of(cuboid(1, 0.9, 0.8))), note));
}

TEST_F(ScanToBlock, AMassThatContradictsTheVolumeIsNoted) {
  options.block.density_given = true;
  options.block.density = 2650.0;
  options.block.mass = 1500.0;
  EXPECT_TRUE(contains(notes(block_of(cuboid(1, 0.9, 0.8))),
                       "volume times density gives 1908 kg, 27.2 % more than the 1500 kg weighed; "
                       "check scale, density and closed bottom"));
}

TEST_F(ScanToBlock, InnerShellsAreDroppedOrKeptAndNotedEitherWay) {
  TriangleMesh cavity = cuboid(0.3, 0.3, 0.3);
  for (TriangleMesh::Triangle& t : cavity.triangles) std::swap(t[0], t[1]);
  const TriangleMesh hollow = merged(cuboid(1, 0.9, 0.8), cavity);
  const Block dropped = block_of(hollow);
  EXPECT_NEAR(dropped.mass.volume, 0.72, 1e-4);
  EXPECT_TRUE(contains(notes(dropped), "1 inner shell (bubbles) of 0.027 m3 in all dropped"));
  options.scan.repair.keep_inner_shells = true;
  const Block kept = block_of(hollow);
  EXPECT_NEAR(kept.mass.volume, 0.693, 1e-4);
  EXPECT_TRUE(contains(notes(kept), "1 inner shell (bubbles) of 0.027 m3 in all kept as cavities"));
  EXPECT_TRUE(contains(kept.source.options, "inner_shells=kept"));
}

TEST_F(ScanToBlock, NearlyEqualMomentsAreNoted) {
  EXPECT_TRUE(contains(notes(block_of(cuboid(1, 1, 1))), "principal moments are nearly equal"));
}

TEST_F(ScanToBlock, VerticesAreAddedUntilTheBlockIsWithinTheTolerance) {
  const TriangleMesh rough = rock_mesh(7, {1.0, 0.9, 0.8}, 5, 0.3);
  const auto off = [](const Block& block) {
    return block.deviation.hausdorff / block.box.lengths[0];
  };
  options.block.tolerance = 0.005;
  options.vertices = 60;
  const Block fixed = block_of(rough);
  EXPECT_GT(off(fixed), 0.005) << "else there is nothing to add vertices for";
  EXPECT_LE(fixed.body.vertices.size(), 60u);
  EXPECT_TRUE(contains(notes(fixed), "% of L"));
  options.vertices = {};
  const Block raised = block_of(rough);
  EXPECT_LE(off(raised), 0.005);
  EXPECT_GT(raised.body.vertices.size(), 60u);
  EXPECT_LE(raised.body.vertices.size(), 2000u);
  EXPECT_FALSE(contains(notes(raised), "% of L"));
  // About the fewest: with half of them it is farther off.
  options.vertices = raised.body.vertices.size() / 2;
  EXPECT_GT(off(block_of(rough)), 0.005);
  // Out of reach: the nearest block, and a warning that says so.
  options.vertices = {};
  options.block.tolerance = 0.00001;
  options.radius_given = true;
  const Block far = block_of(rough);
  EXPECT_LE(far.body.vertices.size(), 2000u);
  EXPECT_TRUE(contains(notes(far), "2000 vertices"));
}

TEST_F(ScanToBlock, AToleranceThatLetsHalfABlockPassIsQuestioned) {
  const TriangleMesh rock = rock_mesh(7, {1.0, 0.9, 0.8}, 3, 0.1);
  for (const double tolerance : {1.0, 0.5, 0.2}) {
    options.block.tolerance = tolerance;
    const std::string said = notes(block_of(rock));
    EXPECT_TRUE(
        contains(said, "`tolerance` " + format_significant(tolerance, 4) + " is a fraction of L"));
    EXPECT_TRUE(contains(said, "it is not a length or a percentage: 0.01 means 1 %"));
  }
  options.block.tolerance = 0.05;
  EXPECT_EQ(notes(block_of(rock)).find("is a fraction of L"), std::string::npos);
}

TEST_F(ScanToBlock, ConvexTakesTheHullOnPurpose) {
  // A cube with its top pressed in to half its height: a third of half the cube is missing.
  TriangleMesh dented = cuboid(1, 1, 1);
  std::erase_if(dented.triangles, [&](const TriangleMesh::Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t v) { return dented.vertices[v].z() > 0.0; });
  });
  // The rim of the top, counter-clockwise from above: see `cuboid` for its corners.
  for (const auto& [from, to] : {std::pair{4u, 5u}, {5u, 7u}, {7u, 6u}, {6u, 4u}}) {
    dented.triangles.push_back({from, to, 8});
  }
  dented.vertices.emplace_back(0, 0, 0);
  const Block as_it_is = block_of(dented);
  EXPECT_NEAR(as_it_is.mass.volume, 5.0 / 6.0, 1e-3);
  EXPECT_FALSE(contains(notes(as_it_is), "hull"));
  options.block.convex = true;
  const Block convex = block_of(dented);
  EXPECT_NEAR(convex.mass.volume, 1.0, 1e-3);
  EXPECT_TRUE(contains(notes(convex), "20.0 % more volume"));
  EXPECT_TRUE(contains(convex.source.options, "convex=yes"));
}

TEST_F(ScanToBlock, TheRadiusIsHalvedOnlyWhereTheUserGaveNone) {
  // The corner of a cube with side 1 and radius r ends r (sqrt 3 - 1) short: 1.5 % at 0.02, 0.73 %
  // at 0.01. A core of eight vertices can't reach out there without swelling all faces.
  const auto radius = [&] { return block_of(cuboid(1, 1, 1)).body.radius; };
  EXPECT_NEAR(radius(), 0.01, 1e-9);
  options.block.tolerance = 0.02;
  EXPECT_NEAR(radius(), 0.02, 1e-9);
  options.block.tolerance = BlockOptions().tolerance;
  options.radius_given = true;
  EXPECT_NEAR(radius(), 0.02, 1e-9);
  options.block.radius = 0.03;
  EXPECT_EQ(radius(), 0.03);
}

TEST_F(ScanToBlock, ACoreThatCrossesItselfIsTakenAsItIsWithANote) {
  // Upper corners turned by half a turn: the walls cross on the axis.
  TriangleMesh twisted = cuboid(1, 1, 1);
  for (Vec3& v : twisted.vertices) {
    if (v.z() > 0.0) v = Vec3(-v.x(), -v.y(), v.z());
  }
  options.block.core = true;
  options.block.radius = 0.01;
  EXPECT_TRUE(contains(notes(block_of(twisted)), "passes through itself at"));
}

TEST_F(ScanToBlock, TheSameScanGivesTheSameBlock) {
  const TriangleMesh rock = noisy_ellipsoid(8, {0.5, 0.4, 0.3});
  const Block a = block_of(rock), b = block_of(rock);
  EXPECT_EQ(a.body.vertices, b.body.vertices);
  EXPECT_EQ(a.mass.inertia, b.mass.inertia);
}

}  // namespace
}  // namespace clast
