/// Real scans all the way to rounded blocks.
#include <gtest/gtest.h>

#include "mesh/self_intersection.hpp"
#include "reconstruct/scan.hpp"
#include "reconstruct/simplify.hpp"
#include "shapes/rounding.hpp"
#include "shapes/surface_deviation.hpp"
#include "tests/reconstruct/reference_meshes.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

/// Thinned to 250 vertices and rounded by 2 % and 5 % of the smallest bounding side, as a default
/// block would be.
TEST(RealBlocks, BecomeRoundedBlocksCloseToTheScan) {
  for (auto& [file, row] : reference()) {
    if (row["kind"] != "mesh" || row["trimesh_watertight"] != "True") continue;
    SCOPED_TRACE(file);
    const TriangleMesh scan = read_scan(data_file("meshes/" + file)).mesh;
    const bool porous = row["euler"] != "2";
    // Tunnels need vertices to stay open.
    const std::size_t most = porous ? 320 : 250;
    const TriangleMesh thin = simplify_mesh(scan, {.target_vertices = most});
    EXPECT_LE(thin.vertices.size(), most);
    EXPECT_TRUE(find_self_intersections(thin).empty());
    EXPECT_NEAR(enclosed_volume(thin) / enclosed_volume(scan), 1.0, 1e-3);
    const double longest = std::stod(row["L1"]), shortest = std::stod(row["L3"]);
    // Walls between tunnels are thinner than two larger radii.
    for (const double share : porous ? std::vector{0.02} : std::vector{0.02, 0.05}) {
      const SpheroPolyhedron body = inset_core(thin, share * shortest);
      const TriangleMesh core = core_mesh(body);
      EXPECT_TRUE(inspect_mesh(core).is_closed() && inspect_mesh(core).is_oriented());
      EXPECT_TRUE(find_self_intersections(core).empty());
      const SurfaceDeviation deviation = measure_surface_deviation(thin, body, {.samples = 5000});
      // What a ball can't reach: about 0.7 r at a right corner, whole tunnels of the porous stone.
      EXPECT_LT(deviation.hausdorff, porous ? 0.05 * longest : 1.25 * body.radius);
      EXPECT_LT(deviation.mean, 0.003 * longest);
    }
  }
}

}  // namespace
}  // namespace clast
