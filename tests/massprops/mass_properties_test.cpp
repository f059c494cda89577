#include "massprops/mass_properties.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"

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
  EXPECT_TRUE(principal_frame(with_inertia(Vec3(1.0, 1.0, 1.5).asDiagonal())).nearly_equal);
  EXPECT_TRUE(principal_frame(with_inertia(Vec3(1.0, 1.5, 1.5 + 1e-7).asDiagonal())).nearly_equal);
  EXPECT_FALSE(principal_frame(with_inertia(Vec3(1.0, 1.2, 1.5).asDiagonal())).nearly_equal);
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
