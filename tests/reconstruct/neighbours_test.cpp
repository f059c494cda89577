/// Scans of a block that touches its neighbour.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "reconstruct/field_scan.hpp"
#include "tests/support/field_scene.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

/// Points of each ball: so many that its surface is reconstructed with all detail, or that it is
/// estimated as a block of a deposit.
constexpr int kDense = 13000, kSparse = 3000;

/// Points of a ball of 0.5 m that touches a smaller one, with 2 cm of both in the ground.
std::vector<Vec3> balls_that_touch(double radius, std::uint64_t seed, int per_block) {
  const FieldGround ground(0.0, 0.002, 0, 1.5, seed);
  const double up = radius - 0.5, reach = 0.49 + radius;
  const double away = std::sqrt(reach * reach - up * up), turn = static_cast<double>(seed);
  TriangleMesh first = geodesic_sphere(40), second = first;
  for (Vec3& v : first.vertices) v = 0.5 * v + Vec3(0.0, 0.0, 0.48);
  for (Vec3& v : second.vertices) {
    v = radius * v + Vec3(away * std::cos(turn), away * std::sin(turn), 0.48 + up);
  }
  return field_scene({first, second}, ground,
                     {.per_block = per_block, .ground = 2 * per_block, .noise = 0.001, .half = 1.5},
                     seed)
      .points;
}

TEST(Neighbours, OfSparselyScannedBlocksAreBlocksOfTheirOwn) {
  std::uint64_t seed = 1;
  for (const double radius : {0.18, 0.25, 0.35, 0.45}) {
    const FieldBlock block =
        extract_field_blocks(balls_that_touch(radius, seed++, kSparse), "balls")[0];
    const double ball = 4.0 / 3.0 * kPi * 0.125;
    ASSERT_TRUE(block.bounds && block.bounds->sides) << radius;
    EXPECT_NEAR(signed_volume(block.scan.mesh), ball, 0.1 * ball) << radius;
    EXPECT_LE(block.bounds->sides->lower.maxCoeff(), 1.0) << radius;
    EXPECT_GE(block.bounds->sides->upper.minCoeff(), 1.0) << radius;
  }
}

TEST(Neighbours, OfADenselyScannedBlockLowerTheLowerBoundsIfTheyAreSmall) {
  const double ball = 4.0 / 3.0 * kPi * 0.125;
  const FieldBlock block = extract_field_blocks(balls_that_touch(0.14, 2, kDense), "balls")[0];
  ASSERT_TRUE(block.bounds && block.bounds->sides);
  EXPECT_LE(block.bounds->lower_volume, ball);
  EXPECT_GE(block.bounds->upper_volume.value(), ball);
  EXPECT_LE(block.bounds->sides->lower.maxCoeff(), 1.0);
  EXPECT_GE(block.bounds->sides->upper.minCoeff(), 1.0);
  const std::vector<std::string>& notes = block.scan.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.starts_with("a smaller body with ");
  }));
}

TEST(Neighbours, OfADenselyScannedBlockAreRefusedIfTheyAreLarge) {
  EXPECT_TRUE(contains(refusal<GeometryError>([&] {
                         extract_field_blocks(balls_that_touch(0.35, 5, kDense), "balls");
                       }),
                       "that touch"));
}

}  // namespace
}  // namespace clast
