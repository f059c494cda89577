#include "classify/box_convention.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "massprops/principal_frame.hpp"
#include "massprops/sphero.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

SpheroPolyhedron cuboid(const Vec3& sides, double radius) {
  return transformed(make_sphero_polyhedron(box_mesh(sides), radius),
                     Pose{Vec3(3, -2, 5), Quat(0.5, -0.3, 0.7, 0.2).normalized()});
}

PrincipalFrame frame_of(const SpheroPolyhedron& body) {
  return principal_frame(convex_sphero_mass_properties(body, 1.0));
}

TEST(BoxConvention, OfARoundedCuboidIsTheCuboidExceptByCallipers) {
  const SpheroPolyhedron body = cuboid(Vec3(3, 2, 1), 0.2);
  const PrincipalFrame frame = frame_of(body);
  for (const BoxConvention convention :
       {BoxConvention::kSmallest, BoxConvention::kInertia, BoxConvention::kPca}) {
    EXPECT_TRUE(
        box_by_convention(body, frame, convention).lengths.isApprox(Vec3(3.4, 2.4, 1.4), 1e-9))
        << name_of(convention);
  }
  EXPECT_NEAR(box_by_convention(body, frame, BoxConvention::kFeret).lengths[0],
              std::sqrt(14.0) + 0.4, 1e-12);
}

// The moments of a cube leave its axes open; the box doesn't depend on which were written down.
TEST(BoxConvention, OfACubeIsTheCubeAlongAnyPrincipalAxes) {
  const SpheroPolyhedron body = cuboid(Vec3(1, 1, 1), 0.1);
  EXPECT_TRUE(box_by_convention(body, frame_of(body), BoxConvention::kInertia)
                  .lengths.isApprox(Vec3::Constant(1.2), 1e-9));
}

// Principal axes of a right-angled wedge are not along its legs.
TEST(BoxConvention, InertiaFollowsTheTensorOfTheSolid) {
  TriangleMesh wedge;
  wedge.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, 0, 1}, {0, 1, 1}};
  wedge.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                     {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  const SpheroPolyhedron body = make_sphero_polyhedron(wedge, 0.0);
  // Second moments of the triangle (0,0), (b,0), (0,h) about its centroid: A b^2/18, A h^2/18, and
  // -A b h/36 across. Its axis of least moment leans by half of atan2(-b h, b^2 - h^2).
  const double lean = 0.5 * std::atan2(-3.0, 9.0 - 1.0);
  const OrientedBox found = box_by_convention(body, frame_of(body), BoxConvention::kInertia);
  EXPECT_NEAR(std::abs(found.axes.col(0).dot(Vec3(std::cos(lean), std::sin(lean), 0.0))), 1.0,
              1e-12);
  EXPECT_NEAR(found.lengths[0], 3.0 * std::cos(lean) - 1.0 * std::sin(lean), 1e-12);
}

TEST(BoxConvention, NamesGoBothWaysAndOthersAreRefused) {
  for (const BoxConvention convention : kBoxConventions) {
    EXPECT_EQ(parse_box_convention(name_of(convention)), convention);
  }
  const std::string said = refusal([] { parse_box_convention("minimal"); });
  EXPECT_TRUE(contains(said, "minimal"));
  for (const BoxConvention convention : kBoxConventions) {
    EXPECT_TRUE(contains(said, name_of(convention)));
  }
}

}  // namespace
}  // namespace clast
