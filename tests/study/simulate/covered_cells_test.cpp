// Heights of a block over the cells of a plan grid.
#include "study/simulate/detail/covered_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/support/test_rock.hpp"

namespace clast {
namespace {

using namespace study_detail;

TEST(CoveredCells, OfAnUprightBoxAreItsOutlineAndItsFaces) {
  const TriangleMesh core = core_mesh(box(1.0, {1.0, 0.5, 0.4}).shape);
  Pose place;
  place.translation = {0.125, 2.125, 3.0};
  std::size_t count = 0;
  for (const CoveredCell& cell : compute_covered_cells(core, 0.0, place, 0.25)) {
    EXPECT_NEAR(cell.lowest, 2.8, 1e-12);
    EXPECT_NEAR(cell.highest, 3.2, 1e-12);
    EXPECT_TRUE(cell.i >= -2 && cell.i <= 2) << cell.i;
    EXPECT_TRUE(cell.j >= 7 && cell.j <= 9) << cell.j;
    ++count;
  }
  EXPECT_EQ(count, 15u);
}

// No point of the skin is beyond the bounds of its cell, and bounds are no farther off than the
// radius and what the surface falls in the radius around the cell.
TEST(CoveredCells, BoundEveryPointOfARoundedRock) {
  const RigidBody body = rock(4, {0.5, 0.4, 0.3}, 0.03, 2700.0, 5);
  const double width = 0.05;
  Random random(3);
  for (int turn = 0; turn < 5; ++turn) {
    Pose place;
    place.translation = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
    place.rotation = random.rotation();
    std::map<std::pair<std::int64_t, std::int64_t>, CoveredCell> cells;
    for (const CoveredCell& cell :
         compute_covered_cells(core_mesh(body.shape), body.shape.radius, place, width)) {
      cells[{cell.i, cell.j}] = cell;
    }
    double reached = -1e300, bound = -1e300;
    const TriangleMesh skin = transformed(rounded_surface_mesh(body.shape, 6), place);
    for (const TriangleMesh::Triangle& triangle : skin.triangles) {
      for (int sample = 0; sample < 20; ++sample) {
        const double a = random.uniform(), b = random.uniform() * (1.0 - a);
        const Vec3 p = a * skin.vertices[triangle[0]] + b * skin.vertices[triangle[1]] +
                       (1.0 - a - b) * skin.vertices[triangle[2]];
        const auto cell = cells.find({static_cast<std::int64_t>(std::floor(p.x() / width)),
                                      static_cast<std::int64_t>(std::floor(p.y() / width))});
        ASSERT_NE(cell, cells.end());
        EXPECT_GE(p.z(), cell->second.lowest);
        EXPECT_LE(p.z(), cell->second.highest);
        reached = std::max(reached, p.z());
      }
    }
    for (const auto& [key, cell] : cells) bound = std::max(bound, cell.highest);
    EXPECT_NEAR(bound, reached, 0.01);  // the top is the top
  }
}

}  // namespace
}  // namespace clast
