#include "massprops/mass_properties.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "massprops/principal_frame.hpp"

namespace clast {
namespace {

MassProperties with_inertia(const Mat3& inertia) {
  MassProperties properties;
  properties.volume = 1.0;
  properties.mass = 1.0;
  properties.inertia = inertia;
  return properties;
}

TEST(PrincipalFrame, AscendingRightHandedAndDiagonalizing) {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    // Semi-axes of an ellipsoid give moments that a solid can have.
    const Vec3 axes(random.uniform(0.1, 1.0), random.uniform(0.1, 1.0), random.uniform(0.1, 1.0));
    const Vec3 squares = axes.cwiseProduct(axes);
    const Vec3 moments = (Vec3::Constant(squares.sum()) - squares) / 5.0;
    const Mat3 turn = random.rotation().toRotationMatrix();
    const Mat3 inertia = turn * moments.asDiagonal() * turn.transpose();
    const PrincipalFrame frame = principal_frame(with_inertia(inertia));

    EXPECT_LE(frame.moments[0], frame.moments[1]);
    EXPECT_LE(frame.moments[1], frame.moments[2]);
    const Mat3 columns = frame.rotation.toRotationMatrix();
    EXPECT_NEAR(columns.determinant(), 1.0, 1e-14);
    EXPECT_TRUE(
        (columns * frame.moments.asDiagonal() * columns.transpose()).isApprox(inertia, 1e-13));
    for (int axis = 0; axis < 2; ++axis) {
      Eigen::Index largest = 0;
      columns.col(axis).cwiseAbs().maxCoeff(&largest);
      EXPECT_GT(columns(largest, axis), 0.0);
    }
  }
}

TEST(PrincipalFrame, EqualMomentsAreSaidToBeSo) {
  EXPECT_TRUE(
      principal_frame(with_inertia(Vec3(1.0, 1.0, 1.5).asDiagonal())).has_near_equal_moments);
  EXPECT_TRUE(principal_frame(with_inertia(Vec3(1.0, 1.5, 1.5 + 1e-7).asDiagonal()))
                  .has_near_equal_moments);
  EXPECT_FALSE(
      principal_frame(with_inertia(Vec3(1.0, 1.2, 1.5).asDiagonal())).has_near_equal_moments);
}

TEST(PrincipalFrame, MomentsThatTheStatedErrorCannotTellApartAreNearlyEqual) {
  MassProperties properties = with_inertia(Vec3(1.0, 1.2, 1.2001).asDiagonal());
  EXPECT_FALSE(principal_frame(properties).has_near_equal_moments);
  properties.relative_error = 1e-4;
  EXPECT_TRUE(principal_frame(properties).has_near_equal_moments);
}

// Noise far below the moments must not choose the axes between equal ones.
TEST(PrincipalFrame, AxesBetweenEqualMomentsFollowTheSourceAndNotRounding) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Mat3 turn = random.rotation().toRotationMatrix();
    for (const Vec3& moments : {Vec3(1, 1, 1), Vec3(1, 1, 1.5), Vec3(1, 1.5, 1.5)}) {
      const bool all = moments[2] == moments[0], oblate = moments[1] == moments[0];
      Mat3 inertia = turn * moments.asDiagonal() * turn.transpose();
      Mat3 noise = Mat3::NullaryExpr([&] { return 1e-9 * random.normal(); });
      noise = (noise + noise.transpose()).eval();
      const PrincipalFrame frame = principal_frame(with_inertia(inertia));
      const PrincipalFrame noisy = principal_frame(with_inertia(inertia + noise));
      EXPECT_TRUE(frame.has_near_equal_moments && noisy.has_near_equal_moments);
      EXPECT_LT(frame.rotation.angularDistance(noisy.rotation), 1e-7);
      const Mat3 axes = frame.rotation.toRotationMatrix();
      EXPECT_TRUE((axes * frame.moments.asDiagonal() * axes.transpose()).isApprox(inertia, 2e-6));
      if (all) {
        EXPECT_TRUE(axes.isIdentity(1e-15));
        continue;
      }
      const Vec3 single = turn.col(oblate ? 2 : 0);
      EXPECT_NEAR(std::abs(axes.col(oblate ? 2 : 0).dot(single)), 1.0, 1e-12);
      // The plane through that axis and the source's x (or y) holds the axis set by convention.
      const Vec3 source = std::abs(single.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
      EXPECT_NEAR(axes.col(oblate ? 0 : 1).dot(single.cross(source)), 0.0, 1e-12);
    }
  }
}

TEST(PrincipalFrame, TensorsThatNoSolidHasAreRefused) {
  EXPECT_THROW(principal_frame(with_inertia(Vec3(-1.0, 1.0, 1.0).asDiagonal())), GeometryError);
  EXPECT_THROW(principal_frame(with_inertia(Vec3(0.0, 1.0, 1.0).asDiagonal())), GeometryError);
  EXPECT_THROW(principal_frame(with_inertia(Vec3(1.0, 1.0, 2.001).asDiagonal())), GeometryError);
  EXPECT_THROW(principal_frame(with_inertia(Mat3::Constant(std::nan("")))), GeometryError);
  // A thin plate reaches the limit, and is a solid.
  EXPECT_NO_THROW(principal_frame(with_inertia(Vec3(1.0, 1.0, 2.0).asDiagonal())));
}

}  // namespace
}  // namespace clast
