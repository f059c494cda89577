#include "particles/convex_parts.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"
#include "core/random.hpp"
#include "mesh/plane.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_tree.hpp"
#include "samples/rock_shapes.hpp"
#include "tests/library/block_samples.hpp"

namespace clast {
namespace {

TriangleMesh notched_rock(std::uint64_t seed) {
  return rock({.name = "rock", .notch = 0.5, .frequency = 6, .seed = seed});
}

/// Height of a point above the faces of a part; negative inside.
double height_above(const TriangleMesh& part, const Vec3& point) {
  double height = -std::numeric_limits<double>::infinity();
  for (const auto& triangle : part.triangles) {
    const Vec3 area = doubled_area_vector(part, triangle);
    if (area.norm() < 1e-7) continue;  // its normal is rounding
    height = std::max(height, area.normalized().dot(point - part.vertices[triangle[0]]));
  }
  return height;
}

TEST(ConvexParts, HaveAtMostTheVerticesAskedForAndContainTheirShares) {
  const TriangleMesh mesh = notched_rock(1);
  const ConvexParts free = split_into_convex_parts(mesh, {.added_volume = 1e-4, .max_parts = 4});
  const ConvexParts few =
      split_into_convex_parts(mesh, {.added_volume = 1e-4, .max_parts = 4, .max_vertices = 24});
  EXPECT_GT(few.added_volume, free.added_volume);
  for (const TriangleMesh& part : few.parts) EXPECT_LE(part.vertices.size(), 24u);
  for (const Vec3& vertex : mesh.vertices) {
    double nearest = std::numeric_limits<double>::infinity();
    int inside = 0;
    for (const TriangleMesh& part : few.parts) {
      const double height = height_above(part, vertex);
      nearest = std::min(nearest, height);
      inside += height < -1e-9;
    }
    EXPECT_LE(nearest, 1e-9);
    EXPECT_LE(inside, 1);
  }
}

TEST(ConvexParts, OfAConvexBodyAreTheBody) {
  const ConvexParts parts = split_into_convex_parts(cuboid(3.0, 2.0, 1.0));
  ASSERT_EQ(parts.parts.size(), 1u);
  EXPECT_NEAR(signed_volume(parts.parts[0]), 6.0, 1e-12);
  EXPECT_NEAR(parts.added_volume, 0.0, 1e-12);
}

TEST(ConvexParts, CoverTheBodyAndDoNotOverlap) {
  for (std::uint64_t seed = 1; seed < 3; ++seed) {
    const TriangleMesh mesh = notched_rock(seed);
    const ConvexParts parts = split_into_convex_parts(mesh, {.added_volume = 1e-4, .max_parts = 6});
    const TriangleTree tree(mesh);
    const Bounds box = bounds(mesh);
    Random random(seed);
    double added = -signed_volume(mesh);
    for (const TriangleMesh& part : parts.parts) added += signed_volume(part);
    EXPECT_NEAR(added / signed_volume(mesh), parts.added_volume, 1e-9);
    for (int i = 0; i < 4000; ++i) {
      const Vec3 share(random.uniform(), random.uniform(), random.uniform());
      const Vec3 point = box.low + share.cwiseProduct(box.high - box.low);
      double nearest = std::numeric_limits<double>::infinity();
      int inside = 0;
      for (const TriangleMesh& part : parts.parts) {
        const double height = height_above(part, point);
        nearest = std::min(nearest, height);
        inside += height < -1e-9;
      }
      EXPECT_LE(inside, 1);
      if (tree.signed_distance(point) < 0.0) {
        EXPECT_LT(nearest, 1e-9);
      }
    }
    for (const Vec3& vertex : mesh.vertices) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const TriangleMesh& part : parts.parts) {
        nearest = std::min(nearest, height_above(part, vertex));
      }
      EXPECT_LT(nearest, 1e-9);
    }
  }
}

TEST(ConvexParts, MorePartsAddLess) {
  const TriangleMesh mesh = notched_rock(7);
  double last = 1.0;
  for (const std::size_t count : {1u, 3u, 8u}) {
    const ConvexParts parts =
        split_into_convex_parts(mesh, {.added_volume = 1e-6, .max_parts = count});
    EXPECT_EQ(parts.parts.size(), count);
    EXPECT_LT(parts.added_volume, last);
    last = parts.added_volume;
  }
}

TEST(ConvexParts, DivisionEndsAtTheErrorAskedFor) {
  const ConvexParts parts =
      split_into_convex_parts(notched_rock(7), {.added_volume = 0.05, .max_parts = 100});
  EXPECT_LE(parts.added_volume, 0.05);
  EXPECT_LT(parts.parts.size(), 100u);
}

TEST(ConvexParts, ErrorsOfAHullAreThoseOfItsVolumeAndDepth) {
  // A cuboid with a prism-shaped notch that its hull fills.
  const ParticleBody body = make_particle_body(cuboid(3.0, 2.0, 1.0));
  const ShapeErrors same = measure_part_errors(body, {body.mesh});
  EXPECT_LT(same.volume, 1e-12);
  EXPECT_LT(same.inertia, 1e-12);
  EXPECT_LT(same.surface, 0.01);
  const ShapeErrors larger = measure_part_errors(body, {cuboid(3.0, 2.0, 1.2)});
  EXPECT_NEAR(larger.volume, 0.2, 1e-12);
  EXPECT_NEAR(larger.surface, 0.1 / 3.0, 2e-3);
}

TEST(ConvexParts, OpenMeshesAndInvalidOptionsAreRefused) {
  TriangleMesh open = cuboid(1.0, 1.0, 1.0);
  open.triangles.pop_back();
  EXPECT_THROW(split_into_convex_parts(open), GeometryError);
  EXPECT_THROW(split_into_convex_parts(cuboid(1, 1, 1), {.max_parts = 0}), InputError);
  EXPECT_THROW(split_into_convex_parts(cuboid(1, 1, 1), {.added_volume = 0.0}), InputError);
}

}  // namespace
}  // namespace clast
