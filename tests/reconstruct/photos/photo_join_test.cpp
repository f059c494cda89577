/// Two photo sets of one stone that was turned over in between, joined to one block.
#include <gtest/gtest.h>

#include <iostream>

#include "mesh/mesh_io.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/weld.hpp"
#include "reconstruct/joined_scan.hpp"
#include "reconstruct/photos/photo_scan.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/reconstruct/photos/rendered_photos.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

/// A stone whose largest extent is one metre.
TriangleMesh photographed_stone() {
  const TriangleMesh stone = weld_vertices(read_mesh(test_data("meshes/eesd_stone15.stl")), 0.0);
  const Bounds box = bounds(stone);
  return scaled(stone, 1.0 / (box.high - box.low).maxCoeff());
}

TEST(PhotoJoin, TwoSetsOfAStoneThatWasTurnedOverGiveItsVolume) {
  const TriangleMesh stone = photographed_stone();
  const OrientedBox box = smallest_box(stone.vertices);
  Mat3 lying = box.axes.transpose();  // the shortest side is vertical
  if (lying.determinant() < 0.0) lying.row(1) *= -1.0;
  const Quat first(lying);
  const Quat second = Quat(Eigen::AngleAxisd(kPi, Vec3(0.6, 0.8, 0.0))) * first;
  const RenderedPhotosRecipe recipe;
  const ScratchFolder folder;
  Random random(5);
  std::vector<ScanToJoin> scans;
  for (const auto& [name, pose] : {std::pair("top", first), std::pair("bottom", second)}) {
    PhotoRenderer(stone, placed_on_table(stone, pose), recipe).write(folder / name, random);
    PhotoScanOptions options;
    options.scale.marker_side = recipe.marker_side;
    PhotoScan photos = reconstruct_from_photos(folder / name, options);
    EXPECT_NEAR(photos.scale->metres_per_unit / recipe.unit, 1.0, 0.001) << name;
    scans.push_back({name, {std::move(photos.cloud.points), {}}, {.up = "z"}});
  }
  const JoinedScan joined = join_scans(scans, "stone", {}, {.threads = 0});
  const TriangleMesh& mesh = joined.block.scan.mesh;
  const double truth = signed_volume(stone), off = signed_volume(mesh) / truth - 1.0;
  const Vec3 sides = smallest_box(mesh.vertices).lengths.cwiseQuotient(box.lengths) - Vec3::Ones();
  std::cout << "volume " << 100.0 * off << " %, L, I, S " << 100.0 * sides.transpose() << " %\n";
  EXPECT_TRUE(inspect_mesh(mesh).is_closed());
  EXPECT_LT(std::abs(off), 0.02);
  EXPECT_LT(sides.cwiseAbs().maxCoeff(), 0.01);
  EXPECT_FALSE(joined.block.underside);
  ASSERT_TRUE(joined.block.bounds);
  EXPECT_LT(joined.block.bounds->upper_volume.value() - joined.block.bounds->lower_volume,
            0.02 * truth);
}

}  // namespace
}  // namespace clast
