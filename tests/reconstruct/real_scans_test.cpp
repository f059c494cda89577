/// Real scans: the closed ones become blocks with their published volume, dirty ones blocks that
/// say what was repaired, and what is no block is refused with a reason.
#include <gtest/gtest.h>

#include <map>

#include "core/error.hpp"
#include "mesh/self_intersection.hpp"
#include "reconstruct/scan.hpp"
#include "reconstruct/simplify.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/reconstruct/reference_meshes.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

TEST(RealScans, EveryClosedMeshIsReadWithItsReferenceVolume) {
  std::size_t checked = 0;
  for (auto& [file, row] : reference()) {
    if (row["kind"] != "mesh" || row["volume_meaningful"] != "True" ||
        row["trimesh_watertight"] != "True") {
      continue;
    }
    SCOPED_TRACE(file);
    const Scan scan = read_scan(data_file("meshes/" + file));
    const MeshReport report = inspect_mesh(scan.mesh);
    EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
    EXPECT_EQ(report.components, 1u);
    EXPECT_EQ(report.pinched_vertices, 0u);
    EXPECT_EQ(scan.report.as_read.vertices, std::stoul(row["vertices_welded"]));
    EXPECT_EQ(scan.report.as_read.triangles, std::stoul(row["faces_welded"]));
    const bool pieces = row["components"] != "1";
    const double expected = std::stod(row[pieces ? "largest_component_volume" : "volume"]);
    // The reference of the text PLY was computed from its numbers rounded to floats.
    EXPECT_NEAR(enclosed_volume(scan.mesh) / expected, 1.0, file.ends_with(".ply") ? 1e-8 : 1e-10);
    if (pieces) {
      // The reference counts fourteen shells; one of them is a scrap that is not inside.
      const double bubbles = expected - std::stod(row["volume"]);
      EXPECT_NEAR(scan.report.inner_shell_volume / bubbles, 1.0, 1e-4);
    }
    ++checked;
  }
  EXPECT_GE(checked, 10u);
}

// At most means at most; where the surface would cross itself, the message says what is enough.
TEST(RealScans, AreSimplifiedToAtMostTheVerticesAskedFor) {
  std::size_t made = 0;
  for (const char* file :
       {"eesd_stone01.stl", "rockable_rock.stl", "eesd_stone15.stl", "chrono_offroad_rock4.obj"}) {
    const Scan scan = read_scan(data_file(std::string("meshes/") + file));
    for (const std::size_t most : {50u, 100u, 150u}) {
      SCOPED_TRACE(std::string(file) + ", " + std::to_string(most));
      try {
        const TriangleMesh light = simplify_mesh(scan.mesh, {.target_vertices = most});
        EXPECT_LE(light.vertices.size(), most);
        EXPECT_TRUE(find_self_intersections(light).empty());
        ++made;
      } catch (const GeometryError& error) {
        const std::string message = error.what();
        const std::size_t at = message.find("request ");
        ASSERT_NE(at, std::string::npos) << message;
        const std::size_t enough = std::stoul(message.substr(at + 8));
        EXPECT_LE(simplify_mesh(scan.mesh, {.target_vertices = enough}).vertices.size(), enough);
      }
    }
  }
  EXPECT_GE(made, 4u);  // of 6: the first scan is full of tunnels
}

void expect_block_with_box(const Scan& scan, std::map<std::string, std::string>& row) {
  const MeshReport report = inspect_mesh(scan.mesh);
  EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.pinched_vertices, 0u);
  EXPECT_TRUE(find_self_intersections(scan.mesh).empty());
  const Vec3 sides = smallest_box(scan.mesh.vertices).lengths;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(sides[axis] / std::stod(row["L" + std::to_string(axis + 1)]), 1.0, 0.02);
  }
}

TEST(RealScans, ARockWithSliversOnItsEdgesKeepsItsVolume) {
  auto row = reference()["rockable_rock.stl"];
  const Scan scan = read_scan(data_file("meshes/rockable_rock.stl"));
  expect_block_with_box(scan, row);
  EXPECT_EQ(scan.report.as_read.non_manifold_edges, std::stoul(row["nonmanifold_edges"]));
  EXPECT_NEAR(enclosed_volume(scan.mesh) / std::stod(row["largest_component_volume"]), 1.0, 1e-6);
  EXPECT_EQ(scan.report.filled_fraction, 0.0);
}

TEST(RealScans, AnOpenPhoneScanBecomesABlockThatSaysWhatWasInvented) {
  auto row = reference()["eesd_iphone_lidar.stl"];
  const Scan scan = read_scan(data_file("meshes/eesd_iphone_lidar.stl"));
  expect_block_with_box(scan, row);
  EXPECT_EQ(scan.report.as_read.boundary_edges, std::stoul(row["boundary_edges"]));
  EXPECT_GT(scan.report.filled_fraction, 0.001);
  EXPECT_LT(scan.report.filled_fraction, 0.05);
  std::string notes;
  for (const std::string& note : scan.notes) notes += note + "\n";
  EXPECT_NE(notes.find("% of the surface was filled without data"), std::string::npos) << notes;
}

TEST(RealScans, GroundAndCloudsAreNoBlocks) {
  try {
    read_scan(data_file("meshes/ibois_landscape.ply"));
    ADD_FAILURE() << "a piece of ground was not refused";
  } catch (const GeometryError& error) {
    const std::string text = error.what();
    for (const char* words : {"ibois_landscape.ply: the surface is an open sheet, not a block",
                              "274 open edges in 2 holes", "clast terrain"}) {
      EXPECT_NE(text.find(words), std::string::npos) << text;
    }
  }
  try {
    read_scan(data_file("meshes/eesd_stone14_points.ply"));
    ADD_FAILURE() << "a point cloud was not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a point cloud with 6741 points"), std::string::npos);
  }
}

TEST(RealScans, AuthumeBlocksAreClosedAndOnlySp1aNeedsATriangle) {
  for (const std::string name : {"SP1A", "SP2A", "SP2B", "SP3A"}) {
    SCOPED_TRACE(name);
    const Scan scan = read_scan(data_file("authume/blocks/" + name + ".stl"));
    const MeshReport report = inspect_mesh(scan.mesh);
    EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
    EXPECT_EQ(report.euler_characteristic, 2);
    EXPECT_GT(enclosed_volume(scan.mesh), 0.0);
    if (name == "SP1A") {
      EXPECT_EQ(scan.report.as_read.boundary_edges, 3u);
      ASSERT_EQ(scan.notes.size(), 2u);
      EXPECT_NE(scan.notes[0].find("closed by a fan"), std::string::npos);
      EXPECT_NE(scan.notes[1].find("% of the surface was filled without data"), std::string::npos);
    } else {
      EXPECT_TRUE(scan.notes.empty());
    }
  }
}

}  // namespace
}  // namespace clast
