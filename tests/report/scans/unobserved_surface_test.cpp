#include "report/scans/unobserved_surface.hpp"

#include <gtest/gtest.h>

#include "mesh/geodesic_sphere.hpp"

namespace clast::report_detail {
namespace {

FieldBlock sphere_block() {
  FieldBlock block;
  block.scan.mesh = geodesic_sphere(6);
  return block;
}

TEST(UnobservedSurface, OfABlockOfADepositIsItsEstimatedSide) {
  FieldBlock block = sphere_block();
  block.in_deposit.emplace();
  for (const Vec3& v : block.scan.mesh.vertices) {
    block.in_deposit->is_observed.push_back(v.z() > 0.0);
  }
  UnobservedSurface unobserved(block, {});
  for (std::uint32_t t = 0; t < block.scan.mesh.triangles.size(); ++t) {
    int above = 0;
    for (const std::uint32_t corner : block.scan.mesh.triangles[t]) {
      above += block.scan.mesh.vertices[corner].z() > 0.0;
    }
    EXPECT_EQ(unobserved.contains(t), above < 2) << t;
  }
  EXPECT_FALSE(unobserved.contains(Vec3(0.3, 0.2, 1.1)));
  EXPECT_TRUE(unobserved.contains(Vec3(0.3, 0.2, -0.9)));
}

TEST(UnobservedSurface, OfAClosedMeshIsFarFromTheScan) {
  const FieldBlock block = sphere_block();
  TriangleMesh read = block.scan.mesh;
  std::erase_if(read.triangles,
                [&](const TriangleMesh::Triangle& t) { return read.vertices[t[0]].z() < -0.5; });
  UnobservedSurface unobserved(block, read);
  EXPECT_TRUE(unobserved.contains(Vec3(0.0, 0.0, -1.0)));
  EXPECT_FALSE(unobserved.contains(Vec3(0.0, 0.0, 1.0)));
  // Without triangles, nothing is known of the scan.
  UnobservedSurface unknown(block, {});
  EXPECT_FALSE(unknown.contains(Vec3(0.0, 0.0, -1.0)));
}

}  // namespace
}  // namespace clast::report_detail
