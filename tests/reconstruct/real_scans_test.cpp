/// Real scans: the closed ones become blocks with their published volume, the others are refused
/// with a reason.
#include <gtest/gtest.h>

#include <map>

#include "core/error.hpp"
#include "reconstruct/scan.hpp"
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
    const MeshReport report = inspect(scan.mesh);
    EXPECT_TRUE(report.closed() && report.oriented()) << report.summary();
    EXPECT_EQ(report.components, 1u);
    EXPECT_EQ(report.pinched_vertices, 0u);
    EXPECT_EQ(scan.as_read.vertices, std::stoul(row["vertices_welded"]));
    EXPECT_EQ(scan.as_read.triangles, std::stoul(row["faces_welded"]));
    const bool pieces = row["components"] != "1";
    const double expected = std::stod(row[pieces ? "largest_component_volume" : "volume"]);
    // The reference of the text PLY was computed from its numbers rounded to floats.
    EXPECT_NEAR(enclosed_volume(scan.mesh) / expected, 1.0, file.ends_with(".ply") ? 1e-8 : 1e-10);
    if (pieces) {
      // The reference counts fourteen shells; one of them is a scrap that is not inside.
      const double bubbles = expected - std::stod(row["volume"]);
      EXPECT_NEAR(scan.inner_shell_volume / bubbles, 1.0, 1e-4);
    }
    ++checked;
  }
  EXPECT_GE(checked, 10u);
}

TEST(RealScans, OpenOrNonManifoldOnesAreRefusedWithAReason) {
  const std::map<std::string, std::string> reasons = {
      {"eesd_iphone_lidar.stl", "88 open edges in"},
      {"ibois_landscape.ply", "274 open edges in"},
      {"rockable_rock.stl", "7 edges shared by more than two triangles"}};
  for (const auto& [file, reason] : reasons) {
    try {
      read_scan(data_file("meshes/" + file));
      ADD_FAILURE() << file << " was not refused";
    } catch (const GeometryError& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
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
    const MeshReport report = inspect(scan.mesh);
    EXPECT_TRUE(report.closed() && report.oriented()) << report.summary();
    EXPECT_EQ(report.euler_characteristic, 2);
    EXPECT_GT(enclosed_volume(scan.mesh), 0.0);
    if (name == "SP1A") {
      EXPECT_EQ(scan.as_read.boundary_edges, 3u);
      ASSERT_EQ(scan.notes.size(), 1u);
      EXPECT_NE(scan.notes[0].find("closed by a fan"), std::string::npos);
    } else {
      EXPECT_TRUE(scan.notes.empty());
    }
  }
}

}  // namespace
}  // namespace clast
