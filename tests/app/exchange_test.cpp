// Shapes of Rockable and ExaDEM in, shapes and meshes out, as a user does it.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "mesh/mesh_io.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/shp_file.hpp"
#include "tests/app/command_support.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

/// A cube of side 1 about the origin: quads with no common turn, an edge twice, the others missing.
std::string cube(const std::string& name, double radius, const std::string& more = "") {
  std::string text = "<\nname " + name + "\nradius " + std::to_string(radius) + "\n" + more +
                     "nv 8\n-.5 -.5 -.5\n.5 -.5 -.5\n.5 .5 -.5\n-.5 .5 -.5\n-.5 -.5 .5\n"
                     ".5 -.5 .5\n.5 .5 .5\n-.5 .5 .5\nne 2\n0 1\n1 0\nnf 6\n4 0 1 2 3\n4 4 5 6 7\n"
                     "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n>\n";
  return text;
}

double rounded_cube_volume(double r) {
  return 1.0 + 6.0 * r + 3.0 * kPi * r * r + 4.0 / 3.0 * kPi * r * r * r;
}

class Exchange : public testing::Test {
 protected:
  ProgramRun reconstruct(const std::vector<std::string>& arguments) {
    std::vector<std::string> all = {"reconstruct"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_clast(all, folder.path());
  }
  /// The blocks of a library by id.
  std::map<std::string, Json> show_library(const std::string& library) {
    std::map<std::string, Json> blocks;
    for (const Json& block :
         Json::parse(run_clast({"show", library, "--json"}, folder.path()).out)) {
      blocks[block["id"]] = block;
    }
    return blocks;
  }
  void write(const std::string& name, const std::string& text) {
    write_text_file(folder / name, text);
  }

  ScratchFolder folder;
};

TEST_F(Exchange, AShapeWithoutTurnBecomesABlock) {
  write("rock.shp", cube("ANY", 0.25));
  const ProgramRun run = reconstruct({"rock.shp", "-o", "b.h5", "--density", "2000"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_FALSE(contains(run.out, ".shp file gives")) << run.out;
  const Json block = show_library("b.h5").at("rock");  // one shape: the file's name
  EXPECT_EQ(block["vertices"], 8);
  EXPECT_EQ(block["edges"], 12);
  EXPECT_EQ(block["faces"], 6);
  EXPECT_EQ(block["edge_bends"]["convex"], 12);
  EXPECT_EQ(block["radius_m"], 0.25);
  EXPECT_NEAR(block["volume_m3"], rounded_cube_volume(0.25), 1e-12);
  EXPECT_NEAR(block["mass_kg"], 2000.0 * rounded_cube_volume(0.25), 1e-8);
}

TEST_F(Exchange, PolygonsWrittenWithEightDigitsStayWhole) {
  // A regular pentagon's prism, turned, as files have it: flat to 1e-8 only.
  const Quat turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  std::string text = "<\nname P\nradius 0.1\nnv 10\n";
  for (int i = 0; i < 10; ++i) {
    const double angle = 0.4 * kPi * (i % 5);
    const Vec3 corner = turn * Vec3(std::cos(angle), std::sin(angle), i < 5 ? 0.0 : 1.0);
    char line[80];
    std::snprintf(line, sizeof line, "%.8f %.8f %.8f\n", corner.x(), corner.y(), corner.z());
    text += line;
  }
  text +=
      "nf 7\n5 0 1 2 3 4\n5 5 6 7 8 9\n4 0 1 6 5\n4 2 1 6 7\n4 2 3 8 7\n4 4 3 8 9\n4 0 4 9 5\n>\n";
  write("prism.shp", text);
  ASSERT_EQ(reconstruct({"prism.shp", "-o", "b.h5"}).exit_code, 0);
  const Json block = show_library("b.h5").at("prism");
  EXPECT_EQ(block["faces"], 7);
  EXPECT_EQ(block["edges"], 15);
  EXPECT_EQ(block["edge_bends"]["convex"], 15);
}

TEST_F(Exchange, AFileOfSeveralShapesGivesABlockForEach) {
  write("all.shp", cube("quarry/SP1A.stl", 0.1) +
                       "<\nname ball\nradius 0.5\nnv 1\n1 2 3\nne 0\nnf 0\n>\n"
                       "<\nname rod\nradius 0.1\nnv 2\n0 0 0\n0 0 1\nne 1\n0 1\nnf 0\n>\n");
  const ProgramRun run = reconstruct({"all.shp", "-o", "b.h5"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::map<std::string, Json> blocks = show_library("b.h5");
  ASSERT_EQ(blocks.size(), 3u);
  EXPECT_NEAR(blocks.at("SP1A")["volume_m3"], rounded_cube_volume(0.1), 1e-12);
  EXPECT_NEAR(blocks.at("ball")["volume_m3"], kPi / 6.0, 1e-12);
  EXPECT_NEAR(blocks.at("ball")["centre_m"][2], 3.0, 1e-12);
  EXPECT_NEAR(blocks.at("rod")["volume_m3"], kPi * 0.01 * (1.0 + 0.4 / 3.0), 1e-12);
  EXPECT_NEAR(blocks.at("rod")["box_m"][0], 1.2, 1e-9);
}

TEST_F(Exchange, ExportedShapesComeBackAsTheSameBodies) {
  for (int i = 0; i < 3; ++i) {
    write_obj(folder / ("rock" + std::to_string(i) + ".obj"),
              convex_hull(random_rock(static_cast<std::uint64_t>(i), 2, 0.3).vertices));
  }
  write_obj(folder / "concave.obj", l_block());
  ASSERT_EQ(reconstruct({".", "-o", "once.h5", "--core", "--radius", "0.05"}).exit_code, 0);
  ASSERT_EQ(run_clast({"export", "once.h5", "-o", "out"}, folder.path()).exit_code, 0);
  const ProgramRun run = reconstruct({"out", "-o", "again.h5"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_FALSE(contains(run.out, ".shp file gives")) << run.out;
  EXPECT_FALSE(contains(run.out, "turned")) << run.out;
  const std::map<std::string, Json> once = show_library("once.h5"),
                                    again = show_library("again.h5");
  ASSERT_EQ(again.size(), 4u);
  for (const auto& [id, was] : once) {
    const Json& is = again.at(id);
    for (const char* key : {"vertices", "edges", "faces", "edge_bends", "radius_m", "shape"}) {
      EXPECT_EQ(is[key], was[key]) << id << " " << key;
    }
    const double accuracy = id == "concave" ? 2e-4 : 1e-9;  // columns turn with the frame
    EXPECT_NEAR(is["volume_m3"], was["volume_m3"], accuracy * double(was["volume_m3"])) << id;
    for (int k = 0; k < 3; ++k) {
      const double moment = was["principal_moments_kg_m2"][k];
      EXPECT_NEAR(is["principal_moments_kg_m2"][k], moment, accuracy * moment) << id;
      EXPECT_NEAR(is["box_m"][k], was["box_m"][k], 1e-9) << id;
      EXPECT_NEAR(is["centre_m"][k], 0.0, 1e-4) << id;  // the frame is the file's: principal
    }
  }
}

TEST_F(Exchange, PolygonsOfAShapeFileAreWholeFacesAndItsPoseIsWhereTheScanWas) {
  TriangleMesh block = box_mesh({3, 2, 1}, 4);
  for (Vec3& vertex : block.vertices)
    vertex = Vec3(vertex.y(), vertex.z(), vertex.x()) + Vec3(10, 20, 30);
  write_obj(folder / "slab.obj", block);
  ASSERT_EQ(reconstruct({"slab.obj", "-o", "b.h5", "--core", "--radius", "0.1"}).exit_code, 0);
  ASSERT_EQ(run_clast({"export", "b.h5", "-o", "out"}, folder.path()).exit_code, 0);
  const ShpShape shape = read_shp(folder / "out" / "slab.shp")[0];
  EXPECT_EQ(shape.body.faces.size(), 6u);
  EXPECT_EQ(shape.body.edges.size(), 12u);
  EXPECT_EQ(shape.body.vertices.size(), 8u);
  EXPECT_LT((shape.source_from_body.translation - Vec3(11, 20.5, 31.5)).norm(), 1e-9);
  EXPECT_LT((shape.box.lengths - Vec3(3.2, 2.2, 1.2)).norm(), 1e-9);
  EXPECT_LE(shape.inertia_per_mass[0], shape.inertia_per_mass[1]);
  EXPECT_LE(shape.inertia_per_mass[1], shape.inertia_per_mass[2]);
  for (const Vec3& vertex : shape.body.vertices) {  // the smallest moment is about the longest side
    EXPECT_LT((vertex.cwiseAbs() - Vec3(1.5, 1.0, 0.5)).norm(), 1e-9);
    const Vec3 scanned = shape.source_from_body * vertex - Vec3(10, 20, 30);
    EXPECT_LT(std::abs(scanned.x() * (scanned.x() - 2.0)), 1e-8);
    EXPECT_LT(std::abs(scanned.y() * (scanned.y() - 1.0)), 1e-8);
    EXPECT_LT(std::abs(scanned.z() * (scanned.z() - 3.0)), 1e-8);
  }
}

TEST_F(Exchange, NumbersOfTheFileAreHeldAgainstItsShape) {
  const double r = 0.1, volume = rounded_cube_volume(r);
  const auto with_volume = [&](double share, const std::string& more) {
    write("rock.shp",
          cube("ANY", r, "preCompDone y\nvolume " + std::to_string(share * volume) + "\n" + more));
    const ProgramRun run = reconstruct({"rock.shp", "-o", "b.h5", "--replace"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  };
  EXPECT_FALSE(contains(with_volume(1.005, ""), "gives"));  // what 10,000 points leave
  const std::string far = with_volume(1.10, "");
  EXPECT_TRUE(contains(far, "a volume of") && contains(far, "10 % apart")) << far;
  EXPECT_TRUE(contains(with_volume(1.005, "MCnstep 1000000\n"), "a volume of"));
  EXPECT_TRUE(contains(with_volume(1.0, "I/m 0.2 0.2 0.3\n"), "I/m of 0.2 0.2 0.3"));
}

TEST_F(Exchange, UnitsAndUpAxisHoldForShapesToo) {
  write("rock.shp",
        cube("ANY", 0.25,
             "preCompDone y\nvolume " + std::to_string(rounded_cube_volume(0.25)) + "\n"));
  ASSERT_EQ(reconstruct({"rock.shp", "-o", "b.h5", "--units", "cm"}).exit_code, 0);
  const Json block = show_library("b.h5").at("rock");
  EXPECT_NEAR(block["radius_m"], 0.0025, 1e-15);
  EXPECT_NEAR(block["volume_m3"], 1e-6 * rounded_cube_volume(0.25), 1e-17);
  EXPECT_EQ(block["warnings"].dump().find(".shp file gives"), std::string::npos);
  write("ball.shp", "<\nname ball\nradius 0.5\nnv 1\n1 2 3\n>\n");
  ASSERT_EQ(reconstruct({"ball.shp", "-o", "y.h5", "--up", "y"}).exit_code, 0);
  EXPECT_EQ(show_library("y.h5").at("ball")["centre_m"], Json({1.0, -3.0, 2.0}));
}

TEST_F(Exchange, WhatCannotBeABlockIsRefusedWithTheReason) {
  write("rock.shp", cube("ROCK", 0.25));
  expect_refused(folder, {"reconstruct", "rock.shp", "--radius", "0.3"}, 1,
                 "contradicts the radius");
  EXPECT_EQ(reconstruct({"rock.shp", "-o", "b.h5", "--radius", "0.25", "--core"}).exit_code, 0);
  std::filesystem::remove(folder / "b.h5");

  write("wall.shp", cube("WALL", 0.25, "isSurface\n"));
  expect_refused(folder, {"reconstruct", "wall.shp"}, 1, "isSurface");
  write("open.shp",
        "<\nname OPEN\nradius 0.1\nnv 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 9\nnf 1\n"
        "4 0 1 2 3\n>\n");
  expect_refused(folder, {"reconstruct", "open.shp"}, 1, "shape OPEN");
  write("rods.shp", "<\nname RODS\nradius 0.1\nnv 3\n0 0 0\n1 0 0\n1 1 0\nne 2\n0 1\n1 2\n>\n");
  expect_refused(folder, {"reconstruct", "rods.shp"}, 1, "two and their edge (a capsule)");
  write("dot.shp", "<\nname DOT\nradius 0\nnv 1\n0 0 0\n>\n");
  expect_refused(folder, {"reconstruct", "dot.shp"}, 1, "radius above zero");
  write("cut.shp", cube("CUT", 0.1).substr(0, 100));
  expect_refused(folder, {"reconstruct", "cut.shp"}, 1, "cut short");
  write("map.shp", std::string("\0\0\x27\x0a", 4) + std::string(96, '\0'));
  expect_refused(folder, {"reconstruct", "map.shp"}, 1, "ESRI shapefile");
}

TEST_F(Exchange, FoldersGiveTheirShapesAndLeaveMapsAlone) {
  std::filesystem::create_directory(folder / "scans");
  write("scans/rock.shp", cube("ROCK", 0.25));
  write("scans/pair.shp", cube("A", 0.1) + cube("B", 0.1));
  write("scans/cut.shp", cube("CUT", 0.1).substr(0, 100));
  write("scans/map.shp", std::string("\0\0\x27\x0a", 4) + std::string(96, '\0'));
  const ProgramRun run = reconstruct({"scans", "-o", "b.h5"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "cut.shp") && contains(run.err, "1 of 4 scans")) << run.err;
  EXPECT_FALSE(contains(run.err, "map.shp")) << run.err;
  EXPECT_EQ(show_library("b.h5").size(), 3u);
}

TEST_F(Exchange, MeshesAreOfTheAskedSurfaceInTheAskedFrame) {
  write_obj(folder / "concave.obj", l_block());
  ASSERT_EQ(reconstruct({"concave.obj", "-o", "b.h5", "--core", "--radius", "0.2"}).exit_code, 0);
  const auto exported = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all = {"export", "b.h5", "--format", "ply", "-o", "out", "--replace"};
    all.insert(all.end(), options.begin(), options.end());
    const ProgramRun run = run_clast(all, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return read_mesh(folder / "out" / "concave.ply");
  };
  EXPECT_NEAR(enclosed_volume(exported({"--what", "core"})), 3.0, 1e-12);
  EXPECT_EQ(exported({"--what", "surface"}).triangles.size(), l_block().triangles.size());
  const double volume = show_library("b.h5").at("concave")["volume_m3"];
  const TriangleMesh skin = exported({}), fine = exported({"--segments", "8"});
  EXPECT_TRUE(inspect_mesh(skin).is_closed() && inspect_mesh(skin).is_oriented());
  EXPECT_TRUE(find_self_intersections(skin).empty());
  EXPECT_NEAR(enclosed_volume(skin), volume, 0.01 * volume);
  EXPECT_NEAR(enclosed_volume(fine), volume, 0.0025 * volume);
  const TriangleMesh own = exported({"--what", "core", "--frame", "principal"});
  const Bounds box = bounds(own);
  EXPECT_LT(box.low.maxCoeff(), 0.0);  // the centre of mass lies in the block
  EXPECT_GT(box.high.minCoeff(), 0.0);
  EXPECT_NEAR(enclosed_volume(own), 3.0, 1e-12);
}

// The wrap of a concave block has no triangles shorter than 1/150 of its diagonal, sqrt(9) m here:
// a piece of a quarter turn of 0.02 m is 0.02 m at one and a half segments.
TEST_F(Exchange, SegmentsThatChangeNothingAreReported) {
  write_obj(folder / "concave.obj", l_block());
  write_obj(folder / "convex.obj", box_mesh({2, 2, 1}));
  ASSERT_EQ(reconstruct({"concave.obj", "convex.obj", "-o", "b.h5", "--core", "--radius", "0.02"})
                .exit_code,
            0);
  const auto exported = [&](const std::string& id, const std::string& segments) {
    const ProgramRun run = run_clast(
        {"export", "b.h5", id, "--format", "ply", "-o", "out", "--replace", "--segments", segments},
        folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return std::pair(run.err, read_mesh(folder / "out" / (id + ".ply")));
  };
  const auto [said, many] = exported("concave", "16");
  EXPECT_TRUE(contains(said,
                       "block concave is concave: its skin is wrapped in triangles of 0.02 m, "
                       "the shortest allowed (1/150 of its diagonal), so --segments 16 "
                       "gives the same skin as 2"));
  const auto [silent, few] = exported("concave", "2");
  EXPECT_EQ(silent, "");
  EXPECT_EQ(few.vertices, many.vertices) << "what was said is so";
  const auto [coarse_said, coarse] = exported("concave", "1");
  EXPECT_EQ(coarse_said, "");
  EXPECT_LT(coarse.triangles.size(), few.triangles.size());
  const auto [convex_said, fine] = exported("convex", "16");
  EXPECT_EQ(convex_said, "");
  EXPECT_GT(fine.triangles.size(), 4 * exported("convex", "4").second.triangles.size());
  // Without the option no number was requested.
  EXPECT_EQ(
      run_clast({"export", "b.h5", "--format", "ply", "-o", "out", "--replace"}, folder.path()).err,
      "");
}

}  // namespace
}  // namespace clast
