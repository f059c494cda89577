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

/// Points of a ball of 0.5 m that touches a smaller one, with 2 cm of both in the ground.
std::vector<Vec3> balls_that_touch(double radius, std::uint64_t seed) {
  const FieldGround ground(0.0, 0.002, 0, 1.5, seed);
  const double up = radius - 0.5, reach = 0.49 + radius;
  const double away = std::sqrt(reach * reach - up * up), turn = static_cast<double>(seed);
  TriangleMesh first = geodesic_sphere(40), second = first;
  for (Vec3& v : first.vertices) v = 0.5 * v + Vec3(0.0, 0.0, 0.48);
  for (Vec3& v : second.vertices) {
    v = radius * v + Vec3(away * std::cos(turn), away * std::sin(turn), 0.48 + up);
  }
  return field_scene({first, second}, ground,
                     {.per_block = 6000, .ground = 12000, .noise = 0.001, .half = 1.5}, seed)
      .points;
}

TEST(Neighbours, ThatAreSmallLowerTheLowerBounds) {
  const double ball = 4.0 / 3.0 * kPi * 0.125;
  std::uint64_t seed = 1;
  for (const double radius : {0.1, 0.14, 0.18}) {
    const FieldBlock block = extract_field_blocks(balls_that_touch(radius, seed++), "balls")[0];
    ASSERT_TRUE(block.bounds && block.bounds->sides) << radius;
    EXPECT_LE(block.bounds->lower_volume, ball) << radius;
    EXPECT_GE(block.bounds->upper_volume.value(), ball) << radius;
    EXPECT_LE(block.bounds->sides->lower.maxCoeff(), 1.0) << radius;
    EXPECT_GE(block.bounds->sides->upper.minCoeff(), 1.0) << radius;
    const std::vector<std::string>& notes = block.scan.notes;
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return note.starts_with("a smaller body with ");
    })) << radius;
  }
}

TEST(Neighbours, ThatAreLargeAreRefused) {
  std::uint64_t seed = 4;
  for (const double radius : {0.25, 0.35, 0.5}) {
    EXPECT_TRUE(contains(refusal<GeometryError>([&] {
                           extract_field_blocks(balls_that_touch(radius, seed++), "balls");
                         }),
                         "two bodies that touch in a seam"))
        << radius;
  }
}

}  // namespace
}  // namespace clast
