#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "massprops/solid.hpp"
#include "reconstruct/weld.hpp"
#include "shapes/mesh_io.hpp"
#include "shapes/mesh_topology.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {
namespace {

/// As the reference values were made: equal vertices joined, turned outward; coordinates that a
/// .ply declares as float but writes with more digits rounded to what it declares.
TriangleMesh reference_mesh(const std::string& file) {
  TriangleMesh mesh = read_mesh(test_data("meshes/" + file));
  if (file.ends_with(".ply")) {
    for (Vec3& v : mesh.vertices) {
      for (double& x : v) {
        // volatile: GCC 12 at -O3 drops the rounding of some values where it vectorizes this loop.
        const volatile float rounded = static_cast<float>(x);
        x = rounded;
      }
    }
  }
  mesh = welded(mesh, 1e-12 * bounds(mesh).diagonal());
  if (signed_volume(mesh) < 0.0) {
    for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  }
  return mesh;
}

Mat3 reference_inertia(const ReferenceRow& row) {
  Mat3 j;
  j << value(row, "Jxx"), value(row, "Jxy"), value(row, "Jxz"), value(row, "Jxy"),
      value(row, "Jyy"), value(row, "Jyz"), value(row, "Jxz"), value(row, "Jyz"), value(row, "Jzz");
  return j;
}

TEST(ReferenceMeshes, ClosedOnesMatchAndOpenOnesAreRefused) {
  int matched = 0, refused = 0;
  for (const ReferenceRow& row : mesh_reference()) {
    if (row.at("kind") != "mesh") continue;
    const TriangleMesh mesh = reference_mesh(row.at("file"));
    if (row.at("boundary_edges") != "0" || row.at("nonmanifold_edges") != "0") {
      EXPECT_THROW(solid_mass_properties(mesh, 1.0), GeometryError) << row.at("file");
      ++refused;
      continue;
    }
    SCOPED_TRACE(row.at("file"));
    const MassProperties p = solid_mass_properties(mesh, 1.0);
    const Vec3 centre(value(row, "cx"), value(row, "cy"), value(row, "cz"));
    EXPECT_NEAR(p.volume / value(row, "volume"), 1.0, 1e-10);
    EXPECT_LT((p.centre - centre).norm(), 1e-10 * bounds(mesh).diagonal());
    EXPECT_TRUE(p.inertia.isApprox(reference_inertia(row), 1e-10));
    const PrincipalFrame frame = principal_frame(p);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(frame.moments[i] / value(row, "J" + std::to_string(i + 1)), 1.0, 1e-10);
    }
    ++matched;
  }
  EXPECT_EQ(matched, 11);
  EXPECT_EQ(refused, 3);
}

TEST(ReferenceMeshes, MapCoordinatesCostNoDigits) {
  for (const ReferenceRow& row : mesh_reference()) {
    if (row.at("volume_meaningful") != "True" || row.at("nonmanifold_edges") != "0") continue;
    SCOPED_TRACE(row.at("file"));
    TriangleMesh mesh = reference_mesh(row.at("file"));
    // Doubles near 5e6 are 2^-30 apart: on that grid the shifted mesh is the same mesh.
    for (Vec3& v : mesh.vertices) v = (v * 0x1p30).array().round().matrix() * 0x1p-30;
    TriangleMesh far = mesh;
    for (Vec3& v : far.vertices) v += Vec3(5e6, 5e6, 5e6);
    const MassProperties near = solid_mass_properties(mesh, 1.0);
    const MassProperties shifted = solid_mass_properties(far, 1.0);
    EXPECT_NEAR(shifted.volume / near.volume, 1.0, 1e-10);
    EXPECT_TRUE(shifted.inertia.isApprox(near.inertia, 1e-10));
  }
}

}  // namespace
}  // namespace clast
